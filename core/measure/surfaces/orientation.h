// On which side of a plane a point lies: the exact sign, for any doubles.
#pragma once

#include "../../numbers/math.h"

namespace plait {

// -1, 0 or 1.
inline int signOf(double a) { return (a > 0) - (a < 0); }

// The sign (-1, 0, 1) of the determinant of the columns a - d, b - d, c - d: 1 if a, b, c run
// clockwise seen from d, as in the tetrahedron (0, 0, 0), x, y, z with d at the origin; 0 only if
// the four points are in one plane.
//
// A floating-point filter first, after that sums of doubles without rounding (Shewchuk, Adaptive
// Precision Floating-Point Arithmetic, 1997). Exact for coordinates that are 0 or within [1e-80,
// 1e96] in magnitude (all bits within 2^-320 and 2^320), in any mode of denormals.
int orientation(const Vec<double>& a, const Vec<double>& b, const Vec<double>& c,
                const Vec<double>& d);

}  // namespace plait
