// The ballerina's skin at rest: one closed surface of triangles, counter-clockwise from outside.
#pragma once

#include "shape.h"

#include <array>
#include <vector>

namespace plait::dancer {

struct Surface {
    std::vector<Point> positions;
    std::vector<std::array<int, 3>> triangles;
};

// The zero of field(): surface nets (Gibson 1998) on a grid fine enough for fingers, then collapsed
// and flipped to triangles that are as large as what they show allows.
Surface bodySurface();

// The two steps of it.
Surface surfaceNets(double cell);
void coarsen(Surface& surface);

}  // namespace plait::dancer
