// Coherent noise: what makes gusts of a steady wind.
#pragma once

#include "../numbers/math.h"

#include <cstdint>

namespace plait {

// Gradient noise (Perlin 1985, 2002) in space and time, three components at once, each with
// gradients of its own at the integer points of (x, t): both in cells, one hump or so a cell.
//
// Twice continuously differentiable. Mean 0, root mean square 1, over all points and seeds, for
// each component; never beyond 5.917. 0 at the integer points, and beyond 1e15 cells or for what is
// not a number. Made from arithmetic and integer hashes alone: the same bits everywhere.
Vec<double> coherentNoise(const Vec<double>& x, double t, std::uint64_t seed);

}  // namespace plait
