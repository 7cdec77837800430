#include "area_stretch.h"

namespace plait {
namespace {

template <class Area>
void addAreas(std::span<const std::array<int, 3>> triangles, const Area& area,
              std::vector<float>& sums) {
    for (const auto& t : triangles)
        for (const float a = area(t); const int v : t) sums[v] += a;
}

}  // namespace

AreaStretch::AreaStretch(std::span<const std::array<int, 3>> triangles,
                         std::span<const Vec<double>> rest)
    : triangles_(triangles.begin(), triangles.end()), perArea_(rest.size()) {
    const auto area = [&](const std::array<int, 3>& t) {
        return static_cast<float>(0.5 *
                                  length(cross(rest[t[1]] - rest[t[0]], rest[t[2]] - rest[t[0]])));
    };
    addAreas(triangles_, area, perArea_);
    for (float& a : perArea_) a = a > 0 ? 1 / a : 0;
}

void AreaStretch::measure(std::span<const glm::vec3> positions, std::vector<float>& stretch) const {
    const auto& x = positions;
    const auto area = [&](const std::array<int, 3>& t) {
        return 0.5f * glm::length(glm::cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]));
    };
    stretch.assign(perArea_.size(), 0);
    addAreas(triangles_, area, stretch);
    for (std::size_t i = 0; i < stretch.size(); ++i)
        stretch[i] = perArea_[i] > 0 ? stretch[i] * perArea_[i] : 1;
}

}  // namespace plait
