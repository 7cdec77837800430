#include "tangles.h"

#include <algorithm>

namespace plait {
namespace {

// Both ends off the plane of a b c, on different sides, and the way between them through it.
bool pierces(const Vec<double>& p, const Vec<double>& q, const Vec<double>& a, const Vec<double>& b,
             const Vec<double>& c) {
    const Vec<double> n = cross(b - a, c - a);
    const double from = dot(n, p - a), to = dot(n, q - a);
    if (!(from * to < 0)) return false;
    const Vec<double> way = q - p;
    const double u = dot(cross(a - p, b - p), way), v = dot(cross(b - p, c - p), way),
                 w = dot(cross(c - p, a - p), way);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

}  // namespace

Tangles::Tangles(const SimplicialComplex& complex, const std::vector<Surface>& surfaces,
                 std::span<const unsigned char> pinned)
    : surfaces_(surfaces), surface_(complex.count(0), -1), pinned_(pinned.begin(), pinned.end()) {
    for (std::size_t s = 0; s < surfaces_.size(); ++s)
        for (int v = surfaces_[s].vertices.first; v < surfaces_[s].vertices.last; ++v)
            surface_[v] = static_cast<int>(s);
    for (const auto& [k, table] : {std::pair{1, &edges_}, {2, &triangles_}})
        for (int i = 0; i < complex.count(k); ++i) {
            const auto ids = complex.vertices(k, i);
            const int s = surface_[ids[0]];
            if (s < 0 || !std::ranges::all_of(ids, [&](int v) { return surface_[v] == s; }))
                continue;
            table->insert(table->end(), ids.begin(), ids.end());
        }
}

bool Tangles::accepts(std::span<const int> edge, std::span<const int> triangle) const {
    const int s = surface_[edge[0]];
    if (s == surface_[triangle[0]] && surfaces_[s].self == Self::none) return false;
    bool fixed = true;
    for (const int v : edge) {
        if (std::ranges::find(triangle, v) != triangle.end()) return false;
        fixed = fixed && pinned_[v];
    }
    return !fixed || !std::ranges::all_of(triangle, [&](int v) { return pinned_[v] != 0; });
}

void Tangles::find(std::span<const Vec<double>> x, Marks& marks, Workers& workers) {
    marks.own.assign(x.size(), 0);
    marks.other.assign(x.size(), 0);
    if (edges_.empty() || triangles_.empty()) return;
    const auto at = [](const std::vector<int>& table, int arity, int i) {
        return std::span(table).subspan(std::size_t(i) * arity, arity);
    };
    const Travel still{.start = x, .end = x, .origin = x.front()};
    for (auto& [tree, table, arity] :
         {std::tuple{&edgeTree_, &edges_, 2}, {&triangleTree_, &triangles_, 3}}) {
        const auto bound = [&](int i) { return sweptBounds<slabs>(at(*table, arity, i), still); };
        if (*tree)
            (*tree)->refit(bound, workers);
        else
            *tree = std::make_unique<KDopTree<slabs>>(static_cast<int>(table->size()) / arity,
                                                      bound, workers);
    }
    edgeTree_->pairs(*triangleTree_, found_, workers, [&](int e, int t) {
        const auto edge = at(edges_, 2, e), triangle = at(triangles_, 3, t);
        return accepts(edge, triangle) &&
               pierces(x[edge[0]], x[edge[1]], x[triangle[0]], x[triangle[1]], x[triangle[2]]);
    });
    for (const Candidate& pair : found_.pairs()) {
        const auto edge = at(edges_, 2, pair.a), triangle = at(triangles_, 3, pair.b);
        auto& side = surface_[edge[0]] == surface_[triangle[0]] ? marks.own : marks.other;
        for (const auto& ids : {edge, triangle})
            for (const int v : ids) side[v] = !pinned_[v];
    }
}

}  // namespace plait
