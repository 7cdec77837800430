#include "self_collision.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

using Triangle = std::array<Vec<double>, 3>;

// Calls visit(corners) for every triangle of the range.
template <class Visit>
void forTriangles(const SimplicialComplex& complex, Range range,
                  std::span<const Vec<double>> positions, const Visit& visit) {
    bool any = false;
    for (int t = 0; t < complex.count(2); ++t) {
        const auto v = complex.vertices(2, t);  // ascending
        if (v[0] < range.first || v[2] >= range.last) continue;
        visit(Triangle{positions[v[0]], positions[v[1]], positions[v[2]]});
        any = true;
    }
    if (!any) throw std::invalid_argument("a surface that meets itself has no triangles");
}

// How far a place in the triangle is at most from the corner that is nearest: the radius of the
// circle through the corners, unless its centre lies beyond the longest side. Then it is where the
// bisector of another side leaves through the longest.
double holeOf(const Triangle& x) {
    const auto side = [&](std::size_t i, std::size_t j) { return x[(i + j) % 3] - x[i % 3]; };
    double most = 0;
    bool blunt = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = dot(side(i, 1), side(i, 1)), b = dot(side(i, 2), side(i, 2));
        const double along = dot(side(i, 1), side(i, 2));
        blunt = blunt || along <= 0;
        if (along > 0)
            most = std::max(most, 0.5 * std::min(a, b) * std::sqrt(std::max(a, b)) / along);
    }
    if (blunt) return most;
    const double sides = length(side(0, 1)) * length(side(1, 1)) * length(side(2, 1));
    return 0.5 * sides / length(cross(side(0, 1), side(0, 2)));
}

}  // namespace

double automaticThickness(const SimplicialComplex& complex, Range range,
                          std::span<const Vec<double>> positions) {
    double area = 0;
    int count = 0;
    forTriangles(complex, range, positions, [&](const Triangle& x) {
        area += 0.5 * length(cross(x[1] - x[0], x[2] - x[0]));
        ++count;
    });
    return std::sqrt(4 / std::sqrt(3.0) * area / count) / (2 * denseWidth);
}

double widthWithoutHoles(const SimplicialComplex& complex, Range range,
                         std::span<const Vec<double>> positions, double thickness) {
    if (!(thickness > 0)) throw std::invalid_argument("balls without thickness leave holes");
    double hole = 0;
    forTriangles(complex, range, positions,
                 [&](const Triangle& x) { hole = std::max(hole, holeOf(x)); });
    return hole / (2 * thickness);
}

Self selfModeFor(const SimplicialComplex& complex, Range range,
                 std::span<const Vec<double>> positions, double thickness) {
    const double width = widthWithoutHoles(complex, range, positions, thickness);
    return width <= denseWidth ? Self::vertex : Self::vertexFace;
}

}  // namespace plait
