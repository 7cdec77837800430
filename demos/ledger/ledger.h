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
    std::string scene;
    double tolerance;
    Trial base = {};
    std::vector<std::string> metrics = {};
    std::vector<MetricTolerance> tolerances = {};
    std::vector<LedgerRow> rows = {};
    LedgerRow together = {};  // of all that can be left out at once: its change names them

    // Metrics that no row moves: they tell nothing.
    std::vector<std::string> idleMetrics() const;
    // What a scene must not have, a line each: needless ingredients, idle metrics.
    std::vector<std::string> complaints() const;
};

// Finished trials are kept in `folder`, and are not run again, even by another build of
// the program. Throws Interrupted, and SceneError for a run that does not end well by itself.
Ledger ledgerOf(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder);

// Into `folder`: ledger.csv, chart.svg, chart.png and index.html. Returns what is printed.
std::string writeLedger(const Ledger& ledger, const std::filesystem::path& folder,
                        const std::string& command);
std::string csvOf(const Ledger& ledger);

}  // namespace plait
