#include "ways.h"

#include <limits>
#include <queue>
#include <tuple>

namespace plait {

constexpr double infinity = std::numeric_limits<double>::infinity();

Ways::Ways(int nodes, std::span<const Link> links)
    : start_(nodes + 1, 0), distance_(nodes, infinity), source_(nodes, -1) {
    for (const Link& link : links) ++start_[link.a + 1], ++start_[link.b + 1];
    for (int n = 0; n < nodes; ++n) start_[n + 1] += start_[n];
    neighbours_.resize(2 * links.size());
    std::vector<int> end(start_.begin(), start_.end() - 1);
    for (const Link& link : links) {
        neighbours_[end[link.a]++] = {link.b, link.length};
        neighbours_[end[link.b]++] = {link.a, link.length};
    }
}

// Dijkstra (1959).
void Ways::from(std::span<const int> sources, const std::function<bool(int, double, int)>& visit) {
    using Entry = std::tuple<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto reach = [&](int node, double distance, int source) {
        if (distance >= distance_[node]) return;
        if (distance_[node] == infinity) touched_.push_back(node);
        distance_[node] = distance;
        source_[node] = source;
        open.emplace(distance, node);
    };
    for (const int source : sources) reach(source, 0, source);
    while (!open.empty()) {
        const auto [distance, node] = open.top();
        open.pop();
        if (distance > distance_[node]) continue;
        if (!visit(node, distance, source_[node])) break;
        for (const Neighbour& next : around(node))
            reach(next.node, distance + next.length, source_[node]);
    }
    for (const int node : touched_) distance_[node] = infinity;
    touched_.clear();
}

}  // namespace plait
