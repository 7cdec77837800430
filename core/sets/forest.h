// Links that form chains and trees, in the order in which a system of equations over them is
// eliminated without fill: leaves first.
#pragma once

#include <span>
#include <vector>

namespace plait {

struct Forest {
    struct Node {
        int vertex;
        int parent;      // a later node, -1 for a root
        int constraint;  // joins it to its parent, -1 for a root
        int end;         // 0 or 1: which vertex of that constraint it is
    };
    std::vector<Node> nodes;    // tree by tree, children before their parent
    std::vector<int> start{0};  // where each tree begins, and where the last ends

    int trees() const { return static_cast<int>(start.size()) - 1; }
};

// `ids` holds two vertices a constraint, each an index into `pinned`. A pinned vertex passes
// nothing on: it is a node of its own in each of its constraints, and no cycle runs through it.
// Throws std::invalid_argument naming the first constraint that closes a cycle.
Forest forestOf(std::span<const int> ids, std::span<const unsigned char> pinned);

}  // namespace plait
