// Aggregates: the vertices of a sheet merged into ever fewer, and what bounds their distances.
//
// An aggregate stands at the mean, by mass, of what it is made of. In an inextensible sheet the
// distance of two such means is bounded: |X_a - X_b| <= sum p_ij d_ij for any coupling p of the two
// sets of shares and d_ij the way along the links (the triangle inequality, averaged). The bound
// holds however the sheet folds, so a coarse link adds no stiffness that the sheet has not; it only
// says at once what the fine links would say after many sweeps.
#pragma once

#include "constraints/kinds.h"
#include "rows.h"
#include "ways.h"

#include <span>
#include <vector>

namespace plait {

struct AggregateLevel {
    std::vector<int> parent;    // by node of the finer level: its aggregate, -1 for none
    std::vector<double> share;  // by node of the finer level: its part of the aggregate's mass; of
                                // an aggregate with pinned members they alone have one
    std::vector<double> mass;   // kg, by aggregate; infinite for one with a pinned member
    std::vector<Link> links;    // upper bounds
};

// Levels from fine to coarse, each of about a quarter of the nodes of the one before, until fewer
// than `fewest` that move are left. `mass` by vertex (infinite: pinned, kg), `rest` by vertex (m):
// it decides only what merges. Vertices without a link are in no aggregate, and what stands in one
// with a pinned vertex takes no coarse correction.
std::vector<AggregateLevel> aggregate(std::vector<double> mass, std::vector<Vec<double>> rest,
                                      std::vector<Link> links, int fewest);

}  // namespace plait
