// What a level of aggregates is made of, and how: nodes, links that bound their distances, and the
// bounds that follow for groups of nodes.
#pragma once

#include "../../numbers/math.h"
#include "../strands/ways.h"

#include <array>
#include <vector>

namespace plait {

struct AggregateGraph {
    std::vector<double> mass;       // kg, by node; infinite: pinned
    std::vector<Vec<double>> rest;  // m, by node
    Ways ways;

    int size() const { return static_cast<int>(mass.size()); }
    bool moves(int node) const;
};

// Nodes of a graph in groups, each of which is a node of a coarser one.
struct AggregateGroups {
    std::vector<int> parent;                // by node: its group, -1 for none
    std::vector<double> share;              // by node
    std::vector<std::vector<int>> members;  // by group, ascending
    double furthest = 0;                    // m, of the ways that bounds were made of
    long visited = 0;                       // nodes on ways, and pairs, that bounds were made of
};

// Sets mass and place of a group, and the shares of its members. One with pinned members is where
// they are: nothing moves it.
void weigh(const AggregateGraph& fine, AggregateGroups& groups, AggregateGraph& coarse, int group);

// Bounds on the distances of these pairs of groups, sorted, the lower one first; none where neither
// moves. Each two members must have a way between them.
std::vector<Link> bounds(AggregateGraph& fine, AggregateGroups& groups,
                         const AggregateGraph& coarse,
                         const std::vector<std::array<int, 2>>& pairs);

}  // namespace plait
