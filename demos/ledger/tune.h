// The cheapest settings of a scene that keep its metrics where they would be, did the solver cost
// nothing.
#pragma once

#include "trials.h"

#include <filesystem>
#include <string>
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
    std::string scene;
    double tolerance;
    // Of the run that counts as converged: substeps in those of the scene, the least multiple that
    // is no more than the tolerance from half of it.
    int refined = 0;
    Trial converged = {}, own = {}, chosen = {};
    double ownWorst = 0;               // the scene's own settings, in tolerances
    std::vector<TuneStep> steps = {};  // in the order in which they were tried
    std::string settings = {};         // what is chosen, as options of the command line; "" as is
};

// From the scene's own settings, or, where these are not within tolerance of what is converged,
// from the least multiple of their substeps that is: of the changes of cheaperSettings() the one
// that saves most is taken, again and again. Throws Interrupted, and SceneError for a scene that
// converges within no 32 times its substeps, or does not end well by itself.
Tuning tune(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder);

// Into `folder`: tune.csv, chart.svg, chart.png and index.html. Returns what is printed.
std::string writeTuning(const Tuning& tuning, const std::filesystem::path& folder,
                        const std::string& command);

}  // namespace plait
