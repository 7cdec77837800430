// The cost of the broad phase: trees of k-DOPs and the hash grid. Prints and charts, never judges.
#pragma once

namespace plait {

// A table, and out/bench/broadphase/chart.svg, .png and table.csv. Returns an exit status.
int benchBroadPhase();

}  // namespace plait
