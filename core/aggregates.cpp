#include "aggregates.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace plait {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A level while the next is made from it.
struct Graph {
    std::vector<double> mass;
    std::vector<Vec<double>> rest;
    std::vector<Link> links;

    int size() const { return static_cast<int>(mass.size()); }
    bool moves(int node) const { return mass[node] < infinity; }
};

// How many nodes there are to move; what no link joins counts for nothing.
int moving(const Graph& graph) {
    std::vector<bool> linked(graph.mass.size(), false);
    for (const Link& link : graph.links) linked[link.a] = linked[link.b] = true;
    int count = 0;
    for (int n = 0; n < graph.size(); ++n) count += linked[n] && graph.moves(n);
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
std::vector<int> matched(const std::vector<Vec<double>>& rest, std::span<const Link> links,
                         int& count) {
    const Ways ways(static_cast<int>(rest.size()), links);
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

std::vector<std::pair<int, int>> joined(const std::vector<Link>& links,
                                        const std::vector<int>& parent) {
    std::vector<std::pair<int, int>> pairs;
    for (const Link& link : links) {
        const int a = parent[link.a], b = parent[link.b];
        if (a >= 0 && b >= 0 && a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

// Masses, places and shares of the aggregates, without links. One with pinned members is where they
// are: nothing moves it.
Graph merged(const Graph& fine, const std::vector<int>& parent, int count,
             std::vector<double>& share) {
    Graph coarse{std::vector<double>(count, 0), std::vector<Vec<double>>(count, {0, 0, 0}), {}};
    for (int n = 0; n < fine.size(); ++n)
        if (parent[n] >= 0) coarse.mass[parent[n]] += fine.mass[n];
    share.assign(fine.mass.size(), 0);
    std::vector<int> pins(count, 0);
    for (int n = 0; n < fine.size(); ++n)
        if (parent[n] >= 0 && !fine.moves(n)) ++pins[parent[n]];
    for (int n = 0; n < fine.size(); ++n) {
        if (parent[n] < 0) continue;
        share[n] = fine.moves(n) ? fine.mass[n] / coarse.mass[parent[n]] : 1.0 / pins[parent[n]];
        coarse.rest[parent[n]] += share[n] * fine.rest[n];
    }
    return coarse;
}

// sum p_ij d_ij for a good coupling p of shares s and t: the cheapest pairs first, then exchanges
// of two against two while they gain. Any coupling is a bound; the best is the tightest.
double couplingCost(const std::vector<double>& s, const std::vector<double>& t,
                    const std::vector<std::vector<double>>& d) {
    const std::size_t m = s.size(), n = t.size();
    std::vector<double> left(s), right(t);
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> order;
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) order.push_back({d[i][j], {i, j}});
    std::sort(order.begin(), order.end());
    std::vector<std::vector<double>> p(m, std::vector<double>(n, 0));
    for (const auto& [unused, pair] : order) {
        const auto [i, j] = pair;
        p[i][j] = std::min(left[i], right[j]);
        left[i] -= p[i][j];
        right[j] -= p[i][j];
    }
    for (bool gained = true; gained;) {
        gained = false;
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t k = 0; k < m; ++k)
                for (std::size_t j = 0; j < n; ++j)
                    for (std::size_t l = 0; l < n; ++l) {
                        const double move = std::min(p[i][j], p[k][l]);
                        const double gain = d[i][j] + d[k][l] - d[i][l] - d[k][j];
                        if (move < 1e-9 || gain <= 1e-9 * (d[i][j] + d[k][l])) continue;
                        p[i][j] -= move, p[k][l] -= move;
                        p[i][l] += move, p[k][j] += move;
                        gained = true;
                    }
    }
    double cost = 0;
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) cost += p[i][j] * d[i][j];
    return cost;
}

// Bounds on the distances of aggregates that any fine link joins.
std::vector<Link> bounds(const Graph& fine, const std::vector<int>& parent,
                         const std::vector<double>& share, const Graph& coarse) {
    std::vector<std::vector<int>> members(coarse.mass.size());
    for (int n = 0; n < fine.size(); ++n)
        if (parent[n] >= 0) members[parent[n]].push_back(n);
    const auto sharesOf = [&](const std::vector<int>& nodes) {
        std::vector<double> shares;
        for (const int n : nodes) shares.push_back(share[n]);
        return shares;
    };
    std::vector<Link> links;
    Ways ways(fine.size(), fine.links);
    std::map<std::pair<int, int>, double> apart;
    const std::vector<std::pair<int, int>> pairs = joined(fine.links, parent);
    for (std::size_t i = 0; i < pairs.size();) {
        const int a = pairs[i].first;
        std::vector<int> others;
        for (; i < pairs.size() && pairs[i].first == a; ++i) others.push_back(pairs[i].second);
        apart.clear();
        for (const int n : members[a]) {
            std::size_t missing = 0;
            for (const int b : others) missing += members[b].size();
            ways.from(std::span(&n, 1), [&](int node, double distance, int) {
                if (!std::binary_search(others.begin(), others.end(), parent[node])) return true;
                apart[{n, node}] = distance;
                return --missing > 0;
            });
        }
        for (const int b : others) {
            if (!coarse.moves(a) && !coarse.moves(b)) continue;
            std::vector<std::vector<double>> d;
            for (const int n : members[a]) {
                d.emplace_back();
                for (const int o : members[b]) d.back().push_back(apart.at({n, o}));
            }
            links.push_back({a, b, couplingCost(sharesOf(members[a]), sharesOf(members[b]), d)});
        }
    }
    return links;
}

// Squares, or what comes near: pairs of pairs.
std::vector<int> quartered(const Graph& fine, int& count) {
    int pairs = 0;
    std::vector<int> parent = matched(fine.rest, fine.links, pairs);
    std::vector<Vec<double>> middle(pairs, {0, 0, 0});
    std::vector<int> members(pairs, 0);
    for (int n = 0; n < fine.size(); ++n)
        if (parent[n] >= 0) middle[parent[n]] += fine.rest[n], ++members[parent[n]];
    for (int p = 0; p < pairs; ++p) middle[p] = (1.0 / members[p]) * middle[p];
    std::vector<Link> links;
    for (const auto& [a, b] : joined(fine.links, parent)) links.push_back({a, b, 0});
    const std::vector<int> quarter = matched(middle, links, count);
    for (int n = 0; n < fine.size(); ++n) {
        if (parent[n] < 0) continue;
        // A pair without another pair beside it stays one.
        const int whole = quarter[parent[n]];
        parent[n] = whole >= 0 ? whole : count + parent[n];
    }
    return renumbered(std::move(parent), count);
}

}  // namespace

std::vector<AggregateLevel> aggregate(std::vector<double> mass, std::vector<Vec<double>> rest,
                                      std::vector<Link> links, int fewest) {
    Graph fine{std::move(mass), std::move(rest), std::move(links)};
    std::vector<AggregateLevel> levels;
    while (moving(fine) > fewest) {
        int count = 0;
        AggregateLevel level;
        level.parent = quartered(fine, count);
        Graph coarse = merged(fine, level.parent, count, level.share);
        coarse.links = bounds(fine, level.parent, level.share, coarse);
        if (3 * moving(coarse) > 2 * moving(fine)) break;  // nothing left that merges
        level.mass = coarse.mass;
        level.links = coarse.links;
        levels.push_back(std::move(level));
        fine = std::move(coarse);
    }
    return levels;
}

}  // namespace plait
