#include "push_out.h"

#include "../../numbers/arctangent.h"
#include "../../numbers/convert.h"
#include "../../world.h"
#include "../search/nearest.h"
#include "push_out_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace plait {
namespace {

Vec<double> unit(const Vec<double>& a) { return divide(1.0, length(a)) * a; }

Csr fansOf(const std::vector<std::array<int, 3>>& triangles, int vertices) {
    std::vector<std::vector<int>> lists(vertices);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const int v : triangles[t]) lists[v].push_back(static_cast<int>(t));
    Csr fans;
    for (const auto& list : lists) {
        fans.item.insert(fans.item.end(), list.begin(), list.end());
        fans.start.push_back(static_cast<int>(fans.item.size()));
    }
    return fans;
}

std::vector<std::array<int, 3>> trianglesOf(const SimplicialComplex& complex, Range mesh) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < complex.count(2); ++t) {
        const auto ids = complex.vertices(2, t);  // ascending
        if (ids[0] >= mesh.first && ids[2] < mesh.last) triangles.push_back(complex.triangle(t));
    }
    return triangles;
}

// Each edge runs once one way and once the other.
bool closed(const std::vector<std::array<int, 3>>& triangles) {
    std::map<std::pair<int, int>, int> ways;
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) ++ways[{t[i], t[(i + 1) % 3]}];
    return !triangles.empty() && std::ranges::all_of(ways, [&](const auto& way) {
        const auto back = ways.find({way.first.second, way.first.first});
        return way.second == 1 && back != ways.end() && back->second == 1;
    });
}

}  // namespace

template <class Real>
PushOutSet<Real>::PushOutSet(const World& world, Range mesh, const std::vector<Range>& points,
                             const PushOutOptions& options)
    : options_(options),
      triangles_(trianglesOf(world.complex, mesh)),
      fans_(fansOf(triangles_, world.complex.count(0))),
      x_(world.start) {
    for (const Range& range : points)
        for (int v = range.first; v < range.last; ++v)
            if (!world.pinned[v] && (v < mesh.first || v >= mesh.last)) points_.push_back(v);
}

template <class Real>
void PushOutSet<Real>::locate(const Sweep<Real>& sweep, Workers& workers) {
    for (std::size_t v = 0; v < x_.size(); ++v) {
        const Real* const p = sweep.particles + 8 * v;
        x_[v] = three(p) + three(p + 4);
    }
    Travel still{.start = x_, .end = x_, .origin = x_.front()};
    const auto fit = [&](auto& tree, int count, const auto& bound) {
        if (tree)
            tree->refit(bound, workers);
        else
            tree = std::make_unique<KDopTree<slabs>>(count, bound, workers);
    };
    fit(triangleTree_, static_cast<int>(triangles_.size()),
        [&](int i) { return sweptBounds<slabs>(std::span<const int>(triangles_[i]), still); });
    still.radius = std::max(options_.radius, options_.thickness);
    fit(pointTree_, static_cast<int>(points_.size()),
        [&](int i) { return sweptBounds<slabs>(std::span(points_).subspan(i, 1), still); });
}

template <class Real>
std::array<Vec<double>, 3> PushOutSet<Real>::cornersOf(int triangle) const {
    const auto& t = triangles_[triangle];
    return {x_[t[0]], x_[t[1]], x_[t[2]]};
}

// That of the face; on an edge the mean of two; at a corner the mean by angles: the way from there
// to a point then tells on which side it is (Baerentzen and Aanaes 2005).
template <class Real>
Vec<double> PushOutSet<Real>::normalAt(int triangle, const std::array<double, 3>& weight) const {
    std::array<int, 3> corners{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (weight[i] != 0) corners[count++] = triangles_[triangle][i];
    Vec<double> sum{};
    for (const int t : fans_[corners[0]]) {
        const auto& ids = triangles_[t];
        const bool all = std::ranges::all_of(std::span(corners).first(count), [&](int c) {
            return std::ranges::find(ids, c) != ids.end();
        });
        if (!all) continue;
        const auto x = cornersOf(t);
        const auto at = std::size_t(std::ranges::find(ids, corners[0]) - ids.begin());
        const Vec<double> u = x[(at + 1) % 3] - x[at], v = x[(at + 2) % 3] - x[at], n = cross(u, v);
        const double angle = count > 1 ? 1 : arctangent2(length(n), dot(u, v));
        sum += angle * unit(n);
    }
    return unit(sum);
}

template <class Real>
long PushOutSet<Real>::finish(const Sweep<Real>& sweep, Workers& workers) {
    const long last = again_ ? static_cast<long>(pushes_.size()) : 0;
    again_ = true;
    pushes_.clear();
    if (points_.empty()) return 0;
    locate(sweep, workers);
    pointTree_->pairs(*triangleTree_, found_, workers);
    counts_.pairs = std::max(counts_.pairs, static_cast<long>(found_.pairs().size()));
    near_.clear();
    for (const Candidate& pair : found_.pairs()) {
        const int v = points_[pair.a];
        const auto corners = cornersOf(pair.b);
        const Nearest at =
            nearest({{v, 0, 1, 2}, 1, 3}, {x_[v], corners[0], corners[1], corners[2]});
        near_.push_back({.vertex = v,
                         .triangle = pair.b,
                         .distance = length(at.apart),
                         .way = at.apart,
                         .out = {},
                         .weight = {-at.weight[1], -at.weight[2], -at.weight[3]}});
    }
    std::ranges::sort(near_, {},
                      [](const Push& p) { return std::tuple(p.vertex, p.distance, p.triangle); });
    for (std::size_t i = 0; i < near_.size(); ++i) {
        Push push = near_[i];
        if (i > 0 && near_[i - 1].vertex == push.vertex) continue;
        const Vec<double> normal = normalAt(push.triangle, push.weight);
        const double side = dot(normal, push.way) < 0 ? -1 : 1, height = side * push.distance;
        if (height <= -options_.radius || height >= options_.thickness) continue;
        push.out = push.distance > 0 ? side * unit(push.way) : normal;
        push.way = options_.strength * (options_.thickness - height) * push.out;
        pushes_.push_back(push);
    }
    counts_.pushed += static_cast<long>(pushes_.size()) - last;
    return 0;
}

// Where it was earlier is moved along, for BDF2.
template <class Real>
void PushOutSet<Real>::rebound(State<Real>& state, Drawer<Real>&) const {
    for (const Push& push : pushes_) {
        state.particles[push.vertex].d += as<Real>(push.way);
        if (!state.last.empty()) state.last[push.vertex].v += as<Real>(push.way);
        for (auto* array : {&state.velocity, &state.lastVelocity}) {
            if (array->empty()) continue;
            const auto velocity = [&](int v) { return as<double>((*array)[v].v); };
            Vec<double> against = velocity(push.vertex);
            for (std::size_t i = 0; i < 3; ++i)
                against -= push.weight[i] * velocity(triangles_[push.triangle][i]);
            const double approach = std::min(dot(against, push.out), 0.0);
            (*array)[push.vertex].v -= as<Real>(approach * push.out);
        }
    }
}

template class PushOutSet<float>;
template class PushOutSet<double>;

void pushOut(World& world, Range mesh, const std::vector<Range>& points,
             const PushOutOptions& options) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(options.name + ": " + what);
    };
    const auto there = [&](const Range& range) {
        return range.first >= 0 && range.last <= world.complex.count(0) && range.size() > 0;
    };
    if (!there(mesh) || !std::ranges::all_of(points, there)) refuse("vertices that are not there");
    if (!(options.strength >= 0 && options.strength <= 2)) refuse("strength is from 0 to 2");
    if (!(options.radius >= 0 && std::isfinite(options.radius) && options.thickness >= 0 &&
          std::isfinite(options.thickness)))
        refuse("radius and thickness are at least 0");
    if (!closed(trianglesOf(world.complex, mesh)))
        refuse("a mesh that is not closed has no inside");
    const auto make = [mesh, points, options]<class Real>(const World& made, KernelChoice) {
        return std::make_unique<PushOutSet<Real>>(made, mesh, points, options);
    };
    world.constrain(recipeOf<Constraint>(make), {.name = options.name, .order = options.order},
                    true);
}

}  // namespace plait
