// Closed surfaces that are pinned.
#pragma once

#include "tests/worlds.h"

#include <plait/complex/solid_shapes.h>

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
    const Vec<double> corner{0.5 * side, 0.5 * side, 0.5 * side};
    return boxSurface(-corner, corner);
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
