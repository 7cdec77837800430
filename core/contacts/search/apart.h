// How far apart simplices are at least, four pairs at a time and in float: most pairs that are near
// each other do not meet, and this says so for a tenth of what it costs to find where they are
// nearest (nearest.h).
#pragma once

#include "../../numbers/math.h"

#include <array>
#include <span>

namespace plait {

// A point, or a way, in m.
struct alignas(16) Spot {
    float x, y, z, unused;
};

// `first` and `second` vertices a simplex, of lane i those in vertices[0][i], vertices[1][i], ...;
// 1 and 1, 2 or 3, or 2 and 2.
struct FourPairs {
    std::array<std::array<int, 4>, 4> vertices;
    int first, second;
};

// Never more than nearest() has for `at` (m, by vertex), rounded to float; less by at most a
// thousandth of the lengths of their edges, measured along the axes, and a millionth of the
// coordinates. Not a number where a point is not finite.
std::array<float, 4> apartAtLeast(const FourPairs& pairs, std::span<const Spot> at);

// How far a vertex of one goes against a vertex of the other, at most; m, rounded up.
std::array<float, 4> goApart(const FourPairs& pairs, std::span<const Spot> way);

}  // namespace plait
