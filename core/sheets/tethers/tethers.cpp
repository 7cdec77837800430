#include "tethers.h"

#include <stdexcept>
#include <string>

namespace plait {
namespace {

// Anchors that edges join, together: a hoist is one.
std::vector<std::vector<int>> groupsOf(const SimplicialComplex& complex,
                                       std::span<const int> anchors) {
    std::vector<bool> waits(static_cast<std::size_t>(complex.count(0)), false);
    for (const int v : anchors) {
        if (v < 0 || v >= complex.count(0))
            throw std::invalid_argument("tethers: there is no vertex " + std::to_string(v));
        waits[static_cast<std::size_t>(v)] = true;
    }
    const Csr ring = complex.oneRing();
    std::vector<std::vector<int>> groups;
    for (const int anchor : anchors) {
        if (!waits[static_cast<std::size_t>(anchor)]) continue;
        waits[static_cast<std::size_t>(anchor)] = false;
        std::vector<int> group{anchor};
        for (std::size_t i = 0; i < group.size(); ++i)
            for (const int v : ring[group[i]])
                if (waits[static_cast<std::size_t>(v)]) {
                    waits[static_cast<std::size_t>(v)] = false;
                    group.push_back(v);
                }
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace

TetherPlan::TetherPlan(const SimplicialComplex& complex, Range range,
                       std::span<const Vec<double>> rest, std::span<const int> anchors)
    : rest_(rest.begin(), rest.end()),
      isAnchor_(rest.size(), false),
      surface_(std::make_unique<Geodesics>(complex, range, rest)),
      range_(range) {
    for (const std::vector<int>& group : groupsOf(complex, anchors))
        lights_.emplace_back(*surface_, group);
    for (const int v : anchors) isAnchor_[v] = true;
}

void TetherPlan::cut(std::span<const int> edges) {
    const Geodesics::Cut cut = surface_->cutOf(edges);
    for (Geodesics::Light& light : lights_) light.darken(cut);
    surface_->take(cut);
    for (Geodesics::Light& light : lights_) light.relight();
}

Tethers TetherPlan::tethers() const {
    Tethers tethers;
    for (const Geodesics::Light& light : lights_)
        for (int v = range_.first; v < range_.last; ++v) {
            const auto& [length, anchor] = light.ways()[v];
            if (anchor < 0 || isAnchor_[v]) continue;
            tethers.set.ids.push_back(v);
            tethers.set.rows.push_back({rest_[anchor], length});
            tethers.anchors.push_back(anchor);
        }
    return tethers;
}

long TetherPlan::visited() const {
    long sum = 0;
    for (const Geodesics::Light& light : lights_) sum += light.visited();
    return sum;
}

Tethers tethersOf(const SimplicialComplex& complex, Range range, std::span<const Vec<double>> rest,
                  std::span<const int> anchors) {
    return TetherPlan(complex, range, rest, anchors).tethers();
}

}  // namespace plait
