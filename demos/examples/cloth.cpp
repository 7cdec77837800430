// A cloth of 1 m by 1 m on two pins, in wind that swings: prints how low it hangs after 4 s.
#include <plait/air/air.h>
#include <plait/elementary.h>
#include <plait/forces/gravity.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cstdio>

using namespace plait;

int main() {
    World world;
    const Range cloth =
        world.add(grid({.columns = 24, .rows = 24}, {.up = {0, -1, 0}}), {.density = 0.2});
    world.pin({0, 23});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, cloth), world.rest),
                    {.name = "stretch"});
    world.constrain(bendRows(world.complex, cloth, world.rest, 1e-5), {.name = "bend"});
    world.act<Gravity>(GravityOptions{});
    actAir(world, {.wind = {.velocity = [](double t) { return Vec<double>{0, 0, sine(t)}; }}});

    Solver<float> solver(world, {.schedule = {.substeps = 100}});
    for (int frame = 0; frame < 96; ++frame) solver.frame();
    double lowest = 0;
    for (const Vec<double>& x : solver.positions()) lowest = std::min(lowest, x.y);
    std::printf("%.4f m\n", lowest);
}
