// What of a run is measured, frame by frame, and within which bands it must lie. Bands hold a scene
// to its promise, so that a picture never has to be trusted.
#pragma once

#include <plait/numbers/math.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace plait {

// A frame as metrics see it.
struct Snapshot {
    const std::vector<Vec<double>>& positions;   // m
    const std::vector<Vec<double>>& velocities;  // m/s
    double time;                                 // s
    int frame;                                   // 0 is the start
    long failures = 0;                           // of contacts since the frame before
    // By vertex; empty where nothing comes or goes: which birth it is of its source, -1 of what is
    // not there; its age (s), below 0 likewise.
    std::span<const std::int32_t> ids = {};
    std::span<const double> ages = {};
    // What has come apart by then, in order (State::cuts).
    std::span<const std::int32_t> cuts = {};

    bool isHere(int v) const { return ids.empty() || ids[static_cast<std::size_t>(v)] >= 0; }
};

struct Metric {
    std::string name;  // column of metrics.csv
    std::string unit;
    std::function<double(const Snapshot&)> measure;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    double from = 0;       // s, before which the band does not hold
    bool caption = false;  // shown in the caption strip
};

}  // namespace plait
