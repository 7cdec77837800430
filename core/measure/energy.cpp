#include "energy.h"

#include <stdexcept>

#include "checks.h"
#include "compensated_sum.h"

namespace plait {
namespace {

double harmonic(double c, double compliance) {
    if (!(compliance >= 0)) throw std::invalid_argument("a compliance is negative");
    return compliance > 0 ? c * c / (2 * compliance) : 0;
}

}  // namespace

double kineticEnergy(std::span<const double> masses, std::span<const Vec<double>> velocities) {
    checkSameSize(masses.size(), velocities.size(), "masses and velocities");
    CompensatedSum sum;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        sum.add(0.5 * masses[i] * dot(velocities[i], velocities[i]));
    }
    return sum.value();
}

double gravitationalEnergy(std::span<const double> masses, std::span<const Vec<double>> positions,
                           const Vec<double>& g) {
    checkSameSize(masses.size(), positions.size(), "masses and positions");
    CompensatedSum sum;
    for (std::size_t i = 0; i < masses.size(); ++i) sum.add(-masses[i] * dot(g, positions[i]));
    return sum.value();
}

double harmonicEnergy(std::span<const double> values, std::span<const double> compliances) {
    checkSameSize(values.size(), compliances.size(), "constraint values and compliances");
    CompensatedSum sum;
    for (std::size_t i = 0; i < values.size(); ++i) sum.add(harmonic(values[i], compliances[i]));
    return sum.value();
}

double stretchEnergy(std::span<const Vec<double>> positions,
                     std::span<const std::array<int, 2>> edges, std::span<const double> rest,
                     std::span<const double> compliances,
                     std::span<const double> compressionCompliances) {
    const auto compressed = compressionCompliances.empty() ? compliances : compressionCompliances;
    checkSameSize(edges.size(), rest.size(), "edges and rest lengths");
    checkSameSize(edges.size(), compliances.size(), "edges and compliances");
    checkSameSize(edges.size(), compressed.size(), "edges and compression compliances");
    checkIndices(edges, positions.size());
    CompensatedSum sum;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [a, b] = edges[i];
        const double c = length(positions[b] - positions[a]) - rest[i];
        sum.add(harmonic(c, c < 0 ? compressed[i] : compliances[i]));
    }
    return sum.value();
}

}  // namespace plait
