// A run that is tried, and what its metrics come to.
#pragma once

#include "demos/output/metric_table.h"
#include "demos/runs/settings.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace plait {

struct Trial {
    std::string ending = "complete";  // or what diverged, or why there was nothing to run
    double seconds = 0;               // of the one thread that solved
    std::vector<MetricRow> rows;

    bool whole() const { return ending == "complete"; }
    long evaluations() const { return rows.empty() ? 0 : rows.back().evaluations; }
};

// What a trial may take before it is given up, looked at after each frame.
struct TrialLimit {
    double evaluations, seconds;
};

// Throws Interrupted.
Trial tryOut(const Run& run, const TrialLimit& limit);

// The same, but for its start: everything that moves has up to 0.1 mm/s of its own. What a metric
// differs by is chance.
Run nudged(Run run, unsigned seed);

// What is left of a trial in a file, and of which run it is (`key`).
std::string textOf(const Trial& trial, const std::string& key, const std::vector<Metric>& metrics);
// False: there is none, or it is of another run.
bool readTrial(const std::filesystem::path& file, const std::string& key,
               const std::vector<Metric>& metrics, Trial& trial);

// What a metric came to, over the frames for which its band holds.
struct Figures {
    double mean, least, most;
};
inline constexpr std::array<double Figures::*, 3> allFigures{&Figures::mean, &Figures::least,
                                                             &Figures::most};
Figures figuresOf(const Metric& metric, std::size_t column, const std::vector<MetricRow>& rows);

}  // namespace plait
