#include "stencils.h"

#include <algorithm>

namespace plait {
namespace {

bool inside(std::span<const int> vertices, Range range) {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](int v) { return v >= range.first && v < range.last; });
}

template <class Simplex>
void append(std::vector<int>& ids, const Simplex& simplex, Range range) {
    if (inside(simplex, range)) ids.insert(ids.end(), simplex.begin(), simplex.end());
}

double area(const Vec<double>& a, const Vec<double>& b, const Vec<double>& c) {
    return length(cross(b - a, c - a)) / 2;
}

}  // namespace

std::vector<int> edgeStencils(const SimplicialComplex& complex, Range range) {
    std::vector<int> ids;
    for (int i = 0; i < complex.count(1); ++i) append(ids, complex.edge(i), range);
    return ids;
}

std::vector<int> triangleStencils(const SimplicialComplex& complex, Range range) {
    std::vector<int> ids;
    for (int i = 0; i < complex.count(2); ++i) append(ids, complex.triangle(i), range);
    return ids;
}

std::vector<int> cornerStencils(const SimplicialComplex& complex, Range range) {
    std::vector<int> ids;
    for (int i = 0; i < complex.count(2); ++i) {
        const auto [a, b, c] = complex.triangle(i);
        for (const auto& corner : {std::array{c, a, b}, std::array{a, b, c}, std::array{b, c, a}})
            append(ids, corner, range);
    }
    return ids;
}

std::vector<int> jointStencils(const SimplicialComplex& complex, Range range) {
    std::vector<int> ids;
    const std::vector<int> triangles = complex.valences(1);
    std::vector<std::vector<int>> around(static_cast<std::size_t>(complex.count(0)));
    std::vector<bool> onSurface(around.size(), false);
    for (int i = 0; i < complex.count(1); ++i) {
        const auto [a, b] = complex.edge(i);
        for (const auto& [v, other] : {std::array{a, b}, std::array{b, a}}) {
            around[static_cast<std::size_t>(v)].push_back(other);
            if (triangles[static_cast<std::size_t>(i)] > 0)
                onSurface[static_cast<std::size_t>(v)] = true;
        }
    }
    for (int v = range.first; v < range.last; ++v) {
        const std::vector<int>& ends = around[static_cast<std::size_t>(v)];
        if (ends.size() == 2 && !onSurface[static_cast<std::size_t>(v)])
            append(ids, std::array{ends[0], v, ends[1]}, range);
    }
    return ids;
}

std::vector<int> hingeStencils(const SimplicialComplex& complex, Range range) {
    std::vector<int> ids;
    for (const Hinge& hinge : complex.hinges()) append(ids, hinge.vertices, range);
    return ids;
}

std::vector<int> pointStencils(Range range) {
    std::vector<int> ids;
    for (int v = range.first; v < range.last; ++v) ids.push_back(v);
    return ids;
}

Rows<Bend> bendRows(const SimplicialComplex& complex, Range range,
                    std::span<const Vec<double>> rest, double rigidity) {
    if (rigidity == 0) return {};
    Rows<Bend> set = restRows<Bend>(hingeStencils(complex, range), rest);
    for (std::size_t i = 0; i < set.rows.size(); ++i) {
        const auto x = [&](std::size_t a) {
            return rest[static_cast<std::size_t>(set.ids[4 * i + a])];
        };
        const Vec<double> e = x(1) - x(0);
        const double a1 = area(x(0), x(1), x(2)), a2 = area(x(0), x(1), x(3));
        const bool bends = a1 > 0 && a2 > 0;
        set.rows[i].compliance = bends ? (a1 + a2) / (rigidity * dot(e, e)) : slack;
    }
    return set;
}

Rows<Angle> curveBendRows(const SimplicialComplex& complex, Range range,
                          std::span<const Vec<double>> rest, double stiffness) {
    if (stiffness == 0) return {};
    Rows<Angle> set = restRows<Angle>(jointStencils(complex, range), rest);
    for (std::size_t i = 0; i < set.rows.size(); ++i) {
        const auto x = [&](std::size_t a) {
            return rest[static_cast<std::size_t>(set.ids[3 * i + a])];
        };
        set.rows[i].compliance = (length(x(1) - x(0)) + length(x(2) - x(1))) / (2 * stiffness);
    }
    return set;
}

}  // namespace plait
