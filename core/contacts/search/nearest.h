// Where two simplices are nearest to each other.
#pragma once

#include "../../numbers/math.h"

#include <array>

namespace plait {

// Up to four vertices: `first` of one simplex, then those of the other.
struct Pairing {
    std::array<int, 4> vertices;  // unused ones repeat the last and weigh nothing
    int first = 0;                // 1 or 2
    int second = 0;               // 1, 2 or 3
};

// weight[i] are the barycentric coordinates of the nearest points, those of the second simplex
// negative: sum of weight[i] x[i] leads from the second to the first.
struct Nearest {
    std::array<double, 4> weight{};
    Vec<double> apart{};  // m
};

// Of a point or an edge, and a point, an edge or a triangle (not edge and triangle) at x. Any
// points will do, coinciding or in a line.
Nearest nearest(const Pairing& pair, const std::array<Vec<double>, 4>& x);

}  // namespace plait
