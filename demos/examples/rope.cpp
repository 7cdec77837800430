// A rope of 1 m between two hands, one of which comes nearer: prints how low it hangs after 6 s.
#include <plait/forces/gravity.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cstdio>

using namespace plait;

int main() {
    World world;
    const Range rope = world.add(chain({.links = 40}), {.density = 0.05});
    world.pin({0});
    world.pin({40}, [](const Vec<double>& start, double t) {
        return start - Vec<double>{0.4 * std::min(t, 1.0), 0, 0};
    });
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, rope), world.rest),
                    {.name = "links", .direct = true});
    world.act<Gravity>(GravityOptions{});

    Solver<float> solver(world, {.schedule = {.substeps = 20}, .damping = 0.1});
    for (int frame = 0; frame < 144; ++frame) solver.frame();
    double lowest = 0;
    for (const Vec<double>& x : solver.positions()) lowest = std::min(lowest, x.y);
    std::printf("%.4f m\n", lowest);
}
