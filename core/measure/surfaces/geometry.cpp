#include "geometry.h"

#include <algorithm>
#include <stdexcept>

#include "../checks.h"
#include "../compensated_sum.h"

namespace plait {

double area(std::span<const Vec<double>> positions, std::span<const std::array<int, 3>> triangles) {
    checkIndices(triangles, positions.size());
    CompensatedSum sum;
    for (const auto& [a, b, c] : triangles) {
        const Vec<double>& x = positions[a];
        sum.add(0.5 * length(cross(positions[b] - x, positions[c] - x)));
    }
    return sum.value();
}

double volume(std::span<const Vec<double>> positions,
              std::span<const std::array<int, 3>> triangles) {
    checkIndices(triangles, positions.size());
    if (triangles.empty()) return 0;
    // Signed tetrahedra from a vertex of the surface: from a far origin they would cancel.
    const Vec<double> apex = positions[triangles[0][0]];
    CompensatedSum sum;
    for (const auto& [a, b, c] : triangles) {
        sum.add(dot(positions[a] - apex, cross(positions[b] - apex, positions[c] - apex)) / 6);
    }
    return sum.value();
}

Vec<double> lowestPoint(std::span<const Vec<double>> positions, const Vec<double>& up) {
    if (positions.empty()) throw std::invalid_argument("no positions have no lowest point");
    if (!(dot(up, up) > 0)) throw std::invalid_argument("the way up is zero");
    return *std::min_element(positions.begin(), positions.end(),
                             [&](const auto& a, const auto& b) { return dot(up, a) < dot(up, b); });
}

Vec<double> centreOfMass(std::span<const double> masses, std::span<const Vec<double>> positions) {
    checkSameSize(masses.size(), positions.size(), "masses and positions");
    CompensatedSum total;
    CompensatedVecSum moment;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        total.add(masses[i]);
        moment.add(masses[i] * positions[i]);
    }
    if (!(total.value() > 0)) throw std::invalid_argument("the masses do not add up to above 0");
    return (1 / total.value()) * moment.value();
}

}  // namespace plait
