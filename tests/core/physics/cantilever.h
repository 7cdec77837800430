// A rod that droops under its own weight, held against the elastica (validation A3).
#pragma once

#include "tests/worlds.h"

#include <plait/sheets/inextensible.h>

namespace plait::test {

struct Droop {
    double drop, reach;  // m
    bool rests;          // no vertex moved any more
};

// A cantilever of 1 m and 1 kg, horizontal where it is clamped, of Gamma = w L^3 / B. The clamp is
// the middle of a first edge that is pinned, so that the angles stand in the middle of what they
// bend. Its links are swept, or held as a sheet's are.
inline Droop cantilever(double gamma, int links, const ScheduleOptions& schedule,
                        bool held = false) {
    const double l = 1 / (links - 0.5);
    World world;
    const Range rod = world.add(chain({.links = links, .from = {-l / 2, 0, 0}, .to = {1, 0, 0}}));
    world.pin({0, 1});
    world.act<Gravity>(GravityOptions{});
    if (held)
        holdSheet(world, rod, {.order = 1});
    else
        world.constrain(linksOf(world), {.name = "stretch", .order = 1});
    world.constrain(curveBendRows(world.complex, rod, world.rest, 9.81 / gamma), {.name = "bend"});
    Solver<double> solver(world, {.schedule = schedule, .damping = 0.3});
    advance(solver, 48);
    for (int i = 0; i < 100 && topSpeed(solver) > 1e-5; ++i) advance(solver, 4);
    const Vec<double> tip = solver.positions().back();
    return {-tip.y, tip.x, topSpeed(solver) <= 1e-5};
}

}  // namespace plait::test
