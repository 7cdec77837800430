#include "parting.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

struct Best {
    double gap = -1e30;
    int at = -1;
};

// How far `other` lies over the faces of `of` at most.
Best bestFace(const Placed& of, const Placed& other) {
    Best best;
    for (std::size_t f = 0; f < of.normals.size(); ++f) {
        const Vec<double>& on = of.corners[of.shape->faces[f].corners[0]];
        const double gap = other.lowest(of.normals[f]) - dot(of.normals[f], on);
        if (gap > best.gap) best = {gap, static_cast<int>(f)};
    }
    return best;
}

// Of each with each.
void dots(std::span<const Vec<double>> a, std::span<const Vec<double>> b,
          std::vector<double>& products) {
    products.clear();
    for (const Vec<double>& x : a)
        for (const Vec<double>& y : b) products.push_back(dot(x, y));
}

using Polygon = std::vector<Vec<double>>;

// What of it lies on the inner side of a plane.
void clip(const Polygon& polygon, const Vec<double>& outward, double height, Polygon& kept) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<double>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ha = dot(outward, a) - height, hb = dot(outward, b) - height;
        if (ha <= 0) kept.push_back(a);
        if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) kept.push_back(a + ha / (ha - hb) * (b - a));
    }
}

// A face and what the other covers of it: put(on the face, on the other).
template <class Put>
void touchFace(const Placed& face, int f, const Placed& other, double reach, const Put& put) {
    const Vec<double>& normal = face.normals[f];
    const std::vector<int>& rim = face.shape->faces[f].corners;
    std::size_t facing = 0;
    for (std::size_t i = 0; i < other.normals.size(); ++i)
        if (dot(other.normals[i], normal) < dot(other.normals[facing], normal)) facing = i;
    thread_local Polygon polygon, kept;
    polygon.clear();
    for (const int v : other.shape->faces[facing].corners) polygon.push_back(other.corners[v]);
    for (std::size_t i = 0; i < rim.size() && !polygon.empty(); ++i) {
        const Vec<double>&a = face.corners[rim[i]], &b = face.corners[rim[(i + 1) % rim.size()]];
        const Vec<double> outward = cross(b - a, normal);
        clip(polygon, outward, dot(outward, a), kept);
        std::swap(polygon, kept);
    }
    const double height = dot(normal, face.corners[rim[0]]);
    bool any = false;
    const auto take = [&](const Vec<double>& x) {
        const double over = dot(normal, x) - height;
        if (over > reach) return;
        put(x - over * normal, x);
        any = true;
    };
    for (const Vec<double>& x : polygon) take(x);
    if (any) return;
    // Beside each other: the lowest corner alone.
    take(*std::ranges::min_element(other.corners, {},
                                   [&](const Vec<double>& x) { return dot(normal, x); }));
}

}  // namespace

Parting partingOf(const Placed& first, const Placed& second, double bias) {
    const Best a = bestFace(first, second), b = bestFace(second, first);
    Parting best = a.gap > b.gap + bias
                       ? Parting{-first.normals[a.at], a.gap, Parting::By::firstFace, a.at, -1}
                       : Parting{second.normals[b.at], b.gap, Parting::By::secondFace, -1, b.at};
    double least = std::max(a.gap, b.gap) + bias;
    // Of every edge of one with every normal of the other.
    thread_local std::vector<double> overFirst, overSecond;
    const std::size_t faces = first.normals.size(), others = second.normals.size();
    dots(first.along, second.normals, overFirst);
    dots(second.along, first.normals, overSecond);
    for (std::size_t i = 0; i < first.along.size(); ++i) {
        const Convex::Edge& e = first.shape->edges[i];
        const double* const over = &overFirst[i * others];
        for (std::size_t j = 0; j < second.along.size(); ++j) {
            // Whether the arcs between the normals beside them cross on the sphere, those of the
            // second turned about.
            const Convex::Edge& o = second.shape->edges[j];
            const double u = over[o.faces[0]], v = over[o.faces[1]];
            if (!(u * v < 0)) continue;
            const double* const under = &overSecond[j * faces];
            const double n = under[e.faces[0]], m = under[e.faces[1]];
            if (!(n * m < 0 && u * m < 0)) continue;
            Vec<double> across = cross(first.along[i], second.along[j]);
            const double l2 = dot(across, across);
            if (l2 < 1e-8) continue;  // along each other: faces part them as well
            across = (1 / squareRoot(l2)) * across;
            // Out of the second, into the first.
            if (dot(across, first.normals[e.faces[0]] + first.normals[e.faces[1]]) > 0)
                across = -across;
            const double gap =
                dot(across, first.corners[e.corners[0]] - second.corners[o.corners[0]]);
            if (gap > least) {
                least = gap;
                best = {across, gap, Parting::By::edges, static_cast<int>(i), static_cast<int>(j)};
            }
        }
    }
    return best;
}

void findTouch(const Placed& first, const Placed& second, const Parting& parting, double reach,
               std::vector<TouchPoint>& points) {
    points.clear();
    if (parting.by == Parting::By::firstFace)
        return touchFace(first, parting.first, second, reach,
                         [&](const Vec<double>& on, const Vec<double>& other) {
                             points.push_back({on, other});
                         });
    if (parting.by == Parting::By::secondFace)
        return touchFace(second, parting.second, first, reach,
                         [&](const Vec<double>& on, const Vec<double>& other) {
                             points.push_back({other, on});
                         });
    // The points of either edge that are nearest the other's line.
    const auto endsOf = [](const Placed& of, int edge) {
        const auto& corners = of.shape->edges[edge].corners;
        return std::pair(of.corners[corners[0]], of.corners[corners[1]]);
    };
    const auto [p, pEnd] = endsOf(first, parting.first);
    const auto [q, qEnd] = endsOf(second, parting.second);
    const Vec<double>&u = first.along[parting.first], &v = second.along[parting.second];
    const double uv = dot(u, v), du = dot(p - q, u), dv = dot(p - q, v);
    const double per = divide(1.0, 1 - uv * uv);
    const double s = std::clamp((uv * dv - du) * per, 0.0, dot(pEnd - p, u));
    const double t = std::clamp((dv - uv * du) * per, 0.0, dot(qEnd - q, v));
    if (dot(parting.normal, p - q) <= reach) points.push_back({p + s * u, q + t * v});
}

}  // namespace plait
