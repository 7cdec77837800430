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

// A planar chain of links (m) on hinges of stiffness B over half of both of its links, the first
// clamped and level; `loads` (N) pull down on each link but the first at its far end and beyond.
// The angles below the horizontal of all links but the first that leave no moment at a hinge: by
// Newton's method, from a stiff rod to this one.
inline std::vector<double> hangingAngles(const std::vector<double>& lengths, double stiffness,
                                         const std::vector<double>& loads) {
    const std::size_t n = lengths.size() - 1;
    std::vector<double> angle(n, 0), diagonal(n), residual(n), hinge(n + 1, 0);
    for (std::size_t k = 0; k < n; ++k) hinge[k] = 2 * stiffness / (lengths[k] + lengths[k + 1]);
    double whole = 0;
    for (const double l : lengths) whole += l;
    for (double part = 1e-3 * stiffness / (loads[0] * whole * whole); part < 1.999; part *= 2) {
        const double scale = std::min(part, 1.0);
        for (int round = 0; round < 200; ++round) {
            for (std::size_t k = 0; k < n; ++k) {
                const double before = k > 0 ? angle[k - 1] : 0,
                             behind = k + 1 < n ? angle[k + 1] : angle[k],
                             moment = scale * loads[k] * lengths[k + 1];
                residual[k] = moment * std::cos(angle[k]) - hinge[k] * (angle[k] - before) +
                              hinge[k + 1] * (behind - angle[k]);
                diagonal[k] = hinge[k] + hinge[k + 1] + std::fabs(moment * std::sin(angle[k]));
            }
            for (std::size_t k = 1; k < n; ++k) {
                const double factor = hinge[k] / diagonal[k - 1];
                diagonal[k] -= factor * hinge[k];
                residual[k] += factor * residual[k - 1];
            }
            double change = 0;
            for (std::size_t k = n; k-- > 0;) {
                if (k + 1 < n) residual[k] += hinge[k + 1] * residual[k + 1];
                residual[k] /= diagonal[k];
                angle[k] += residual[k];
                change = std::max(change, std::fabs(residual[k]));
            }
            if (change < 1e-13) break;
        }
    }
    return angle;
}

}  // namespace plait::test
