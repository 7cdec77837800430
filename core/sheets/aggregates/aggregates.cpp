#include "aggregates.h"

#include <algorithm>
#include <utility>

namespace plait {
namespace {

// How many nodes there are to move; what no link joins counts for nothing.
int moving(const AggregateGraph& graph) {
    int count = 0;
    for (int n = 0; n < graph.size(); ++n) count += !graph.ways.around(n).empty() && graph.moves(n);
    return count;
}

// Numbers in the order of their first use.
std::vector<int> renumbered(std::vector<int> label, int& count) {
    std::vector<int> number(label.size() * 2, -1);
    count = 0;
    for (int& l : label)
        if (l >= 0) {
            int& n = number[l];
            if (n < 0) n = count++;
            l = n;
        }
    return label;
}

// Each node with its nearest neighbour that is still alone, in the order of nodes; on a grid these
// are pairs along one direction, and pairs of pairs make squares.
std::vector<int> matched(const std::vector<Vec<double>>& rest, const Ways& ways, int& count) {
    std::vector<int> first(rest.size(), -1);
    for (int n = 0; n < static_cast<int>(rest.size()); ++n) {
        if (first[n] >= 0 || ways.around(n).empty()) continue;
        first[n] = n;
        int best = -1;
        double least = infinity;
        for (const auto& [other, unused] : ways.around(n)) {
            const double apart = length(rest[other] - rest[n]);
            if (first[other] < 0 && apart < 0.999999 * least)  // alike but for rounding: the first
                best = other, least = apart;
        }
        if (best >= 0) first[best] = n;
    }
    return renumbered(std::move(first), count);
}

// Groups that a link joins, the lower one first; sorted.
std::vector<std::array<int, 2>> joined(const Ways& ways, const std::vector<int>& parent) {
    std::vector<std::array<int, 2>> pairs;
    for (int n = 0; n < static_cast<int>(parent.size()); ++n)
        for (const auto& [other, unused] : ways.around(n)) {
            const int a = parent[n], b = parent[other];
            if (a >= 0 && a < b) pairs.push_back({a, b});
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

// Squares, or what comes near: pairs of pairs.
std::vector<int> quartered(const AggregateGraph& fine, int& count) {
    int pairs = 0;
    std::vector<int> parent = matched(fine.rest, fine.ways, pairs);
    std::vector<Vec<double>> middle(pairs, {0, 0, 0});
    std::vector<int> members(pairs, 0);
    for (int n = 0; n < fine.size(); ++n)
        if (parent[n] >= 0) middle[parent[n]] += fine.rest[n], ++members[parent[n]];
    for (int p = 0; p < pairs; ++p) middle[p] = (1.0 / members[p]) * middle[p];
    std::vector<Link> links;
    for (const auto& [a, b] : joined(fine.ways, parent)) links.push_back({a, b, 0});
    const std::vector<int> quarter = matched(middle, Ways(pairs, links), count);
    for (int n = 0; n < fine.size(); ++n) {
        if (parent[n] < 0) continue;
        // A pair without another pair beside it stays one.
        const int whole = quarter[parent[n]];
        parent[n] = whole >= 0 ? whole : count + parent[n];
    }
    return renumbered(std::move(parent), count);
}

}  // namespace

AggregatePlan::AggregatePlan(std::vector<double> mass, std::vector<Vec<double>> rest,
                             std::span<const Link> links, int fewest) {
    const int nodes = static_cast<int>(mass.size());
    graphs_.push_back({std::move(mass), std::move(rest), Ways(nodes, links)});
    while (moving(graphs_.back()) > fewest) {
        AggregateGraph& fine = graphs_.back();
        AggregateGroups groups;
        int count = 0;
        groups.parent = quartered(fine, count);
        groups.share.assign(fine.mass.size(), 0);
        groups.members.resize(count);
        for (int n = 0; n < fine.size(); ++n)
            if (groups.parent[n] >= 0) groups.members[groups.parent[n]].push_back(n);
        AggregateGraph coarse{std::vector<double>(count), std::vector<Vec<double>>(count),
                              Ways(0, {})};
        for (int a = 0; a < count; ++a) weigh(fine, groups, coarse, a);
        coarse.ways = Ways(count, bounds(fine, groups, coarse, joined(fine.ways, groups.parent)));
        visited_ += groups.visited;
        if (3 * moving(coarse) > 2 * moving(fine)) break;  // nothing left that merges
        groups_.push_back(std::move(groups));
        graphs_.push_back(std::move(coarse));
    }
}

std::vector<AggregateLevel> AggregatePlan::levels() const {
    std::vector<AggregateLevel> levels;
    for (std::size_t l = 0; l < groups_.size(); ++l) {
        const AggregateGraph& coarse = graphs_[l + 1];
        levels.push_back({groups_[l].parent, groups_[l].share, coarse.mass, {}});
        std::vector<Link>& links = levels.back().links;
        for (int a = 0; a < coarse.size(); ++a) {
            const std::size_t first = links.size();
            for (const auto& [b, length] : coarse.ways.around(a))
                if (a < b) links.push_back({a, b, length});
            std::sort(links.begin() + static_cast<std::ptrdiff_t>(first), links.end(),
                      [](const Link& x, const Link& y) { return x.b < y.b; });
        }
    }
    return levels;
}

std::vector<Link> linksOf(const Rows<Stretch>& set) {
    std::vector<Link> links;
    for (std::size_t i = 0; i < set.rows.size(); ++i)
        links.push_back({set.ids[2 * i], set.ids[2 * i + 1], set.rows[i].rest});
    return links;
}

std::vector<AggregateLevel> aggregate(std::vector<double> mass, std::vector<Vec<double>> rest,
                                      std::span<const Link> links, int fewest) {
    return AggregatePlan(std::move(mass), std::move(rest), links, fewest).levels();
}

}  // namespace plait
