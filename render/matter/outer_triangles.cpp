#include "outer_triangles.h"

#include <algorithm>
#include <utility>

namespace plait {

bool liesIn(std::span<const int> vertices, Range range) {
    return std::ranges::all_of(vertices, [&](int v) { return range.first <= v && v < range.last; });
}

std::vector<std::array<int, 3>> outerTriangles(const SimplicialComplex& complex,
                                               std::span<const Vec<double>> rest, Range range) {
    const Csr parents = complex.parents(2);
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < complex.count(2); ++i) {
        if (!liesIn(complex.vertices(2, i), range) || parents[i].size() > 1) continue;
        auto t = complex.triangle(i);
        if (parents[i].size() == 1) {
            Vec<double> center{0, 0, 0};
            for (const int v : complex.vertices(3, parents[i][0])) center += 0.25 * rest[v];
            const auto normal = cross(rest[t[1]] - rest[t[0]], rest[t[2]] - rest[t[0]]);
            if (dot(normal, center - rest[t[0]]) > 0) std::swap(t[1], t[2]);
        }
        for (int& v : t) v -= range.first;
        triangles.push_back(t);
    }
    return triangles;
}

}  // namespace plait
