#include "solid_shapes.h"

#include "../numbers/elementary.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace plait {

Shape boxSurface(const Vec<double>& low, const Vec<double>& high) {
    const Vec<double> size = high - low;
    for (const double s : {size.x, size.y, size.z})
        if (!(s > 0) || !std::isfinite(s))
            throw std::invalid_argument("box: low must be below high");
    Shape shape;
    for (int i = 0; i < 8; ++i)
        shape.positions.push_back(
            {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    Simplices sides;
    for (const auto& [a, b, c, d] : {std::array{0, 4, 6, 2},
                                     {1, 3, 7, 5},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 2, 3, 1},
                                     {4, 5, 7, 6}}) {
        sides.triangles.push_back({a, b, c});
        sides.triangles.push_back({a, c, d});
    }
    shape.complex = SimplicialComplex(8, sides);
    return shape;
}

Shape prismSurface(const PrismParameters& parameters) {
    const auto [corners, radius, height] = parameters;
    if (corners < 3 || corners > 1'000'000)
        throw std::invalid_argument("prism: corners must be 3 to 1e6");
    if (!(radius > 0 && height > 0) || !std::isfinite(radius) || !std::isfinite(height))
        throw std::invalid_argument("prism: radius and height must be positive");
    Shape shape;
    Simplices faces;
    for (int i = 0; i < 2 * corners; ++i) {
        const double turn = 2 * pi * (i % corners) / corners;
        shape.positions.push_back(
            {radius * cosine(turn), (i < corners ? -0.5 : 0.5) * height, -radius * sine(turn)});
    }
    for (int i = 0; i < corners; ++i) {
        const int j = (i + 1) % corners;
        faces.triangles.push_back({i, j, corners + j});
        faces.triangles.push_back({i, corners + j, corners + i});
        if (i == 0 || j == 0) continue;
        faces.triangles.push_back({0, j, i});
        faces.triangles.push_back({corners, corners + i, corners + j});
    }
    shape.complex = SimplicialComplex(2 * corners, faces);
    return shape;
}

}  // namespace plait
