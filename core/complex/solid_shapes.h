// Ready-made solids by their surfaces: closed, normals outward. As in shapes.h, builders throw
// std::invalid_argument that names the parameter.
#pragma once

#include "shapes.h"

namespace plait {

// A box between two corners, each coordinate of `low` the lesser. Two triangles a side.
Shape boxSurface(const Vec<double>& low, const Vec<double>& high);

struct PrismParameters {
    int corners = 3;  // of its ends, at least 3, on a circle about y
    double radius = 1;
    double height = 1;  // from -height / 2 to height / 2
};

Shape prismSurface(const PrismParameters& parameters);

}  // namespace plait
