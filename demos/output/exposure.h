// Frames of a run as what pictures are of.
#pragma once

#include "demos/runs/run_frame.h"
#include "render/matter/moment.h"

#include <plait/world.h>

#include <vector>

namespace plait {

// Of a frame that lives as long.
Moment momentOf(const RunFrame& frame);

// Moments of half a frame's time, as a film camera has it, up to `frame`, and what keeps them: on
// straight ways from the frame before. What has come since has flown here as it flies; what has
// come apart since is apart in all of them, its copies on ways from where their vertices were.
struct Exposure {
    // Both frames must live as long.
    Exposure(const World& world, const RunFrame& before, const RunFrame& frame, int moments);

    std::vector<std::vector<Vec<double>>> positions;
    std::vector<Moment> all;
};

}  // namespace plait
