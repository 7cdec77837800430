// Edges that pierce triangles, where a substep begins: contacts part what is on the side on which
// it began, so they only hold such a tangle together.
#pragma once

#include "../../collision/candidates.h"
#include "../../collision/kdop_tree.h"
#include "../../complex/complex.h"
#include "../surface.h"

#include <memory>
#include <span>
#include <vector>

namespace plait {

class Tangles {
public:
    Tangles(const SimplicialComplex& complex, const std::vector<Surface>& surfaces,
            std::span<const unsigned char> pinned);

    // By vertex that moves and is a corner of two that pierce each other at x (m, by vertex):
    // `own` of one surface, `other` of two. What none of these tell apart is left as it is.
    struct Marks {
        std::vector<unsigned char> own, other;
    };
    void find(std::span<const Vec<double>> x, Marks& marks, Workers& workers);

private:
    static constexpr int slabs = 6;

    bool accepts(std::span<const int> edge, std::span<const int> triangle) const;

    std::vector<Surface> surfaces_;
    std::vector<int> surface_;  // by vertex, -1 of none
    std::vector<unsigned char> pinned_;
    std::vector<int> edges_, triangles_;  // two and three vertices each
    std::unique_ptr<KDopTree<slabs>> edgeTree_, triangleTree_;
    Candidates found_;
};

}  // namespace plait
