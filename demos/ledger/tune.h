// The cheapest settings of a scene that keep its metrics where they would be, did the solver cost
// nothing.
#pragma once

#include "trials.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace plait {

// A change of settings that was tried, beside the run that it changes.
struct TuneStep {
    std::string change;  // "substeps: 30 for 60"
    std::string ending;
    double work = 0;   // counted, of that of the scene's own settings
    double worst = 0;  // change of the metric that moves most from the converged run, in tolerances
    std::string metric = {};  // that one
    bool taken = false;
};

struct Tuning {
    Settings settings;  // of the scene as it is
    double tolerance = 0;
    // Of the run that counts as converged: substeps in those of the scene, the least multiple that
    // is no more than the tolerance from half of it.
    int refined = 0;
    std::vector<Metric> metrics = {};
    std::vector<MetricTolerance> tolerances = {};  // about what is converged (tuneToleranceOf())
    // Metrics that 32 times the substeps do not settle, or that two doublings do not bring to half,
    // as how many shards there are: they are held to their bands alone.
    std::vector<std::string> unsettled = {};
    Trial converged = {}, own = {}, chosen = {};
    double ownWorst = 0;               // the scene's own settings, in tolerances
    std::vector<TuneStep> steps = {};  // in the order in which they were tried
    std::string options = {};          // what is chosen, as of the command line; "" as is
};

// From the scene's own settings, or, where these are not within tolerance of what is converged,
// from the least multiple of their substeps that is: of the changes of cheaperSettings() the one
// that saves most is taken, again and again. Throws Interrupted, and SceneError for a scene of
// which a metric without a band does not settle, or that does not end well by itself.
Tuning tune(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder);

// The part `tolerance` of what a metric goes through or comes to, and never less than twice what
// chance changes. But where a band goes from 0 to a bound, the metric is of an error, of which all
// in the band is as good as none; and where it has no width, nothing may change.
MetricTolerance tuneToleranceOf(const Metric& metric, std::size_t column, const Trial& converged,
                                const std::vector<Trial>& twins, double tolerance);

// The metric that is furthest from what is converged: its place, and how far, in tolerances;
// infinite where the trial did not end well.
std::pair<double, std::size_t> furthest(const Trial& trial, const std::vector<Metric>& metrics,
                                        const std::vector<MetricTolerance>& tolerances);

// Into `folder`: tune.csv, chart.svg, chart.png and index.html. Returns what is printed.
std::string writeTuning(const Tuning& tuning, const std::filesystem::path& folder,
                        const std::string& command);

// A tuning as a file, all but the trials: settings, metrics, and "change,work,moves
// most,tolerances,taken".
std::string csvOf(const Tuning& tuning);
// Throws FileError that begins with `name`.
Tuning tuningFrom(const std::string& csv, const std::string& name);
// Where a stored tuning no longer says that these are the cheapest settings of its scene, a line
// each: it is about other settings or metrics; they are not within tolerance; others that cost less
// are.
std::vector<std::string> differences(const Tuning& stored, const Run& run);

}  // namespace plait
