#include "strain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "checks.h"
#include "compensated_sum.h"

namespace plait {

std::vector<double> strains(std::span<const Vec<double>> positions,
                            std::span<const std::array<int, 2>> edges,
                            std::span<const double> rest) {
    checkSameSize(edges.size(), rest.size(), "edges and rest lengths");
    checkIndices(edges, positions.size());
    std::vector<double> strain(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!(rest[i] > 0)) throw std::invalid_argument("a rest length is not above 0");
        const auto [a, b] = edges[i];
        strain[i] = length(positions[b] - positions[a]) / rest[i] - 1;
    }
    return strain;
}

StrainSummary summarizeStrain(std::span<const Vec<double>> positions,
                              std::span<const std::array<int, 2>> edges,
                              std::span<const double> rest) {
    auto strain = strains(positions, edges, rest);
    if (strain.empty()) return {};
    const auto [least, greatest] = std::minmax_element(strain.begin(), strain.end());
    StrainSummary summary{.maximum = *greatest, .minimum = *least};
    CompensatedSum sum;
    for (double& e : strain) sum.add(e = std::abs(e));
    summary.mean = sum.value() / static_cast<double>(strain.size());
    const auto rank = (99 * strain.size() + 99) / 100 - 1;
    const auto middle = strain.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(strain.begin(), middle, strain.end());
    summary.percentile99 = *middle;
    return summary;
}

}  // namespace plait
