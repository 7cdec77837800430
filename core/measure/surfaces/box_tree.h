// A tree of axis-aligned boxes round fixed items: which of them overlap a query box. Independent of
// the solver's collision structures. Exact: boxes are minima and maxima of the coordinates given.
#pragma once

#include <span>
#include <vector>

#include "../../numbers/math.h"

namespace plait {

struct Box {
    Vec<double> low, high;

    // Closed boxes: those that touch overlap.
    bool overlaps(const Box& b) const {
        return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
               low.z <= b.high.z && b.low.z <= high.z;
    }
};

// The box of some points, of which there is at least one.
Box boxOf(std::span<const Vec<double>> points);

class BoxTree {
public:
    // Halves the items at the median of their centres along the longest axis, down to a few.
    explicit BoxTree(std::vector<Box> boxes);

    // Calls visit(i) for every item i whose box overlaps `query`, in no order to rely on.
    template <class Visit>
    void overlaps(const Box& query, Visit visit) const {
        if (!nodes_.empty()) descend(0, query, visit);
    }

private:
    // Items items_[first .. last - 1]. The left child follows its parent; a leaf has no right one.
    struct Node {
        Box box;
        int first, last, right;
    };
    static constexpr int leafSize = 4;

    void build(int first, int last);

    template <class Visit>
    void descend(int n, const Box& query, Visit& visit) const {
        const Node& node = nodes_[n];
        if (!node.box.overlaps(query)) return;
        if (node.right) {
            descend(n + 1, query, visit);
            descend(node.right, query, visit);
            return;
        }
        for (int i = node.first; i < node.last; ++i) {
            if (boxes_[items_[i]].overlaps(query)) visit(items_[i]);
        }
    }

    std::vector<Box> boxes_;
    std::vector<int> items_;
    std::vector<Node> nodes_;
};

}  // namespace plait
