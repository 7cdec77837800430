// What a membrane is made of, when its set is made.
#include "membrane_set.h"

#include <algorithm>
#include <numeric>

namespace plait {
namespace {

// J/m of a tear at each vertex: toughness times thickness.
std::vector<double> costsOf(const World& world, const Membrane& membrane) {
    std::vector<double> costs(world.rest.size(), 0);
    for (const Membrane::Rubber& rubber : membrane.rubber)
        for (std::size_t n = 0; n < rubber.triangles.size(); ++n)
            costs[rubber.triangles[n]] =
                membrane.toughness * rubber.thickness[rubber.thickness.size() == 1 ? 0 : n / 3];
    for (std::size_t v = 0; v < costs.size(); ++v)
        if (membrane.toughnessMap && costs[v] > 0) costs[v] *= membrane.toughnessMap(world.rest[v]);
    return costs;
}

}  // namespace

template <class Real>
MembraneSet<Real>::MembraneSet(const World& world, const Membrane& membrane)
    : iterations_(membrane.iterations),
      tolerance_(membrane.tolerance),
      places_(world.start.size(), -1) {
    for (int n = 0; n < membrane.springs.size(); ++n) {
        const auto& row = membrane.springs.rows[n];
        std::array<int, 2> ends{membrane.springs.ids[2 * n], membrane.springs.ids[2 * n + 1]};
        if (world.torn && !world.torn->rename(ends)) continue;
        ends_.push_back({local(ends[0]), local(ends[1])});
        springs_.push_back({row.rest, 1 / row.compliance, 1 / row.compression});
    }
    for (const Membrane::Rubber& rubber : membrane.rubber) {
        const int law = static_cast<int>(laws_.size());
        laws_.push_back({rubber.law, rubber.relaxed});
        for (std::size_t n = 0; n < rubber.triangles.size() / 3; ++n) {
            std::array<int, 3> v{};
            std::copy_n(&rubber.triangles[3 * n], 3, v.begin());
            if (world.torn) world.torn->rename(v);
            corners_.push_back({local(v[0]), local(v[1]), local(v[2])});
            const double t = rubber.thickness[rubber.thickness.size() == 1 ? 0 : n];
            patches_.push_back(
                {Patch(world.rest[v[0]], world.rest[v[1]], world.rest[v[2]], t), law});
        }
    }
    for (const Membrane::Filling& filling : membrane.gases)
        leaves_ += filling.bursts || !filling.leak.hole.empty() ? Leak::numbers : 0;
    addLips(world, membrane);
    for (const Membrane::Filling& filling : membrane.gases) enclose(world, filling);
    const std::size_t n = ids_.size();
    for (Enclosed& gas : gases_) {
        gas.start.assign(n + 1, 0);
        for (const auto& t : std::span(gas.triangles).first(gas.acting))
            for (const int v : t) ++gas.start[v + 1];
        std::partial_sum(gas.start.begin(), gas.start.end(), gas.start.begin());
        gas.corners.resize(3 * gas.acting);
        std::vector<int> next(gas.start.begin(), gas.start.end() - 1);
        for (int t = 0; t < static_cast<int>(gas.acting); ++t)
            for (int c = 0; c < 3; ++c) gas.corners[next[gas.triangles[t][c]]++] = 3 * t + c;
        gas.gradient.resize(n);
    }
    for (std::vector<Four>* array : {&x_, &start_, &trial_, &kept_, &step_, &right_})
        array->resize(n);
    mass_.resize(n);
    inertia_.resize(n);
    springForces_.resize(ends_.size());
    springBlocks_.resize(ends_.size());
    patchForces_.resize(patches_.size());
    patchBlocks_.resize(patches_.size());
    energies_.resize(ends_.size() + patches_.size());
    system_ = std::make_unique<MembraneSystem>(static_cast<int>(n), ends_, corners_);
    findIslands();
}

// An edge that parted no vertex by itself, as the first inside a sheet, is paid for by the next
// that does.
template <class Real>
void MembraneSet<Real>::addLips(const World& world, const Membrane& membrane) {
    const auto isOurs = [&](int v) { return places_[v] >= 0; };
    for (const auto& [matter, spare] : world.tearable)
        if (membrane.toughness > 0 && isOurs(matter.first)) spare_.push_back(spare);
    if (!world.torn || spare_.empty()) return;
    const Cuts& cuts = *world.torn;
    const std::vector<double> costs = costsOf(world, membrane);
    double owed = 0;
    std::size_t next = 0;
    for (const int edge : cuts.order()) {
        const auto ends = cuts.whole().vertices(1, edge);
        const double span = length(world.rest[ends[1]] - world.rest[ends[0]]);
        owed += 0.5 * (costs[ends[0]] + costs[ends[1]]) * span;
        const std::size_t first = next;
        while (next < cuts.splits().size() && cuts.splits()[next].cut == edge) ++next;
        for (const VertexSplit& split : cuts.splits().subspan(first, next - first)) {
            if (!isOurs(split.vertex) || !isOurs(split.copy)) continue;
            ends_.push_back({local(split.vertex), local(split.copy)});
            lips_.push_back({owed / static_cast<double>(next - first), -1, 0});
            longest_.push_back(4 * span);
            lipsAt_.push_back(placeOf(split.copy));
        }
        if (next > first) owed = 0;
    }
}

// Of its lips in the drawer, behind the gases that leave.
template <class Real>
int MembraneSet<Real>::placeOf(int copy) const {
    int place = leaves_;
    for (const Range& spare : spare_) {
        if (spare.first <= copy && copy < spare.last) return place + 2 * (copy - spare.first);
        place += 2 * spare.size();
    }
    return place;
}

template <class Real>
void MembraneSet<Real>::enclose(const World& world, const Membrane::Filling& filling) {
    Enclosed gas{{}, {}, {}, filling.gas, filling.amount, 0, 0, 0, 0, {}, {}, {}};
    gas.from = gas.to = gas.gas.amount;
    std::vector<std::array<int, 3>> skin = filling.enclosure.triangles;
    if (world.torn)
        for (auto& t : skin) world.torn->rename(t);
    const auto add = [&](const std::array<int, 3>& t) {
        gas.triangles.push_back({local(t[0]), local(t[1]), local(t[2])});
    };
    std::ranges::for_each(skin, add);
    gas.acting = gas.triangles.size();
    if (!filling.leak.hole.empty())
        gas.leak.emplace(filling.leak, filling.gas, filling.enclosure.triangles, filling.riding,
                         world.mass);
    if (filling.bursts) {
        gas.burst.emplace(filling.gas, skin);
        for (const auto& fan : gas.burst->fans()) std::ranges::for_each(fan, add);
    }
    gases_.push_back(std::move(gas));
}

// The place in the set of a vertex of the world.
template <class Real>
int MembraneSet<Real>::local(int vertex) {
    int& place = places_[vertex];
    if (place < 0) {
        place = static_cast<int>(ids_.size());
        ids_.push_back(vertex);
    }
    return place;
}

// What hangs together by elements or by a surface that encloses a gas.
template <class Real>
void MembraneSet<Real>::findIslands() {
    std::vector<int> leader(ids_.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int v) {
        while (leader[v] != v) v = leader[v] = leader[leader[v]];
        return v;
    };
    const auto join = [&](int a, int b) {
        leader[std::max(find(a), find(b))] = std::min(find(a), find(b));
    };
    for (std::size_t n = 0; n < ends_.size(); ++n)
        if (n < springs_.size() || !lips_[n - springs_.size()].paid())
            join(ends_[n][0], ends_[n][1]);
    for (const auto& t : corners_) join(t[0], t[1]), join(t[1], t[2]);
    for (const Enclosed& gas : gases_)
        for (const auto& t : gas.triangles) join(t[0], t[1]), join(t[1], t[2]);
    islands_.clear();
    std::vector<int> number(ids_.size(), -1);
    for (int v = 0; v < std::ssize(ids_); ++v) {
        int& island = number[find(v)];
        if (island < 0) {
            island = static_cast<int>(islands_.size());
            islands_.emplace_back();
        }
        islands_[island].push_back(v);
    }
}

template class MembraneSet<float>;
template class MembraneSet<double>;

}  // namespace plait
