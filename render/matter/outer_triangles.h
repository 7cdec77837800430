// The triangles of matter that are seen.
#pragma once

#include <plait/complex/complex.h>
#include <plait/numbers/math.h>

#include <array>
#include <span>
#include <vector>

namespace plait {

// All of these vertices are of the range.
bool liesIn(std::span<const int> vertices, Range range);

// Those of a range, vertices counted from its start: those between two tetrahedra are not seen,
// those of one look away from it. `rest` (m) has a position for each vertex of the complex.
std::vector<std::array<int, 3>> outerTriangles(const SimplicialComplex& complex,
                                               std::span<const Vec<double>> rest, Range range);

}  // namespace plait
