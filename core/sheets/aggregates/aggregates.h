// Aggregates: the vertices of a sheet merged into ever fewer, and what bounds their distances.
//
// An aggregate stands at the mean, by mass, of what it is made of. In an inextensible sheet the
// distance of two such means is bounded: |X_a - X_b| <= sum p_ij d_ij for any coupling p of the two
// sets of shares and d_ij the way along the links (the triangle inequality, averaged). The bound
// holds however the sheet folds, so a coarse link adds no stiffness that the sheet has not; it only
// says at once what the fine links would say after many sweeps.
#pragma once

#include "../../constraints/kinds.h"
#include "../../constraints/rows.h"
#include "aggregate_graph.h"

#include <array>
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
// than `fewest` that move are left.
class AggregatePlan {
public:
    // `mass` by vertex (infinite: pinned, kg), `rest` by vertex (m): it decides only what merges.
    // Vertices without a link are in no aggregate, and what stands in one with a pinned vertex
    // takes no coarse correction.
    AggregatePlan(std::vector<double> mass, std::vector<Vec<double>> rest,
                  std::span<const Link> links, int fewest);

    // These links, by their vertices, hold no more. An aggregate that comes apart becomes one for
    // each of its parts, were it a single vertex without a link. Bounds are made anew where one of
    // the two is no longer what it was, or where a way along a link that has changed may have
    // counted. All else stays as it is, to the bit.
    void cut(std::span<const std::array<int, 2>> links);

    std::vector<AggregateLevel> levels() const;
    // Nodes on ways looked at, and pairs bounded, by the constructor or the last cut.
    long visited() const { return visited_; }

private:
    // What a level has to follow: nodes that are new or not what they were, and links of another
    // length, infinite where there is none any more.
    struct Change {
        std::vector<int> nodes;
        std::vector<Link> links;
    };
    struct Near;

    Change follow(std::size_t level, const Change& change);
    Near nearTo(std::size_t level, const Change& change);
    std::vector<int> regroup(std::size_t level, const Change& change);
    int addGroup(std::size_t level, int twin);

    std::vector<AggregateGraph> graphs_;   // one more than there are levels
    std::vector<AggregateGroups> groups_;  // by level, of the nodes of its finer graph
    long visited_ = 0;
};

// Rigid ones, whatever the compliance.
std::vector<Link> linksOf(const Rows<Stretch>& set);

// Those of links that nothing cuts.
std::vector<AggregateLevel> aggregate(std::vector<double> mass, std::vector<Vec<double>> rest,
                                      std::span<const Link> links, int fewest);

}  // namespace plait
