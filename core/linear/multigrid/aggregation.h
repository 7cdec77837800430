// What smoothed aggregation knows of a graph before it sees a number.
#pragma once

#include "../../complex/csr.h"

#include <vector>

namespace plait {

// Nodes in an order in which neighbours are close: breadth first, from the first of each island.
std::vector<int> breadthFirst(const Csr& neighbours);

struct Aggregates {
    std::vector<int> of;  // by node
    int count = 0;
};

// A node and all its neighbours where none of them is taken; what is left goes to a neighbour's
// (Vanek, Mandel, Brezina, "Algebraic multigrid by smoothed aggregation", 1996, algorithm 2).
Aggregates mergeNeighbours(const Csr& neighbours);

// Of aggregates: those that have neighbours in each other.
Csr quotient(const Csr& neighbours, const Aggregates& aggregates);

// Sorts a list and appends it, each item once.
void appendSorted(Csr& lists, std::vector<int>& list);

}  // namespace plait
