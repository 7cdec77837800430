// Sheets that are cut: which edges, and the mesh that would have been cut from the start.
#pragma once

#include "falling_sheets.h"

#include <functional>

namespace plait::test {

// Edges with one end where `side` holds and one where it does not, wholly within `where`.
inline std::vector<int> across(const SimplicialComplex& complex,
                               const std::function<bool(int vertex)>& side,
                               const std::function<bool(int vertex)>& where) {
    std::vector<int> edges;
    for (int e = 0; e < complex.count(1); ++e) {
        const auto [a, b] = complex.edge(e);
        if (side(a) != side(b) && where(a) && where(b)) edges.push_back(e);
    }
    return edges;
}

inline std::vector<int> someEdges(const SimplicialComplex& complex, int count, Random& random) {
    std::vector<int> edges;
    while (count-- > 0) edges.push_back(random.below(complex.count(1)));
    return edges;
}

// Without these edges and the triangles on them; the triangles' other edges stay.
inline SimplicialComplex without(const SimplicialComplex& complex, const std::vector<int>& cut) {
    std::vector<bool> gone(static_cast<std::size_t>(complex.count(1)), false);
    for (const int e : cut) gone[static_cast<std::size_t>(e)] = true;
    Simplices kept;
    for (int e = 0; e < complex.count(1); ++e)
        if (!gone[static_cast<std::size_t>(e)]) kept.edges.push_back(complex.edge(e));
    for (int t = 0; t < complex.count(2); ++t) {
        const std::span<const int> sides = complex.faces(2, t);
        if (std::none_of(sides.begin(), sides.end(),
                         [&](int e) { return gone[static_cast<std::size_t>(e)]; }))
            kept.triangles.push_back(complex.triangle(t));
    }
    return SimplicialComplex(complex.count(0), kept);
}

// Wound half around an axis along z.
inline Shape wound(Shape shape) {
    for (Vec<double>& x : shape.positions)
        x = {std::cos(pi * x.x) / pi, std::sin(pi * x.x) / pi, x.z};
    return shape;
}

// A dome of 0.4 m over a square of 1 m.
inline Shape domed(Shape shape) {
    for (Vec<double>& x : shape.positions) x.y += 0.4 * std::sin(pi * x.x) * std::sin(-pi * x.z);
    return shape;
}

}  // namespace plait::test
