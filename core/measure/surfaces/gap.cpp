#include "gap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "box_tree.h"
#include "intersections.h"

namespace plait {
namespace {

using Point = Vec<double>;

double toSegment(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const double square = dot(along, along);
    const double s = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
    return length(p - (a + s * along));
}

double toTriangle(const Point& p, const Point& a, const Point& b, const Point& c) {
    const Point n = cross(b - a, c - a);
    const auto within = [&](const Point& from, const Point& to) {
        return dot(cross(n, to - from), p - from) >= 0;
    };
    if (dot(n, n) > 0 && within(a, b) && within(b, c) && within(c, a))
        return std::fabs(dot(n, p - a)) / length(n);
    return std::min({toSegment(p, a, b), toSegment(p, b, c), toSegment(p, c, a)});
}

// Of edges a b and c d. The foot of the common normal, or an end.
double betweenEdges(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double ends =
        std::min({toSegment(a, c, d), toSegment(b, c, d), toSegment(c, a, b), toSegment(d, a, b)});
    const Point u = b - a, v = d - c, w = c - a, n = cross(u, v);
    const double square = dot(n, n);
    if (!(square > 0)) return ends;
    const double s = dot(cross(w, v), n) / square, t = dot(cross(w, u), n) / square;
    if (!(s > 0 && s < 1 && t > 0 && t < 1)) return ends;
    return std::min(ends, length(t * v - s * u + w));
}

Box grown(const Box& box, double by) {
    const Point margin{by, by, by};
    return {box.low - margin, box.high + margin};
}

// Lowers `gap` to the least distance of two items that are not joined, where that is less.
// `verticesOf` gives one of each.
template <class Joined, class Distance, class VerticesOf>
void lower(Gap& gap, std::span<const Box> queries, const BoxTree& tree, const Joined& joined,
           const Distance& distance, const VerticesOf& verticesOf) {
    for (int i = 0; i < static_cast<int>(queries.size()); ++i)
        tree.overlaps(grown(queries[static_cast<std::size_t>(i)], gap.distance), [&](int j) {
            if (joined(i, j)) return;
            const double d = distance(i, j);
            if (d < gap.distance) gap = {d, verticesOf(i, j)};
        });
}

}  // namespace

double leastGap(std::span<const Point> positions, std::span<const std::array<int, 3>> triangles,
                double within) {
    if (!(within >= 0) || !std::isfinite(within))
        throw std::invalid_argument("a gap is sought within a distance of 0 or more");
    if (countIntersections(positions, triangles) > 0) return 0;
    return nearest(positions, triangles, within).distance;
}

Gap nearest(std::span<const Point> positions, std::span<const std::array<int, 3>> triangles,
            double within) {
    const auto at = [&](int v) -> const Point& { return positions[static_cast<std::size_t>(v)]; };
    const std::vector<std::array<int, 2>> edges = edgesOf(triangles);
    std::vector<Box> points, sides, faces;
    std::vector<int> vertices;
    for (const auto& [a, b, c] : triangles) {
        vertices.insert(vertices.end(), {a, b, c});
        faces.push_back(boxOf(std::array{at(a), at(b), at(c)}));
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (const int v : vertices) points.push_back({at(v), at(v)});
    for (const auto& [a, b] : edges) sides.push_back(boxOf(std::array{at(a), at(b)}));

    Gap gap{within, {-1, -1}};
    const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
    const auto edge = [&](int i) { return edges[static_cast<std::size_t>(i)]; };
    const auto face = [&](int i) { return triangles[static_cast<std::size_t>(i)]; };
    lower(
        gap, points, BoxTree(faces),
        [&](int v, int t) {
            const auto [a, b, c] = face(t);
            return vertex(v) == a || vertex(v) == b || vertex(v) == c;
        },
        [&](int v, int t) {
            const auto [a, b, c] = face(t);
            return toTriangle(at(vertex(v)), at(a), at(b), at(c));
        },
        [&](int v, int t) { return std::array{vertex(v), face(t)[0]}; });
    lower(
        gap, sides, BoxTree(sides),
        [&](int e, int f) {
            const auto [a, b] = edge(e);
            const auto [c, d] = edge(f);
            return e >= f || a == c || a == d || b == c || b == d;
        },
        [&](int e, int f) {
            const auto [a, b] = edge(e);
            const auto [c, d] = edge(f);
            return betweenEdges(at(a), at(b), at(c), at(d));
        },
        [&](int e, int f) { return std::array{edge(e)[0], edge(f)[0]}; });
    return gap;
}

}  // namespace plait
