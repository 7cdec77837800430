// Thickness and mode of what meets itself, from the size of its triangles (M 4.5.1).
#pragma once

#include "../complex/complex.h"
#include "../numbers/math.h"
#include "surface.h"

#include <span>

namespace plait {

// What the functions below take: the triangles of `complex` whose vertices are among `range`, at
// `positions` (m, by vertex). They throw std::invalid_argument if there are none.

// Width at which M makes the balls of dense meshes touch [SF4].
inline constexpr double denseWidth = 3;

// m: s / 6, with s the side of an equilateral triangle of the mean area A, s^2 = 4 A / sqrt(3)
// [SF3]. M only says that it follows from the mean triangle, and that balls then touch at a width
// of 3: so it is a sixth of a side.
double automaticThickness(const SimplicialComplex& complex, Range range,
                          std::span<const Vec<double>> positions);

// The least width at which balls of `thickness` (m) leave no hole for another: twice the radius
// reaches every place of every triangle from its nearest corner. Stretched, a mesh wants more
// [SF7].
double widthWithoutHoles(const SimplicialComplex& complex, Range range,
                         std::span<const Vec<double>> positions, double thickness);

// Vertex where a width of 3 leaves no hole, otherwise vertexFace [SF2]. M tells complex meshes from
// simple ones without saying how; this is what the choice is good for.
Self selfModeFor(const SimplicialComplex& complex, Range range,
                 std::span<const Vec<double>> positions, double thickness);

}  // namespace plait
