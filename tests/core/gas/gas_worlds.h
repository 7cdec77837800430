// Balloons that tests of gas begin with.
#pragma once

#include <plait/constraints/volume.h>
#include <plait/gas/hold.h>
#include <plait/sets/sum_set.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <cmath>
#include <memory>

namespace plait::test {

inline SetOptions named(const char* name) { return {.name = name, .importance = 1}; }

// The sum in a set of a solver.
template <class Real>
const SumSet<Volume, Real>& sumOf(const Solver<Real>& solver, int set) {
    return dynamic_cast<const SumSet<Volume, Real>&>(solver.set(set));
}
// Its multiplier as a pressure, Pa.
template <class Real>
double pressureOf(const Solver<Real>& solver, int set) {
    const double h = solver.substepLength();
    return sumOf(solver, set).multiplier(0) / (h * h);
}

// A ball that nothing moves but what a test tells it to.
inline Range addBall(World& world, double radius, int subdivisions = 2, Vec<double> centre = {},
                     double density = 1) {
    return world.add(sphere({.subdivisions = subdivisions, .radius = radius}, {.origin = centre}),
                     {.density = density});
}

// All of its vertices go as `scale`(t) times where they started from `centre`.
template <class Scale>
void pinScaled(World& world, Range ball, const Vec<double>& centre, const Scale& scale) {
    world.pin(world.select(ball, [](const auto&) { return true; }),
              Motion([=](const Vec<double>& start, double t) {
                  return centre + scale(t) * (start - centre);
              }));
}

// Springs along the edges, one k (N/m) for all: 1.1 % stiffer than the sphere of springs (A9).
inline void addSprings(World& world, Range ball, double k, double damping = 0) {
    SetOptions options = named("springs");
    options.damping = damping;
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, ball), world.rest, 1 / k),
                    options);
}

}  // namespace plait::test
