// Worlds in which matter meets matter.
#pragma once

#include "tests/worlds.h"

#include <plait/contacts/matter/contact_set.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/numbers/elementary.h>
#include <plait/sheets/inextensible.h>

#include <cmath>

namespace plait::test {

// A pinned square of two triangles through the origin, that slopes down along x; in m.
inline Range addSlope(World& world, double angle, double size = 20) {
    const Vec<double> along{std::cos(angle), -std::sin(angle), 0};
    const Range slope = world.add(grid({.width = size, .height = size},
                                       {.origin = -0.5 * size * along + Vec<double>{0, 0, size / 2},
                                        .across = along,
                                        .up = {0, 0, -1}}));
    world.pin({slope.first, slope.first + 1, slope.first + 2, slope.first + 3});
    return slope;
}

// A point without links, kg and m/s.
inline Range addPoint(World& world, const Vec<double>& at, double mass = 1,
                      const Vec<double>& velocity = {}) {
    return world.add({SimplicialComplex(1), {at}}, {.density = mass, .velocity = {velocity}});
}

// A cube of 0.1 m and 1 kg that stands on a slope as addSlope makes it, `above` it (m).
inline Range addCube(World& world, double angle, double above) {
    const Vec<double> along{std::cos(angle), -std::sin(angle), 0}, up{along.y * -1, along.x, 0};
    const Range cube = world.add(block({.width = 0.1, .height = 0.1, .depth = 0.1},
                                       {.origin = above * up, .across = along, .up = up}),
                                 {.density = 1000});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, cube), world.rest),
                    {.name = "cube", .importance = 240});
    return cube;
}

inline SolverOptions meeting(int substeps, int passes = 2, int threads = 1) {
    SolverOptions options;
    options.schedule = {.substeps = substeps, .iterations = passes, .collisionPasses = passes};
    options.threads = threads;
    return options;
}

// The last set that was added.
template <class Real>
const ContactCounts& countsOf(const Solver<Real>& solver, const World& world) {
    const int last = static_cast<int>(world.sets.size()) - 1;
    return static_cast<const ContactSet<Real>&>(solver.set(last)).counts();
}

inline std::vector<std::array<int, 3>> trianglesOf(const World& world) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < world.complex.count(2); ++t) triangles.push_back(world.complex.triangle(t));
    return triangles;
}

inline Vec<double> meanOf(const Points& x, Range range) {
    Vec<double> sum{};
    for (int v = range.first; v < range.last; ++v) sum += x[v];
    return (1.0 / range.size()) * sum;
}

}  // namespace plait::test
