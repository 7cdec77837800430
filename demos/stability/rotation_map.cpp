// Rotation in a step, for the method that makes constraints linear where the prediction has them
// (S 5, IN8).
#include "map.h"
#include "watch.h"

#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// A rod of 1 m that falls from horizontal passes the plumb line with this speed, in rad/s.
const double rodSpeed = std::sqrt(-3 * gravity.y);

// A chain of rigid links, 1 m and 1 kg, pinned at one end, falls from horizontal.
Outcome fall(SolverOptions options, int links, double rotation) {
    World world;
    const Vec<double> pin{0, 1.5, 0};
    const Range all =
        world.add(chain({.links = links, .from = pin, .to = {1, pin.y, 0}}), {.density = 1});
    world.pin({0});
    world.act<Gravity>(GravityOptions{.acceleration = gravity});
    const auto rows = restRows<Stretch>(edgeStencils(world.complex, all), world.rest);
    world.constrain(rows, {.name = "links"});
    options.schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = 1};
    options.timeScale = rotation / rodSpeed;  // a frame of a second is a step
    Solver<double> solver(world, options);
    Judge judge(mechanicalEnergy(world, solver), 0.1);
    watch(solver, std::lround(4 / options.timeScale), judge, [&] {
        const auto x = solver.positions();
        double strain = 0;
        for (int i = 0; i < links; ++i)
            strain = std::max(strain, std::fabs(length(x[i + 1] - x[i]) * links - 1));
        return judge.see(mechanicalEnergy(world, solver), strain);
    });
    return judge.outcome();
}

}  // namespace

StabilityMap rotationMap() {
    const auto cell = [](Method method) {
        return [=](double links, double rotation) {
            return fall({.method = method}, static_cast<int>(links), rotation);
        };
    };
    return {.name = "rotation",
            .title = "How far a chain may turn in a step",
            .words =
                "A chain of rigid links, 1 m long, pinned at one end, falls from "
                "horizontal for 4 s. The rotation in a step is that of a rod of 1 m "
                "which passes the plumb line. A strain of 10 % drifts. One step, "
                "one solve: linearised takes all links at once, xpbd sweeps once.",
            .note = "chain that falls from horizontal; drifting: a link 10 % wrong",
            .theoryWords =
                "linearised knows the tension of the last step only: waves "
                "across the chain are stable up to 4 g (N h)^2 / L = 4/3, "
                "which is a rotation of 1/N",
            .x = {"links", 2, 32, true},
            .y = {"rotation in a step [rad]", 0.005, 2},
            .fails = Outcome::drifting,
            .boundaryAt = {8, 16, 32},
            .panels = {{"linearised", cell(Method::linearised),
                        [](double links) { return 1 / links; }, true},
                       {"xpbd", cell(Method::xpbd)}}};
}

}  // namespace plait
