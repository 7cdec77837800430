#include "back_to_front.h"

#include <algorithm>

namespace plait {

std::vector<std::array<int, 3>> backToFront(std::span<const std::array<int, 3>> triangles,
                                            std::span<const MeshVertex> vertices,
                                            const glm::vec3& eye, std::size_t group) {
    constexpr int steps = 65536;
    if (triangles.empty()) return {};
    const std::size_t n = triangles.size();
    std::vector<float> distances;
    for (std::size_t i = 0; i < n; i += group) {
        const auto [a, b, c] = triangles[std::min(i + group / 2, n - 1)];
        distances.push_back(glm::length(vertices[a].position + vertices[b].position +
                                        vertices[c].position - 3.0f * eye));
    }
    const auto [low, high] = std::ranges::minmax(distances);
    const float scale = static_cast<float>(steps - 1) / std::max(high - low, 1e-6f);
    std::vector<std::size_t> start(steps + 1);
    const auto step = [&, far = high](std::size_t i) {
        return static_cast<std::size_t>((far - distances[i]) * scale);
    };
    const auto size = [&](std::size_t i) { return std::min(group, n - i * group); };
    for (std::size_t i = 0; i < distances.size(); ++i) start[step(i) + 1] += size(i);
    for (std::size_t i = 0; i < steps; ++i) start[i + 1] += start[i];
    std::vector<std::array<int, 3>> sorted(n);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        std::copy_n(&triangles[i * group], size(i), &sorted[start[step(i)]]);
        start[step(i)] += size(i);
    }
    return sorted;
}

}  // namespace plait
