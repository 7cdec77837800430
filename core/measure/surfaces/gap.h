// How near a mesh comes to itself: is a thickness kept? Independent of the solver's and of the
// collision code.
#pragma once

#include <array>
#include <span>

#include "../../numbers/math.h"

namespace plait {

// The least distance (m) of a vertex to a triangle and of an edge to an edge that share no vertex
// index, or `within` (m) if none are nearer; 0 where intersections.h counts an intersection. Right
// to 1e-7 of the longest edge; where no two edges are nearly parallel, to rounding.
//
// Positions in m, finite. Throws std::invalid_argument on one that is not finite, an index out of
// range and a negative or infinite `within`. About n log n in time for n triangles if `within` is
// not above their size.
double leastGap(std::span<const Vec<double>> positions,
                std::span<const std::array<int, 3>> triangles, double within);

struct Gap {
    double distance;              // m
    std::array<int, 2> vertices;  // one of each of the two; none where nothing is nearer
};
// The same, and where; only of a mesh that does not intersect itself.
Gap nearest(std::span<const Vec<double>> positions, std::span<const std::array<int, 3>> triangles,
            double within);

}  // namespace plait
