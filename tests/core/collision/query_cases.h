// Queries that tests ask, and moving simplices that are known to touch.
#pragma once

#include "tests/random.h"

#include <plait/collision/query.h>

#include <vector>

namespace plait::test {

// Of two points, a point and an edge, a point and a triangle, or two edges.
inline Impact touch(const std::vector<MovingVertex>& v, bool edges, double thickness) {
    if (edges) return thickEdgeEdge(v[0], v[1], v[2], v[3], thickness);
    if (v.size() == 4) return thickPointTriangle(v[0], v[1], v[2], v[3], thickness);
    if (v.size() == 3) return thickPointEdge(v[0], v[1], v[2], thickness);
    return thickPointPoint(v[0], v[1], thickness);
}

// Vertices that are at q when t = t0 and go at a speed, exactly: all numbers are short.
inline MovingVertex through(const Vec<double>& q, const Vec<double>& speed, double t0) {
    return {q - t0 * speed, q + (1 - t0) * speed};
}

// A point and a triangle, or two edges, that touch at t0: anywhere on either, at rest, moving
// together, in a plane that they never leave, in a line, without area or length.
inline std::vector<MovingVertex> touching(Random& random, bool edges, double t0, int family) {
    const auto lattice = [&] {
        return Vec<double>{8.0 * (random.below(5) - 2), 8.0 * (random.below(5) - 2),
                           family == 1 ? 0 : 8.0 * (random.below(5) - 2)};
    };
    Vec<double> x[4]{lattice(), lattice(), lattice(), lattice()};
    if (family == 2) x[2] = x[1];
    if (family == 3) x[2] = x[1], x[3] = x[1];
    if (edges) {
        const Vec<double> met = x[0] + (0.25 * random.below(5)) * (x[1] - x[0]);
        const double there[]{0.25, 0.5, 1};
        x[3] = x[2] + (1 / there[random.below(3)]) * (met - x[2]);
    } else {
        const int a = random.below(9), b = random.below(9 - a);
        x[0] = x[1] + (0.125 * a) * (x[2] - x[1]) + (0.125 * b) * (x[3] - x[1]);
    }
    std::vector<MovingVertex> v;
    const Vec<double> together = lattice();
    for (const Vec<double>& p : x) v.push_back(through(p, family == 4 ? together : lattice(), t0));
    return v;
}

}  // namespace plait::test
