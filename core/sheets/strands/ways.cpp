#include "ways.h"

#include <queue>
#include <tuple>
#include <utility>

namespace plait {

Ways::Ways(int nodes, std::span<const Link> links)
    : neighbours_(nodes), distance_(nodes, infinity), source_(nodes, -1) {
    for (const Link& link : links) {
        neighbours_[link.a].push_back({link.b, link.length});
        neighbours_[link.b].push_back({link.a, link.length});
    }
}

double Ways::link(int a, int b) const {
    for (const Neighbour& next : around(a))
        if (next.node == b) return next.length;
    return infinity;
}

void Ways::change(const Link& link) {
    for (const auto& [from, to] : {std::pair{link.a, link.b}, {link.b, link.a}}) {
        std::vector<Neighbour>& around = neighbours_[from];
        std::erase_if(around, [&](const Neighbour& next) { return next.node == to; });
        if (link.length < infinity) around.push_back({to, link.length});
    }
}

void Ways::addNode() {
    neighbours_.emplace_back();
    distance_.push_back(infinity);
    source_.push_back(-1);
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
