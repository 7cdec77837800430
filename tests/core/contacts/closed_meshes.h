// Closed surfaces that are pinned.
#pragma once

#include "tests/worlds.h"

#include <array>

namespace plait::test {

inline Range pinned(World& world, Range range) {
    std::vector<int> all;
    for (int v = range.first; v < range.last; ++v) all.push_back(v);
    world.pin(all);
    return range;
}

// A cube round the origin, of 12 triangles with normals outward; m.
inline Shape cube(double side) {
    Points x;
    for (int i = 0; i < 8; ++i)
        x.push_back(0.5 * side *
                    Vec<double>{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    Simplices cells;
    for (const auto& [a, b, c, d] : {std::array{0, 4, 6, 2},
                                     {1, 3, 7, 5},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 2, 3, 1},
                                     {4, 5, 7, 6}}) {
        cells.triangles.push_back({a, b, c});
        cells.triangles.push_back({a, c, d});
    }
    return {SimplicialComplex(8, cells), x};
}

inline std::vector<std::array<int, 3>> trianglesIn(const World& world, Range range) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < world.complex.count(2); ++t) {
        const auto ids = world.complex.vertices(2, t);
        if (ids[0] >= range.first && ids[2] < range.last)
            triangles.push_back(world.complex.triangle(t));
    }
    return triangles;
}

}  // namespace plait::test
