// What overlays show: a number a vertex of a frame.
#pragma once

#include "demos/runs/run_frame.h"
#include "demos/runs/settings.h"
#include "render/overlay.h"
#include "render/pictures/legend.h"

#include <array>
#include <string>
#include <vector>

namespace plait {

// "none", "strain", "velocity", "colours" (of the batches that its first edge's constraint would be
// in), "contacts".
const std::vector<std::string>& overlayNames();

class Overlays {
public:
    // `name` is one of the above.
    Overlays(const Run& run, const std::string& name);

    bool none() const { return name_ == "none"; }
    Overlay of(const RunFrame& frame) const;
    Legend legend() const;

private:
    std::string name_;
    std::vector<std::array<int, 2>> edges_;
    std::vector<double> rest_;   // m, by edge
    std::vector<float> colors_;  // by vertex
    float high_ = 1;
    int vertices_;
};

}  // namespace plait
