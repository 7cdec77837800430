// The unit spring x'' = -x of Stam 2009, section 4.2, and its methods step by step.
#pragma once

#include "tests/worlds.h"

#include <string>

namespace plait::test {

// 1 kg on an attachment of 1 N/m, let go at rest 1 m from it.
inline World unitSpring() {
    World world = loosePoints({{1, 0, 0}});
    world.constrain(Rows<Attach>{{0}, {{{0, 0, 0}, {0, 0, 0}, 1}}, {}, {}}, {.name = "spring"});
    return world;
}

// Substeps of h seconds, `perFrame` in a frame.
inline SolverOptions steppingBy(double h, Method method, int perFrame = 1) {
    return {.method = method,
            .schedule = {.substeps = perFrame, .frameRate = {1, 1}, .iterations = 1},
            .timeScale = h * perFrame};
}

// Place and velocity along the spring.
struct Phase {
    double x, v;
};
inline Phase phaseOf(const Solver<double>& solver) {
    return {solver.positions()[0].x, solver.velocities()[0].x};
}

}  // namespace plait::test
