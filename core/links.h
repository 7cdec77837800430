// Links between components, which are lists of vertices: two vertices a link, for Stretch, whether
// of the length they have (restRows) or of none, so that they draw their ends together.
#pragma once

#include "numbers/math.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace plait {

// Which components are joined (M 3.1.3); `within`: each with itself alone.
enum class Relation { allToAll, allToFirst, chain, within };

struct LinkOptions {
    Relation relation = Relation::allToAll;
    // m, between its ends in `rest`, at most; 0: only what lies in one place.
    double maxDistance = std::numeric_limits<double>::infinity();
    double density = 1;      // the part of these links that is made, 0 to 1: each by itself
    std::uint64_t seed = 1;  // of which these are
};

// By component, then by vertex, in the order in which they are listed; no link twice, and none of a
// vertex with itself. Costs one component's size times the other's. Throws std::invalid_argument,
// naming the value, for a vertex that `rest` has not, or an option out of range.
std::vector<int> linkStencils(std::span<const std::vector<int>> components,
                              std::span<const Vec<double>> rest, const LinkOptions& options = {});

}  // namespace plait
