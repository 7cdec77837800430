#include "intersections.h"

#include <algorithm>
#include <stdexcept>

#include "../../numbers/finite.h"
#include "../checks.h"
#include "box_tree.h"
#include "orientation.h"

namespace plait {
namespace {

bool shareVertex(const std::array<int, 2>& edge, const std::array<int, 3>& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&](int v) { return v == edge[0] || v == edge[1]; });
}

// p and q are strictly apart, so the line p q meets the plane in one point; that point is in the
// closed triangle if no two sides see the line turn opposite ways.
bool pierces(const Vec<double>& p, const Vec<double>& q, const Vec<double>& a, const Vec<double>& b,
             const Vec<double>& c) {
    if (orientation(a, b, c, p) * orientation(a, b, c, q) >= 0) return false;
    const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c);
    if (ab * bc < 0) return false;
    const int ca = orientation(p, q, c, a);
    return bc * ca >= 0 && ca * ab >= 0;
}

}  // namespace

std::vector<std::array<int, 2>> edgesOf(std::span<const std::array<int, 3>> triangles) {
    std::vector<std::array<int, 2>> edges;
    edges.reserve(3 * triangles.size());
    for (const auto& [a, b, c] : triangles) {
        for (const auto [i, j] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
            edges.push_back({std::min(i, j), std::max(i, j)});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::vector<Intersection> findIntersections(std::span<const Vec<double>> positions,
                                            std::span<const std::array<int, 2>> edges,
                                            std::span<const std::array<int, 3>> triangles) {
    checkIndices(edges, positions.size());
    checkIndices(triangles, positions.size());
    if (!allFinite(positions)) throw std::invalid_argument("a position is not finite");
    const auto& x = positions;
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) boxes.push_back(boxOf(std::array{x[a], x[b], x[c]}));
    const BoxTree tree(std::move(boxes));

    std::vector<Intersection> found;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const Vec<double>&p = x[edges[e][0]], &q = x[edges[e][1]];
        tree.overlaps(boxOf(std::array{p, q}), [&](int t) {
            const auto [a, b, c] = triangles[t];
            if (shareVertex(edges[e], triangles[t])) return;
            if (pierces(p, q, x[a], x[b], x[c])) found.push_back({e, t});
        });
    }
    std::sort(found.begin(), found.end());
    return found;
}

int countIntersections(std::span<const Vec<double>> positions,
                       std::span<const std::array<int, 2>> edges,
                       std::span<const std::array<int, 3>> triangles) {
    return static_cast<int>(findIntersections(positions, edges, triangles).size());
}

int countIntersections(std::span<const Vec<double>> positions,
                       std::span<const std::array<int, 3>> triangles) {
    checkIndices(triangles, positions.size());
    return countIntersections(positions, edgesOf(triangles), triangles);
}

int countCrossings(std::span<const Vec<double>> positions, std::span<const std::array<int, 3>> a,
                   std::span<const std::array<int, 3>> b) {
    checkIndices(a, positions.size());
    checkIndices(b, positions.size());
    return countIntersections(positions, edgesOf(a), b) +
           countIntersections(positions, edgesOf(b), a);
}

}  // namespace plait
