// What was measured, frame by frame: metrics.csv, and whether it lies within the bands.
//
// metrics.csv: a header, then a row a frame from the start on: frame, time[s], evaluations (of
// constraints since the start), then the scene's metrics as name[unit]; numbers are the shortest
// that read back as the same.
#pragma once

#include "demos/runs/run_frame.h"
#include "scenes/metric.h"

#include <string>
#include <vector>

namespace plait {

struct MetricRow {
    int frame;
    double time;  // s
    long evaluations;
    std::vector<double> values;
};
MetricRow rowOf(const RunFrame& frame);

std::string csvOf(const std::vector<Metric>& metrics, const std::vector<MetricRow>& rows);
// Throws FileError that begins with `name`, for another header as well.
std::vector<MetricRow> rowsFrom(const std::string& csv, const std::vector<Metric>& metrics,
                                const std::string& name);

struct Verdict {
    double least, most;  // over the frames for which the band holds
    int frames;          // how many these are
    int firstOutside;    // the first frame outside the band, -1 for none
};
Verdict verdictOn(const Metric& metric, std::size_t column, const std::vector<MetricRow>& rows);

// A line a metric: name, unit, least and greatest value, band, ok.
std::string verdictTable(const std::vector<Metric>& metrics, const std::vector<MetricRow>& rows);
bool allWithinBands(const std::vector<Metric>& metrics, const std::vector<MetricRow>& rows);

// "[low, high]", "" for none.
std::string bandOf(const Metric& metric);

}  // namespace plait
