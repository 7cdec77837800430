#include "weld.h"

#include "../measure/surfaces/box_tree.h"

#include <algorithm>
#include <numeric>

namespace plait {
namespace {

using Pair = std::array<int, 2>;

constexpr double collapsed = 1e-6;  // an edge, of the mesh's size

// Of the edges; 0 where there is none.
double meanEdge(const Shape& mesh) {
    double sum = 0;
    for (int e = 0; e < mesh.complex.count(1); ++e) {
        const auto [a, b] = mesh.complex.edge(e);
        sum += length(mesh.positions[a] - mesh.positions[b]);
    }
    return divide(sum, double(mesh.complex.count(1)));
}

std::vector<int> onOpenEdges(const SimplicialComplex& complex) {
    const std::vector<int> valences = complex.valences(1);
    std::vector<int> open;
    for (int e = 0; e < complex.count(1); ++e)
        if (valences[e] < 2)
            for (const int v : complex.vertices(1, e)) open.push_back(v);
    std::ranges::sort(open);
    open.erase(std::unique(open.begin(), open.end()), open.end());
    return open;
}

// Pairs of these vertices that are no further apart, but for those that an edge joins.
std::vector<Pair> pairsWithin(const Shape& mesh, const std::vector<int>& vertices,
                              double distance) {
    const Csr ring = mesh.complex.oneRing();
    const Vec<double> margin{distance, distance, distance};
    std::vector<Box> boxes;
    for (const int v : vertices) boxes.push_back({mesh.positions[v], mesh.positions[v]});
    const BoxTree tree(std::move(boxes));
    std::vector<Pair> pairs;
    for (const int v : vertices) {
        const Vec<double>& x = mesh.positions[v];
        tree.overlaps({x - margin, x + margin}, [&](int i) {
            const int other = vertices[i];
            if (v < other && length(x - mesh.positions[other]) <= distance &&
                !std::ranges::binary_search(ring[v], other))
                pairs.push_back({v, other});
        });
    }
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace

Weld weldOf(const Shape& mesh) {
    const auto [low, high] = boxOf(mesh.positions);
    const double size = length(high - low), edge = meanEdge(mesh);
    const double same = std::min(1e-4 * size, edge / 20);
    Weld weld;
    weld.into.resize(mesh.positions.size());
    std::iota(weld.into.begin(), weld.into.end(), 0);
    const auto root = [&](int v) {
        while (weld.into[v] != v) v = weld.into[v] = weld.into[weld.into[v]];
        return v;
    };
    const auto join = [&](int a, int b) {
        a = root(a), b = root(b);
        weld.into[std::max(a, b)] = std::min(a, b);
    };
    const auto distance = [&](int a, int b) {
        return length(mesh.positions[a] - mesh.positions[b]);
    };
    for (int e = 0; e < mesh.complex.count(1); ++e)
        if (const auto [a, b] = mesh.complex.edge(e); distance(a, b) <= collapsed * size)
            join(a, b);
    for (const Pair& pair : pairsWithin(mesh, onOpenEdges(mesh.complex), edge / 10))
        if (distance(pair[0], pair[1]) <= same)
            join(pair[0], pair[1]);
        else
            weld.apart.push_back(pair);
    for (int v = 0; v < static_cast<int>(weld.into.size()); ++v) weld.into[v] = root(v);
    return weld;
}

}  // namespace plait
