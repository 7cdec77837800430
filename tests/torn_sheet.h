// A sheet of 1 m by 1 m around the origin that may come apart across its middle.
#pragma once

#include <plait/complex/shapes.h>
#include <plait/world.h>

#include <cstdint>
#include <vector>

namespace plait::test {

struct TornSheet {
    World world{};
    Range cloth{};                   // vertices 0 1 2 below 3 4 5, then the spare ones
    std::vector<std::int32_t> cuts;  // the edge from 1 to 4: the left half keeps both

    // Two of the spare vertices become copies.
    explicit TornSheet(int spare = 3) {
        cloth = world.add(grid({.columns = 3, .rows = 2}, {.origin = {-0.5, -0.5, 0}}),
                          {.spare = spare});
        if (spare > 0) world.tearable.push_back({{0, 6}, world.spare.back()});
        for (int e = 0; e < world.complex.count(1); ++e)
            if (world.complex.vertices(1, e)[0] == 1 && world.complex.vertices(1, e)[1] == 4)
                cuts.push_back(e);
    }

    // Where everything is when it is torn and its right half is so many metres farther right.
    std::vector<Vec<double>> parted(double gap) const {
        const World torn = world.tornBy(cuts);
        std::vector<Vec<double>> x = torn.rest;
        std::vector<int> right{2, 5};
        for (const VertexSplit& split : torn.torn->splits()) right.push_back(split.copy);
        for (const int v : right) x[v].x += gap;
        return x;
    }
};

}  // namespace plait::test
