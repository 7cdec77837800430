// The part of aggregates.h that follows a cut, level by level.
#include "aggregates.h"

#include <algorithm>
#include <map>
#include <set>

namespace plait {
namespace {

constexpr std::size_t mostMembers = 8;  // members: couplings cost the fourth power

}  // namespace

void AggregatePlan::cut(std::span<const std::array<int, 2>> links) {
    visited_ = 0;
    Change change;
    for (const auto& [a, b] : links)
        if (graphs_[0].ways.link(a, b) < infinity) change.links.push_back({a, b, infinity});
    for (std::size_t l = 0; l < groups_.size(); ++l) change = follow(l, change);
    for (const Link& link : change.links) graphs_.back().ways.change(link);
}

// How far the ends of changed links are, by group, where a bound may have been made of a way that
// far.
struct AggregatePlan::Near {
    std::map<int, double> distance;
    double furthest;

    // Every way between two groups along a changed link is at least as long as they are far from
    // its ends, both together.
    bool between(int a, int b) const {
        const auto at = distance.find(a), bt = distance.find(b);
        return at != distance.end() && bt != distance.end() &&
               at->second + bt->second <= furthest * (1 + 1e-9);
    }
};

AggregatePlan::Near AggregatePlan::nearTo(std::size_t level, const Change& change) {
    const AggregateGroups& groups = groups_[level];
    Near near{{}, groups.furthest};
    std::vector<int> ends;
    for (const Link& link : change.links) ends.insert(ends.end(), {link.a, link.b});
    graphs_[level].ways.from(ends, [&](int node, double distance, int) {
        ++visited_;
        if (distance > groups.furthest * (1 + 1e-9)) return false;
        if (groups.parent[node] >= 0) near.distance.try_emplace(groups.parent[node], distance);
        return true;
    });
    return near;
}

// A group beside its twin, so far without members.
int AggregatePlan::addGroup(std::size_t level, int twin) {
    AggregateGraph& coarse = graphs_[level + 1];
    const int group = coarse.size();
    groups_[level].members.emplace_back();
    coarse.mass.push_back(0);
    coarse.rest.push_back({0, 0, 0});
    coarse.ways.addNode();
    if (level + 1 == groups_.size()) return group;
    AggregateGroups& above = groups_[level + 1];
    const int parent = above.parent[twin];
    above.parent.push_back(parent);
    above.share.push_back(0);
    if (parent >= 0) above.members[parent].push_back(group);
    return group;
}

// Parts groups that may have come apart, or whose members have, and weighs them again. Returns
// them and what is new, ascending.
std::vector<int> AggregatePlan::regroup(std::size_t level, const Change& change) {
    AggregateGraph& fine = graphs_[level];
    AggregateGroups& groups = groups_[level];
    std::set<int> concerned;
    for (const int n : change.nodes)
        if (groups.parent[n] >= 0) concerned.insert(groups.parent[n]);
    for (const Link& link : change.links)
        if (groups.parent[link.a] >= 0 && groups.parent[link.a] == groups.parent[link.b])
            concerned.insert(groups.parent[link.a]);
    std::vector<int> changed(concerned.begin(), concerned.end());
    for (const int group : concerned) {
        const std::vector<int> members = groups.members[group];
        for (const int n : members) groups.parent[n] = -1;
        groups.members[group].clear();
        for (const int first : members) {
            if (groups.parent[first] >= 0) continue;
            const bool fresh = !groups.members[group].empty();
            const int own = fresh ? addGroup(level, group) : group;
            if (fresh) changed.push_back(own);
            std::vector<int> part{first};
            groups.parent[first] = own;
            for (std::size_t i = 0; i < part.size(); ++i)
                for (const auto& [other, unused] : fine.ways.around(part[i]))
                    if (part.size() < mostMembers && groups.parent[other] < 0 &&
                        std::binary_search(members.begin(), members.end(), other)) {
                        groups.parent[other] = own;
                        part.push_back(other);
                    }
            std::sort(part.begin(), part.end());
            groups.members[own] = std::move(part);
            weigh(fine, groups, graphs_[level + 1], own);
            visited_ += static_cast<long>(groups.members[own].size());
        }
    }
    return changed;
}

AggregatePlan::Change AggregatePlan::follow(std::size_t level, const Change& change) {
    AggregateGraph& fine = graphs_[level];
    AggregateGraph& coarse = graphs_[level + 1];
    AggregateGroups& groups = groups_[level];
    const Near near = nearTo(level, change);
    for (const Link& link : change.links) fine.ways.change(link);
    Change next{regroup(level, change), {}};

    std::set<int> around(next.nodes.begin(), next.nodes.end());
    for (const auto& [group, unused] : near.distance) around.insert(group);
    std::set<std::array<int, 2>> joined, known;
    const auto add = [&](std::set<std::array<int, 2>>& pairs, int a, int b) {
        const auto changed = [&](int g) {
            return std::binary_search(next.nodes.begin(), next.nodes.end(), g);
        };
        if (b >= 0 && a != b && (changed(a) || changed(b) || near.between(a, b)))
            pairs.insert({std::min(a, b), std::max(a, b)});
    };
    for (const int a : around) {
        for (const int n : groups.members[a])
            for (const auto& [other, unused] : fine.ways.around(n))
                add(joined, a, groups.parent[other]);
        for (const auto& [b, unused] : coarse.ways.around(a)) add(known, a, b);
    }
    groups.visited = 0;
    std::map<std::array<int, 2>, double> found;
    for (const auto& [a, b, length] : bounds(fine, groups, coarse, {joined.begin(), joined.end()}))
        found[{a, b}] = length;
    visited_ += groups.visited;
    for (const std::array<int, 2>& pair : known) found.try_emplace(pair, infinity);
    for (const auto& [pair, length] : found)
        if (length != coarse.ways.link(pair[0], pair[1]))
            next.links.push_back({pair[0], pair[1], length});
    return next;
}

}  // namespace plait
