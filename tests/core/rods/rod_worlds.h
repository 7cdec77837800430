// What tests of rods share.
#pragma once

#include <plait/rods/rod.h>
#include <plait/solver.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace plait::test {

// Evaluations in 1/24 s in `substeps`, and e^(-damping) of all speed lost in a second.
inline SolverOptions stepping(int substeps, double damping = 0, int iterations = 1) {
    SolverOptions options{.sweeps = Sweeps::oneWay,
                          .schedule = {.substeps = substeps, .iterations = iterations}};
    options.damping = 1 - std::exp(-damping / 24);
    return options;
}

template <class Real>
double fastest(const Solver<Real>& solver) {
    double speed = 0;
    for (const Vec<double>& v : solver.velocities()) speed = std::max(speed, length(v));
    return speed;
}

// A line of `links` along x that is clamped in the middle of its first one, at the origin: from
// there it has this length (m).
inline Shape clampedLine(int links, double length = 1) {
    return chain({.links = links, .from = {-length / (2 * links - 1), 0, 0}, .to = {length, 0, 0}});
}

inline void clampStart(World& world, const Rod& rod) {
    world.pin({rod.points.first, rod.points.first + 1});
    if (rod.directors.size() > 0) world.pin({rod.directors.first});
}

}  // namespace plait::test
