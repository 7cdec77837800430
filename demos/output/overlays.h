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
// in, which tears do not change), "contacts".
const std::vector<std::string>& overlayNames();

class Overlays {
public:
    // `name` is one of the above. `run` must live as long.
    Overlays(const Run& run, const std::string& name);

    bool none() const { return name_ == "none"; }
    Overlay of(const RunFrame& frame) const;
    Legend legend() const;

private:
    struct Edges {
        std::vector<std::array<int, 2>> ends;
        std::vector<double> rest;  // m
    };
    static Edges edgesOf(const World& world);
    static void showStrain(const Edges& edges, const RunFrame& frame, std::vector<float>& values);

    const World& whole_;
    std::string name_;
    Edges edges_;                // of the whole
    std::vector<float> colors_;  // by vertex
    float high_ = 1;
};

}  // namespace plait
