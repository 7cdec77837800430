#include "clusters.h"

#include "../numbers/convert.h"
#include "nearest_turn.h"

#include <algorithm>
#include <numeric>

namespace plait {

Clusters::Clusters(const World& world)
    : pieces_(world.pieces),
      start_(world.start),
      mass_(world.mass),
      pinned_(world.pinned),
      leaders_(world.pieces.size()) {}

void Clusters::join(std::span<const Weld> welds, std::span<const std::int32_t> holds) {
    std::iota(leaders_.begin(), leaders_.end(), 0);
    const auto leaderOf = [&](int p) {
        while (leaders_[p] != p) p = leaders_[p] = leaders_[leaders_[p]];
        return p;
    };
    for (std::size_t i = 0; i < welds.size(); ++i) {
        if (!holds[i]) continue;
        const int a = leaderOf(welds[i].first), b = leaderOf(welds[i].second);
        leaders_[std::max(a, b)] = std::min(a, b);
    }
    std::vector<int> place(leaders_.size(), -1);
    all_.clear();
    for (int p = 0; p < std::ssize(leaders_); ++p) {
        const int leader = leaders_[p] = leaderOf(p);
        if (leader == p) {
            place[p] = static_cast<int>(all_.size());
            all_.emplace_back();
        }
        all_[place[leader]].pieces.push_back(p);
    }
    for (int i = 0; i < std::ssize(welds); ++i)
        if (holds[i]) all_[place[leaders_[welds[i].first]]].welds.push_back(i);
    for (Cluster& cluster : all_) describe(cluster);
}

template <class Visit>
void Clusters::forVertices(const Cluster& cluster, const Visit& visit) const {
    for (const int p : cluster.pieces)
        for (int v = pieces_[p].first; v < pieces_[p].last; ++v) visit(v);
}

void Clusters::describe(Cluster& cluster) const {
    double mass = 0;
    forVertices(cluster, [&](int v) {
        mass += mass_[v];
        cluster.centre += mass_[v] * start_[v];
        cluster.pinned |= pinned_[v] != 0;
    });
    cluster.centre = (1 / mass) * cluster.centre;
    constexpr double firm = 1e6;
    cluster.firm = firm * mass;
    const int any = pieces_[cluster.pieces[0]].first;
    const auto farthest = [&](const auto& distance) {
        int best = any;
        double most = -1;
        forVertices(cluster, [&](int v) {
            if (const double d = distance(v); d > most) most = d, best = v;
        });
        return best;
    };
    const auto& x = start_;
    const int a = farthest([&](int v) { return length(x[v] - x[any]); });
    const int b = farthest([&](int v) { return length(x[v] - x[a]); });
    const int c = farthest([&](int v) { return length(cross(x[v] - x[a], x[b] - x[a])); });
    cluster.base = {a, b, c};
}

namespace {

template <class Real>
Vec<double> placeOf(const Sweep<Real>& sweep, int v) {
    const Real* const p = sweep.particles + 8 * v;
    return three(p) + three(p + 4);
}

}  // namespace

template <class Real>
ClusterPose Clusters::poseOf(const Sweep<Real>& sweep, const Cluster& cluster) const {
    const Vec<double> origin = placeOf(sweep, cluster.base[0]);
    Vec<double> where{}, heavy{};
    double mass = 0;
    const auto weight = [&](int v) { return pinned_[v] ? cluster.firm : mass_[v]; };
    forVertices(cluster, [&](int v) {
        mass += weight(v);
        where += weight(v) * (placeOf(sweep, v) - origin);
        heavy += weight(v) * (start_[v] - cluster.centre);
    });
    where = origin + (1 / mass) * where;
    heavy = (1 / mass) * heavy;
    Outer sum;
    forVertices(cluster, [&](int v) {
        sum.add(weight(v), placeOf(sweep, v) - where, start_[v] - cluster.centre - heavy);
    });
    const auto& [a, b, c] = cluster.base;
    const Rotation guess = frameOf(placeOf(sweep, b) - origin, placeOf(sweep, c) - origin) *
                           frameOf(start_[b] - start_[a], start_[c] - start_[a]).inverse();
    const Rotation turn = nearestTurn(sum, guess);
    return {where - turn * heavy, turn};
}

template <class Real>
void Clusters::put(const Sweep<Real>& sweep, const Cluster& cluster,
                   const ClusterPose& pose) const {
    forVertices(cluster, [&](int v) {
        Real* const p = sweep.particles + 8 * v;
        if (p[3] == Real(0)) return;
        plait::put(p + 4, pose.to + pose.turn * (start_[v] - cluster.centre) - three(p));
    });
}

template ClusterPose Clusters::poseOf(const Sweep<float>&, const Cluster&) const;
template ClusterPose Clusters::poseOf(const Sweep<double>&, const Cluster&) const;
template void Clusters::put(const Sweep<float>&, const Cluster&, const ClusterPose&) const;
template void Clusters::put(const Sweep<double>&, const Cluster&, const ClusterPose&) const;

}  // namespace plait
