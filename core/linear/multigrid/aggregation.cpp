#include "aggregation.h"

#include <algorithm>

namespace plait {

std::vector<int> breadthFirst(const Csr& neighbours) {
    std::vector<int> order;
    std::vector<bool> seen(static_cast<std::size_t>(neighbours.size()), false);
    const auto visit = [&](int node) {
        if (!seen[node]) order.push_back(node);
        seen[node] = true;
    };
    std::size_t next = 0;
    for (int first = 0; first < neighbours.size(); ++first)
        for (visit(first); next < order.size(); ++next)
            for (const int other : neighbours[order[next]]) visit(other);
    return order;
}

Aggregates mergeNeighbours(const Csr& neighbours) {
    const int nodes = neighbours.size();
    Aggregates all{std::vector<int>(static_cast<std::size_t>(nodes), -1), 0};
    const auto take = [&](int node) {
        all.of[node] = all.count;
        for (const int other : neighbours[node])
            if (all.of[other] < 0) all.of[other] = all.count;
        ++all.count;
    };
    const auto taken = [&](int node) { return all.of[node] >= 0; };
    for (int node = 0; node < nodes; ++node) {
        const auto around = neighbours[node];
        if (!taken(node) && !around.empty() && std::none_of(around.begin(), around.end(), taken))
            take(node);
    }
    const std::vector<int> roots = all.of;
    for (int node = 0; node < nodes; ++node)
        for (const int other : neighbours[node])
            if (all.of[node] < 0) all.of[node] = roots[other];
    for (int node = 0; node < nodes; ++node)
        if (!taken(node)) take(node);
    return all;
}

Csr quotient(const Csr& neighbours, const Aggregates& aggregates) {
    std::vector<std::vector<int>> lists(static_cast<std::size_t>(aggregates.count));
    for (int node = 0; node < neighbours.size(); ++node)
        for (const int other : neighbours[node]) {
            const int a = aggregates.of[node], b = aggregates.of[other];
            if (a != b) lists[a].push_back(b);
        }
    Csr between;
    for (std::vector<int>& list : lists) appendSorted(between, list);
    return between;
}

void appendSorted(Csr& lists, std::vector<int>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    lists.item.insert(lists.item.end(), list.begin(), list.end());
    lists.start.push_back(static_cast<int>(lists.item.size()));
}

}  // namespace plait
