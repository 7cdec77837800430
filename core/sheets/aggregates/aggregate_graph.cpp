#include "aggregate_graph.h"

#include <algorithm>
#include <map>
#include <utility>

namespace plait {
namespace {

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

}  // namespace

bool AggregateGraph::moves(int node) const { return mass[node] < infinity; }

void weigh(const AggregateGraph& fine, AggregateGroups& groups, AggregateGraph& coarse, int group) {
    double& mass = coarse.mass[group] = 0;
    Vec<double>& rest = coarse.rest[group] = {0, 0, 0};
    int pins = 0;
    for (const int n : groups.members[group]) {
        mass += fine.mass[n];
        if (!fine.moves(n)) ++pins;
    }
    for (const int n : groups.members[group]) {
        const double share = fine.moves(n) ? fine.mass[n] / mass : 1.0 / pins;
        groups.share[n] = share;
        rest += share * fine.rest[n];
    }
}

std::vector<Link> bounds(AggregateGraph& fine, AggregateGroups& groups,
                         const AggregateGraph& coarse,
                         const std::vector<std::array<int, 2>>& pairs) {
    const auto& members = groups.members;
    const auto sharesOf = [&](int group) {
        std::vector<double> shares;
        for (const int n : members[group]) shares.push_back(groups.share[n]);
        return shares;
    };
    std::vector<Link> links;
    std::map<std::array<int, 2>, double> apart;
    for (std::size_t i = 0; i < pairs.size();) {
        const int a = pairs[i][0];
        std::vector<int> others;
        for (; i < pairs.size() && pairs[i][0] == a; ++i) others.push_back(pairs[i][1]);
        apart.clear();
        for (const int n : members[a]) {
            std::size_t missing = 0;
            for (const int b : others) missing += members[b].size();
            fine.ways.from(std::span(&n, 1), [&](int node, double distance, int) {
                ++groups.visited;
                if (!std::binary_search(others.begin(), others.end(), groups.parent[node]))
                    return true;
                apart[{n, node}] = distance;
                groups.furthest = std::max(groups.furthest, distance);
                return --missing > 0;
            });
        }
        for (const int b : others) {
            ++groups.visited;
            if (!coarse.moves(a) && !coarse.moves(b)) continue;
            std::vector<std::vector<double>> d;
            for (const int n : members[a]) {
                d.emplace_back();
                for (const int o : members[b]) d.back().push_back(apart.at({n, o}));
            }
            links.push_back({a, b, couplingCost(sharesOf(a), sharesOf(b), d)});
        }
    }
    return links;
}

}  // namespace plait
