#include "facets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plait {
namespace {

constexpr float nearest = 0.003f;    // m, to what lies beside it
constexpr float wideOpen = 0.0003f;  // m, from where on it has come apart

// By vertex: which solid it belongs to.
std::vector<int> solidsOf(std::size_t count, std::span<const std::array<int, 3>> triangles) {
    std::vector<int> parent(count);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const auto& [a, b, c] : triangles) parent[root(b)] = parent[root(c)] = root(a);
    for (std::size_t v = 0; v < count; ++v) parent[v] = root(static_cast<int>(v));
    return parent;
}

bool contains(const std::vector<int>& all, int one) {
    return std::ranges::find(all, one) != all.end();
}

}  // namespace

Facets::Facets(std::span<const glm::vec3> rest, std::vector<std::array<int, 3>> triangles)
    : triangles_(std::move(triangles)), near_(rest.size(), -1), apart_(rest.size(), nearest) {
    const std::vector<int> solid = solidsOf(rest.size(), triangles_);
    std::vector<std::vector<int>> beside(rest.size());  // by vertex: other solids
    std::vector<unsigned char> used(rest.size());
    for (const auto& t : triangles_)
        for (const int v : t) used[v] = 1;
    std::vector<int> order;  // along x
    for (int v = 0; v < std::ssize(rest); ++v)
        if (used[v]) order.push_back(v);
    std::ranges::sort(order, {}, [&](int v) { return std::pair(rest[v].x, v); });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const int a = order[i], b = order[j];
            if (rest[b].x - rest[a].x > nearest) break;
            if (solid[a] == solid[b]) continue;
            const float away = glm::length(rest[a] - rest[b]);
            if (away > nearest) continue;
            for (const auto& [v, w] : {std::pair{a, b}, {b, a}}) {
                beside[v].push_back(solid[w]);
                if (away < apart_[v]) apart_[v] = away, near_[v] = w;
            }
        }
    std::vector<std::vector<int>> corners(rest.size());  // by solid
    for (const int v : order) corners[solid[v]].push_back(v);
    // How far a solid reaches behind a face, m.
    const auto behind = [&](int body, const glm::vec3& at, const glm::vec3& normal) {
        float most = 0;
        for (const int v : corners[body]) most = std::max(most, glm::dot(normal, at - rest[v]));
        return most;
    };
    // A face inside has another solid beside all its corners, and that one before it.
    for (const auto& [a, b, c] : triangles_) {
        const glm::vec3 n = glm::normalize(glm::cross(rest[b] - rest[a], rest[c] - rest[a]));
        const float own = behind(solid[a], rest[a], n);
        outside_.push_back(std::ranges::none_of(beside[a], [&](int other) {
            return contains(beside[b], other) && contains(beside[c], other) &&
                   behind(other, rest[a], n) < 0.5f * own;
        }));
    }
}

void Facets::update(std::span<const glm::vec3> positions, std::span<MeshVertex> vertices) const {
    const auto opened = [&](int v) {
        if (near_[v] < 0) return 0.0f;
        const float away = glm::length(positions[v] - positions[near_[v]]) - apart_[v];
        return std::clamp(away / wideOpen, 0.0f, 1.0f);
    };
    // What is closed is drawn without its kerf and bevel.
    std::vector<glm::vec3> drawn(positions.begin(), positions.end());
    for (std::size_t v = 0; v < drawn.size(); ++v)
        if (near_[v] >= 0)
            drawn[v] +=
                (0.5f - 0.5f * opened(static_cast<int>(v))) * (positions[near_[v]] - positions[v]);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto& [a, b, c] = triangles_[i];
        const glm::vec3 n = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        const float l = glm::length(n);
        const float shown = outside_[i] ? -1 : std::max({opened(a), opened(b), opened(c)});
        for (int k = 0; k < 3; ++k) {
            MeshVertex& v = vertices[3 * i + k];
            v.position = drawn[triangles_[i][k]];
            v.normal = l > 0 ? n / l : glm::vec3(0, 1, 0);
            v.tangent = {0, 0, 0};
            v.satin = shown;
        }
    }
}

}  // namespace plait
