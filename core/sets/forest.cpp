#include "forest.h"

#include "../complex/csr.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

// Joins trees constraint by constraint; one whose ends are in the same tree already closes a cycle.
void refuseCycles(std::span<const int> ids, std::span<const unsigned char> pinned) {
    std::vector<int> above(pinned.size());
    std::iota(above.begin(), above.end(), 0);
    const auto root = [&](int v) {
        while (above[v] != v) v = above[v] = above[above[v]];
        return v;
    };
    for (std::size_t i = 0; i < ids.size(); i += 2) {
        const int a = ids[i], b = ids[i + 1];
        if (pinned[a] || pinned[b]) continue;
        if (root(a) == root(b))
            throw std::invalid_argument("constraint " + std::to_string(i / 2) +
                                        " between vertices " + std::to_string(a) + " and " +
                                        std::to_string(b) +
                                        " closes a cycle; a direct solve needs chains or trees");
        above[root(a)] = root(b);
    }
}

// Where a constraint can be reached from: its ends that move, or the second where neither does.
bool leads(std::span<const int> ids, std::span<const unsigned char> pinned, int constraint,
           int end) {
    const int v = ids[2 * constraint + end], other = ids[2 * constraint + 1 - end];
    return !pinned[v] || (pinned[other] && end == 1);
}

// The constraints that lead on from each vertex.
Csr constraintsAt(std::span<const int> ids, std::span<const unsigned char> pinned) {
    const int count = static_cast<int>(ids.size()) / 2;
    Csr at;
    at.start.assign(pinned.size() + 1, 0);
    const auto each = [&](const auto& visit) {
        for (int i = 0; i < count; ++i)
            for (const int end : {0, 1})
                if (leads(ids, pinned, i, end)) visit(i, ids[2 * i + end]);
    };
    each([&](int, int v) { ++at.start[v + 1]; });
    std::partial_sum(at.start.begin(), at.start.end(), at.start.begin());
    at.item.resize(at.start.back());
    std::vector<int> next(at.start.begin(), at.start.end() - 1);
    each([&](int i, int v) { at.item[next[v]++] = i; });
    return at;
}

}  // namespace

Forest forestOf(std::span<const int> ids, std::span<const unsigned char> pinned) {
    refuseCycles(ids, pinned);
    const Csr at = constraintsAt(ids, pinned);
    const int count = static_cast<int>(ids.size()) / 2;
    std::vector<bool> taken(count, false);
    Forest forest;
    std::vector<Forest::Node>& nodes = forest.nodes;
    for (int i = 0; i < count; ++i) {
        if (taken[i]) continue;
        const int first = forest.start.back();
        nodes.push_back({ids[2 * i + (leads(ids, pinned, i, 0) ? 0 : 1)], -1, -1, 0});
        // Breadth first, with the nodes found so far as the queue.
        for (int k = first; k < static_cast<int>(nodes.size()); ++k) {
            const int v = nodes[k].vertex;
            for (const int c : at[v]) {
                if (taken[c]) continue;
                taken[c] = true;
                const int end = ids[2 * c] == v ? 1 : 0;
                nodes.push_back({ids[2 * c + end], k, c, end});
            }
        }
        // Turned round, children come before their parents.
        const int last = static_cast<int>(nodes.size());
        std::reverse(nodes.begin() + first, nodes.end());
        for (int k = first; k < last; ++k)
            if (nodes[k].parent >= 0) nodes[k].parent = first + last - 1 - nodes[k].parent;
        forest.start.push_back(last);
    }
    return forest;
}

}  // namespace plait
