// What the inset of a view shows, from frame to frame.
#pragma once

#include "demos/runs/run_frame.h"
#include "demos/runs/settings.h"
#include "render/pictures/inset.h"

#include <mutex>
#include <optional>
#include <vector>

namespace plait {

// One thread may add while another asks.
class InsetTrail {
public:
    // `run` must live as long. Throws SceneError where the view's inset names no metric, or its
    // curve has not two points.
    explicit InsetTrail(const Run& run);

    // A frame, each after the one before it, from 0 on.
    void add(const RunFrame& frame);
    // As it is at a frame that was added: later ones leave no trail. None: the view has no inset.
    std::optional<InsetChart> at(int frame) const;

private:
    const std::optional<Inset>& inset_;
    std::size_t x_ = 0, y_ = 0;  // metrics
    InsetChart chart_;           // but for the trail
    mutable std::mutex mutex_;
    std::vector<ChartPoint> trail_;  // by frame
};

}  // namespace plait
