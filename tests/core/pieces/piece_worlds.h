// Solids for tests of pieces.
#pragma once

#include <plait/complex/solid_shapes.h>
#include <plait/forces/gravity.h>
#include <plait/measure/momentum.h>
#include <plait/pieces/piece.h>
#include <plait/solver.h>

namespace plait::test {

// About the origin.
inline Shape box(const Vec<double>& size) { return boxSurface(-0.5 * size, 0.5 * size); }

// Upright on y = 0.
inline Shape prism(int corners, double radius, double height) {
    Shape shape = prismSurface({.corners = corners, .radius = radius, .height = height});
    for (Vec<double>& x : shape.positions) x.y += 0.5 * height;
    return shape;
}

}  // namespace plait::test
