// Sheets of rigid links whose order of sweeps is known.
#pragma once

#include "worlds.h"

#include <cmath>

namespace plait::test {

// Every edge of a grid in six colours: across from even and odd columns, down and diagonal from
// even and odd rows.
inline Rows<Stretch> sheetLinks(const World& world, int columns, int rows) {
    std::vector<int> ids, colors;
    const auto join = [&](int color, int from, int to) {
        ids.insert(ids.end(), {from, to});
        colors.push_back(color);
    };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const int v = r * columns + c;
            const bool right = c + 1 < columns, below = r + 1 < rows;
            if (right) join(c % 2, v, v + 1);
            if (below) join(2 + r % 2, v, v + columns);
            if (right && below) join(4 + r % 2, v, v + columns + 1);
        }
    Rows<Stretch> links = restRows<Stretch>(ids, world.rest);
    links.colors = colors;
    return links;
}

// A square metre of n x n masses of 1 kg at rest, two corners pinned, bent by about `bend` metres.
inline World bentSheet(int n, double bend) {
    World world;
    Shape shape = grid({.columns = n, .rows = n});
    for (Vec<double>& p : shape.positions)
        p = {p.x, bend * std::sin(3 * p.y) + bend / 2 * std::cos(4 * p.x), p.y};
    world.add(shape);
    world.mass.assign(world.mass.size(), 1.0);
    world.pin({0, n - 1});
    world.constrain(sheetLinks(world, n, n), {.name = "stretch"});
    return world;
}

}  // namespace plait::test
