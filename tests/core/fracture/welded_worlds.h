// Welded strips and panes for tests.
#pragma once

#include "tests/core/pieces/piece_worlds.h"

#include <plait/contacts/pieces/piece_contacts.h>
#include <plait/contacts/surface.h>
#include <plait/fracture/weld_set.h>
#include <plait/fracture/welds.h>
#include <plait/patterns/pattern.h>

#include <numeric>

namespace plait::test {

inline constexpr double glass = 2500;  // kg/m^3
inline constexpr double skin = 8e-6;   // m, of contacts; two are within the kerf

inline Shape moved(Shape shape, const Vec<double>& by) {
    for (Vec<double>& x : shape.positions) x += by;
    return shape;
}

inline int addBox(World& world, const Vec<double>& size, const Vec<double>& at, double density) {
    addPiece(world, moved(box(size), at), {.density = density});
    return static_cast<int>(world.pieces.size()) - 1;
}

inline void pinPiece(World& world, int piece) {
    std::vector<int> all(world.pieces[piece].size());
    std::iota(all.begin(), all.end(), world.pieces[piece].first);
    world.pin(std::move(all));
}

inline std::vector<int> addCells(World& world, const Pattern& pattern, const Vec<double>& corner,
                                 double bevel = 0) {
    std::vector<int> pieces;
    for (const Cell& cell : pattern.cells) {
        addPiece(world, moved(prismOf(cell, pattern.pane.thickness, bevel), corner),
                 {.density = glass});
        pieces.push_back(static_cast<int>(world.pieces.size()) - 1);
    }
    return pieces;
}

// One row of cells along x.
inline Pattern row(double length, double width, double thickness, int count) {
    std::vector<PlanePoint> sites;
    for (int i = 0; i < count; ++i) sites.push_back({(i + 0.5) * length / count, width / 2});
    return cut({.width = length, .height = width, .thickness = thickness}, std::move(sites));
}

inline void meetAll(World& world, double friction = 0.4) {
    std::vector<Surface> surfaces;
    constexpr int spare = 4;
    for (const Range& piece : world.pieces)
        surfaces.push_back({.vertices = {piece.first, piece.last - spare},
                            .thickness = skin,
                            .staticFriction = friction,
                            .dynamicFriction = friction});
    meetPieces(world, surfaces);
}

struct Steps {
    int substeps = 8, iterations = 10;

    SolverOptions options() const {
        return {.schedule = {.substeps = substeps,
                             .frameRate = {60, 1},
                             .iterations = iterations,
                             .collisionPasses = iterations}};
    }
};

template <class Real>
long brokenIn(const World& world, const Solver<Real>& solver) {
    const auto holds = holdingOf(world, solver.state());
    return std::count(holds.begin(), holds.end(), 0);
}

template <class Real>
const WeldCounts& weldCounts(const World& world, const Solver<Real>& solver) {
    return dynamic_cast<const WeldSet<Real>&>(solver.set(world.clusters)).counts();
}

}  // namespace plait::test
