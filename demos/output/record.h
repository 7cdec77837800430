// run.json: what a run was, on what it ran and what it cost.
#pragma once

#include "demos/runs/settings.h"
#include "metric_table.h"
#include "pictures.h"

#include <cstdint>
#include <optional>
#include <string>

namespace plait {

struct Record {
    const Run& run;
    std::string ending;  // "complete", "interrupted", or what diverged
    int threads = 1;
    int resumedAt = 0;  // the frame from which this call went on, 0 for the start
    std::vector<MetricRow> rows;
    std::uint64_t hash = 0;      // of the last state
    std::size_t stateBytes = 0;  // of all states that the solver holds
    Stages stages;               // seconds of this call
    double seconds = 0;          // of this call, all in all
    std::optional<PictureOptions> pictures;
    std::string glLibrary, glRenderer;
};

std::string jsonOf(const Record& record);

}  // namespace plait
