// Polygons into triangles; not for use outside the readers of meshes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../numbers/math.h"

namespace plait {

// Splits a polygon of 4 corners or more into triangles, two fewer than corners, that turn as it
// does and together cover it, seen along its normal (Newell's). A quad keeps its first diagonal
// where that will do, as it does in every convex one; other polygons lose one ear after the other,
// the best shaped first. Corners in one line or at one place give triangles without area only where
// every way of splitting has some.
//
// Triangles are numbers of corners; none if the polygon crosses itself. Time grows with the square
// of the corners at worst.
std::vector<std::array<int, 3>> splitPolygon(std::span<const Vec<double>> corners);

}  // namespace plait
