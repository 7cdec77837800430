// What of a run is measured, frame by frame, and within which bands it must lie. Bands hold a scene
// to its promise, so that a picture never has to be trusted.
#pragma once

#include <plait/numbers/math.h>

#include <functional>
#include <limits>
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
