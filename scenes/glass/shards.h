// What of a pane hangs together, by where its pieces are alone: independent of the solver.
#pragma once

#include "../metric.h"
#include "../parts/measures.h"

#include <plait/fracture/welds.h>
#include <plait/world.h>

#include <vector>

namespace plait {

class Shards {
public:
    // Of these pieces; what is welded to a pinned one hangs.
    Shards(const World& world, std::vector<Weld> welds, std::vector<int> cells);

    // By piece, with which it hangs together: those whose pieces are to each other as at the start,
    // to 0.1 mm.
    std::vector<int> groups(const std::vector<Vec<double>>& positions) const;

    Metric count(Band band) const;    // of what is apart, with what hangs as one
    Metric hanging(Band band) const;  // in % of the pane's mass

private:
    bool together(const Weld& weld, const std::vector<Vec<double>>& positions) const;

    std::vector<Weld> welds_;
    std::vector<int> cells_;
    std::vector<Range> pieces_;
    std::vector<Vec<double>> start_;
    std::vector<double> mass_;           // kg, by piece
    std::vector<unsigned char> pinned_;  // by piece
};

}  // namespace plait
