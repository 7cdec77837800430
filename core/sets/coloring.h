// Colours: no two constraints of a colour share a vertex, so a colour runs wide and threaded with
// no locks [MS6, MS7].
#pragma once

#include <span>
#include <vector>

namespace plait {

// Gives each constraint, in order, the lowest colour that none of its vertices has yet. `stencils`
// holds `arity` vertices a constraint, each below `vertices`. Linear in the entries of `stencils`
// times colours / 64.
std::vector<int> greedyColors(std::span<const int> stencils, int arity, int vertices);

}  // namespace plait
