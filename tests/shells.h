// Sheets of no regular mesh.
#pragma once

#include "random.h"

#include <plait/complex/shapes.h>

#include <algorithm>
#include <cmath>

namespace plait::test {

// The links of a flat sheet of columns x rows vertices, in disorder: jittered places, diagonals
// turned either way, links in any order and direction.
struct Shell {
    std::vector<Vec<double>> rest;
    std::vector<int> links;
};

inline Shell shellOf(int columns, int rows, std::uint64_t seed) {
    Random random(seed);
    Shell shell{grid({.columns = columns, .rows = rows}).positions, {}};
    const double jitter = 0.3 / std::max(columns, rows);
    for (Vec<double>& x : shell.rest)
        x += Vec<double>{random.uniform(-jitter, jitter), random.uniform(-jitter, jitter), 0};
    std::vector<std::pair<int, int>> pairs;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const int v = r * columns + c;
            const bool right = c + 1 < columns, below = r + 1 < rows;
            if (right) pairs.emplace_back(v, v + 1);
            if (below) pairs.emplace_back(v, v + columns);
            if (right && below)
                random.below(2) ? pairs.emplace_back(v, v + columns + 1)
                                : pairs.emplace_back(v + 1, v + columns);
        }
    for (std::size_t i = pairs.size(); i-- > 1;)
        std::swap(pairs[i], pairs[random.below(static_cast<int>(i) + 1)]);
    for (auto [a, b] : pairs) {
        if (random.below(2)) std::swap(a, b);
        shell.links.insert(shell.links.end(), {a, b});
    }
    return shell;
}

}  // namespace plait::test
