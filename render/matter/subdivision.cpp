#include "subdivision.h"

#include <algorithm>

namespace plait {
namespace {

// An edge and the vertices opposite to it, one for each of its triangles.
struct Edge {
    std::array<int, 2> ends;
    std::vector<int> opposite;
};

std::vector<Edge> edgesOf(std::span<const std::array<int, 3>> triangles) {
    std::vector<std::array<int, 3>> sides;
    for (const auto& t : triangles)
        for (int i = 0; i < 3; ++i) {
            const int a = t[(i + 1) % 3], b = t[(i + 2) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t[i]});
        }
    std::ranges::sort(sides);
    std::vector<Edge> edges;
    for (const auto& [a, b, opposite] : sides) {
        if (edges.empty() || edges.back().ends != std::array{a, b}) edges.push_back({{a, b}, {}});
        edges.back().opposite.push_back(opposite);
    }
    return edges;
}

bool turns(const Vec<double>& a, const Vec<double>& x, const Vec<double>& b) {
    const auto in = x - a, out = b - x;
    return dot(in, out) < 0.64 * length(in) * length(out);  // cos 50 degrees
}

}  // namespace

Subdivision::Subdivision(std::span<const std::array<int, 3>> triangles,
                         std::span<const Vec<double>> rest, bool refined) {
    const auto edges = edgesOf(triangles);
    std::vector<std::vector<int>> ring(rest.size()), border(rest.size());
    std::vector<char> fixed(rest.size());
    for (const auto& [ends, opposite] : edges)
        for (int i = 0; i < 2; ++i) {
            const int v = ends[i], other = ends[1 - i];
            ring[v].push_back(other);
            if (opposite.size() == 1) border[v].push_back(other);
            if (opposite.size() > 2) fixed[v] = 1;
        }

    for (int v = 0; v < static_cast<int>(rest.size()); ++v) {
        const auto& b = border[v];
        if (fixed[v] || ring[v].empty() || (!b.empty() && b.size() != 2) ||
            (b.size() == 2 && turns(rest[b[0]], rest[v], rest[b[1]]))) {
            add(std::array{v}, std::array{1.0f});
        } else if (b.size() == 2) {
            add(std::array{v, b[0], b[1]}, std::array{0.75f, 0.125f, 0.125f});
        } else {
            const auto n = static_cast<float>(ring[v].size());
            const float beta = n > 3 ? 0.375f / n : 0.1875f;
            std::vector<int> vertices{v};
            vertices.insert(vertices.end(), ring[v].begin(), ring[v].end());
            std::vector<float> weights(vertices.size(), beta);
            weights[0] = 1 - n * beta;
            add(vertices, weights);
        }
    }
    if (!refined) {
        triangles_.assign(triangles.begin(), triangles.end());
        return;
    }
    for (const auto& [ends, opposite] : edges) {
        if (opposite.size() == 2)
            add(std::array{ends[0], ends[1], opposite[0], opposite[1]},
                std::array{0.375f, 0.375f, 0.125f, 0.125f});
        else
            add(ends, std::array{0.5f, 0.5f});
    }

    const auto middle = [&](int a, int b) {
        const std::array ends{std::min(a, b), std::max(a, b)};
        const auto edge = std::ranges::lower_bound(edges, ends, {}, &Edge::ends);
        return static_cast<int>(rest.size()) + static_cast<int>(edge - edges.begin());
    };
    for (const auto& [a, b, c] : triangles) {
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const auto& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            triangles_.push_back(t);
    }
}

Subdivision Subdivision::facets(std::span<const std::array<int, 3>> triangles,
                                std::span<const Vec<double>> rest) {
    Subdivision facets;
    // By coarse vertex: fine ones, and the normals of their first triangles.
    std::vector<std::vector<std::pair<int, Vec<double>>>> sides(rest.size());
    for (const auto& t : triangles) {
        const Vec<double> across = cross(rest[t[1]] - rest[t[0]], rest[t[2]] - rest[t[0]]);
        const Vec<double> normal = divide(1.0, length(across)) * across;
        std::array<int, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            auto& known = sides[t[k]];
            auto side = std::ranges::find_if(
                known, [&](const auto& s) { return dot(s.second, normal) > 0.766; });
            if (side == known.end()) {
                side = known.insert(known.end(), {facets.size(), normal});
                facets.add(std::array{t[k]}, std::array{1.0f});
            }
            corners[k] = side->first;
        }
        facets.triangles_.push_back(corners);
    }
    return facets;
}

void Subdivision::add(std::span<const int> vertices, std::span<const float> weights) {
    vertex_.insert(vertex_.end(), vertices.begin(), vertices.end());
    weight_.insert(weight_.end(), weights.begin(), weights.end());
    start_.push_back(static_cast<int>(vertex_.size()));
}

}  // namespace plait
