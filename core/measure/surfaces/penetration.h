// Points inside a closed surface: matter where it must not be. Independent of the solver's and of
// the collision code.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../../numbers/math.h"

namespace plait {

// Which of `points` are strictly inside a closed surface, ascending: those that it winds round,
// however it runs through itself, and that lie on none of its triangles. Exact, decided by signs of
// orientation.h alone. Triangles without area bound nothing.
//
// Points and positions in m, finite and within the range of orientation.h. Throws
// std::invalid_argument on one that is not finite, an index out of range, and a surface that is not
// closed: one whose triangles do not run along each edge as often one way as the other. About
// (m + n) log n in time for m points and n triangles of a body that is not all folds.
std::vector<int> findInside(std::span<const Vec<double>> points,
                            std::span<const Vec<double>> positions,
                            std::span<const std::array<int, 3>> triangles);

}  // namespace plait
