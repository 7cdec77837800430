// The need ledger of a scene: for each ingredient what leaving it out saves, and which metrics it
// moves by more than their tolerance.
#pragma once

#include "ingredients.h"
#include "trials.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plait {

enum class Need {
    needed,     // moves a metric beyond its tolerance
    essential,  // does not, but the scene says that it would be another without
    spare,      // does not, and costs at most 2 % of the work
    needless    // does not, and costs more
};
const std::string& wordOf(Need need);

struct LedgerRow {
    std::string part, change, ending;
    double work = 0, time = 0;  // part of that of the whole scene that is saved; below 0: lost
    std::vector<double> changes = {};  // of each metric, in tolerances
    Need need = Need::needed;

    std::string name() const { return part + ": " + change; }
    std::size_t mostMoved() const;  // place of the metric
};

struct Ledger {
    Settings settings;  // of the whole scene
    double tolerance = 0;
    long work = 0;  // constraints that the whole scene evaluates
    std::vector<Metric> metrics = {};
    std::vector<MetricTolerance> tolerances = {};
    std::vector<LedgerRow> rows = {};
    LedgerRow together = {};  // of all that can be left out at once: its change names them

    std::string scene() const { return valueOf(settings, "scene"); }
    // Metrics that no row moves: they tell nothing. Not those whose band has no width, as that of
    // crossings, [0, 0]: they are guards, there for what goes wrong, and where nothing moves them
    // nothing is near to that.
    std::vector<std::string> idleMetrics() const;
    // What a scene must not have, a line each: needless ingredients, idle metrics, figures outside
    // their bands.
    std::vector<std::string> complaints() const;
};

// Finished trials are kept in `folder`, and are not run again by the same build of the program.
// Throws Interrupted, and SceneError for a run that does not end well by itself.
Ledger ledgerOf(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder);

// By what its row says; `essentials` are those of the scene.
Need needOf(const LedgerRow& row, const std::vector<std::string>& essentials);

// Into `folder`: ledger.csv, chart.svg, chart.png and index.html. Returns what is printed.
std::string writeLedger(const Ledger& ledger, const std::filesystem::path& folder,
                        const std::string& command);

// A ledger as a file, all but `together`: "setting,value", "metric,low,high,from[s]" with what it
// comes to and may change by, and "ingredient,change,work,time" with changes, verdict and ending;
// an empty line between.
std::string csvOf(const Ledger& ledger);
// Throws FileError that begins with `name`.
Ledger ledgerFrom(const std::string& csv, const std::string& name);
// The run that stored settings are of, as its scene is now: its quality, its length. Throws as
// makeRun() does.
Run runOf(const Settings& stored);
// Where a stored ledger no longer is about that run, a line each: other settings, metrics, bands or
// ingredients; and, with what the whole scene comes to now, metrics beyond their tolerance, or work
// that differs by more than 2 %.
std::vector<std::string> differences(const Ledger& stored, const Run& run);
std::vector<std::string> differences(const Ledger& stored, const Trial& base);

}  // namespace plait
