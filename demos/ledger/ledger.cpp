#include "ledger.h"

#include "demos/runs/run_all.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/progress.h"

#include <plait/measure/hash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <utility>

namespace plait {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double freeOfCharge = 0.02;  // of the work
constexpr double patience = 8;         // work and time of a trial, in that of the whole scene

constexpr std::array<double Figures::*, 3> allFigures{&Figures::mean, &Figures::least,
                                                      &Figures::most};

// The trials of a ledger, each run once.
class Trials {
public:
    Trials(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder)
        : run_(run), options_(options), folder_(folder / "trials") {
        makeFolder(folder_);
    }

    // As many as there are words; `make` gives the run of each.
    std::vector<Trial> of(const std::vector<std::string>& words,
                          const std::function<Run(int)>& make, const TrialLimit& limit) const {
        std::vector<Trial> trials(words.size());
        std::vector<int> left;
        for (int i = 0; i < static_cast<int>(words.size()); ++i)
            if (!readTrial(fileOf(words[i]), keyOf(words[i]), run_.scene.metrics, trials[i]))
                left.push_back(i);
        const int total = static_cast<int>(words.size()), count = static_cast<int>(left.size());
        Progress progress("ablate " + run_.entry->name, total - count, total, options_.quiet,
                          "runs");
        runAll(count, options_.jobs, total - count, progress, [&](int k, int) {
            const int i = left[k];
            trials[i] = tryOut(make(i), limit);
            writeWhole(fileOf(words[i]), textOf(trials[i], keyOf(words[i]), run_.scene.metrics));
        });
        return trials;
    }

private:
    std::string keyOf(const std::string& word) const {
        std::string key = textOf(settingsOf(run_)) + word;
        std::replace(key.begin(), key.end(), '\n', ' ');
        return key;
    }
    std::filesystem::path fileOf(const std::string& word) const {
        const std::string key = keyOf(word);
        char name[32];
        std::snprintf(name, sizeof name, "%016llx.csv",
                      static_cast<unsigned long long>(
                          hashOf(std::span<const char>(key.data(), key.size()), hashSeed)));
        return folder_ / name;
    }

    const Run& run_;
    const LedgerOptions& options_;
    std::filesystem::path folder_;
};

TrialLimit limitOf(const Trial& base) {
    return {patience * static_cast<double>(base.evaluations()),
            std::max(1.0, patience * base.seconds)};
}

MetricTolerance toleranceOf(const Metric& metric, std::size_t column, const Trial& base,
                            const std::vector<Trial>& twins, double tolerance) {
    MetricTolerance result{};
    result.base = figuresOf(metric, column, base.rows);
    const double width = metric.high - metric.low;
    const double scale = std::isfinite(width) ? width
                                              : std::max(result.base.most - result.base.least,
                                                         std::fabs(result.base.mean));
    for (const auto figure : allFigures) {
        double low = result.base.*figure, high = low;
        for (const Trial& twin : twins) {
            const double value = figuresOf(metric, column, twin.rows).*figure;
            low = std::min(low, value), high = std::max(high, value);
        }
        result.allowed.*figure = std::max(tolerance * scale, 2 * (high - low));
    }
    return result;
}

LedgerRow rowOf(const Ledger& ledger, const std::vector<Metric>& metrics, const std::string& part,
                const std::string& change, const Trial& trial) {
    LedgerRow row{.part = part, .change = change, .ending = trial.ending};
    const double work = static_cast<double>(ledger.base.evaluations());
    row.work = work > 0 ? 1 - static_cast<double>(trial.evaluations()) / work : 0;
    row.time = 1 - trial.seconds / ledger.base.seconds;
    for (std::size_t m = 0; m < metrics.size(); ++m)
        row.changes.push_back(
            trial.whole() ? ledger.tolerances[m].changeOf(figuresOf(metrics[m], m, trial.rows))
                          : infinite);
    return row;
}

Need needOf(const LedgerRow& row, const std::vector<std::string>& essentials) {
    if (std::ranges::any_of(row.changes, [](double change) { return change > 1; }))
        return Need::needed;
    if (std::ranges::count(essentials, row.part) + std::ranges::count(essentials, row.name()) > 0)
        return Need::essential;
    return row.work > freeOfCharge ? Need::needless : Need::spare;
}

bool canGo(const LedgerRow& row) { return row.need == Need::needless || row.need == Need::spare; }

// Left out one after the other, what saves most first, as long as all metrics stay; of what changes
// the same part, one.
LedgerRow leaveOutTogether(const Ledger& ledger, const Run& run, const std::vector<Ingredient>& all,
                           const Trials& trials) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (canGo(ledger.rows[i]) && ledger.rows[i].work >= 0) order.push_back(i);
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::pair(-ledger.rows[a].work, a) < std::pair(-ledger.rows[b].work, b);
    });
    LedgerRow best{.part = "together", .change = "nothing", .ending = "complete"};
    best.changes.assign(ledger.metrics.size(), 0);
    std::set<std::size_t> taken;
    std::set<std::string> parts;
    for (const std::size_t i : order) {
        if (parts.contains(all[i].part)) continue;
        std::set<std::size_t> more = taken;
        more.insert(i);
        std::vector<Ingredient> leave;
        std::string words;
        for (const std::size_t k : more) {
            leave.push_back(all[k]);
            words += (words.empty() ? "" : "; ") + all[k].name();
        }
        const Trial trial =
            trials.of({words}, [&](int) { return without(run, leave); }, limitOf(ledger.base))[0];
        const LedgerRow row = rowOf(ledger, run.scene.metrics, "together", words, trial);
        if (needOf(row, {}) == Need::needed || row.work < best.work) continue;
        best = row, taken = more;
        parts.insert(all[i].part);
    }
    return best;
}

}  // namespace

double MetricTolerance::changeOf(const Figures& figures) const {
    double change = 0;
    for (const auto figure : allFigures) {
        const double by = std::fabs(figures.*figure - base.*figure), most = allowed.*figure;
        if (by == 0) continue;
        change = std::max(change, std::isfinite(by) && most > 0 ? by / most : infinite);
    }
    return change;
}

const std::string& wordOf(Need need) {
    static const std::array<std::string, 4> words{"needed", "essential", "spare", "needless"};
    return words[static_cast<std::size_t>(need)];
}

std::size_t LedgerRow::mostMoved() const {
    return static_cast<std::size_t>(std::max_element(changes.begin(), changes.end()) -
                                    changes.begin());
}

std::vector<std::string> Ledger::idleMetrics() const {
    std::vector<std::string> idle;
    for (std::size_t m = 0; m < metrics.size(); ++m)
        if (std::ranges::none_of(rows, [&](const LedgerRow& row) { return row.changes[m] > 1; }))
            idle.push_back(metrics[m]);
    return idle;
}

std::vector<std::string> Ledger::complaints() const {
    std::vector<std::string> lines;
    char line[256];
    for (const LedgerRow& row : rows) {
        if (row.need != Need::needless) continue;
        std::snprintf(line, sizeof line, "%s: %s, %s: saves %.1f %% of the work, and nothing moves",
                      scene.c_str(), row.part.c_str(), row.change.c_str(), 100 * row.work);
        lines.emplace_back(line);
    }
    for (const std::string& metric : idleMetrics())
        lines.push_back(scene + ": " + metric + ": moved by nothing that was left out");
    return lines;
}

Ledger ledgerOf(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder) {
    const std::vector<Ingredient> all = ingredientsOf(run);
    const Trials trials(run, options, folder);
    const std::vector<Metric>& metrics = run.scene.metrics;
    Ledger ledger{.scene = run.entry->name, .tolerance = options.tolerance};
    for (const Metric& metric : metrics) ledger.metrics.push_back(metric.name);
    const std::vector<Trial> twins =
        trials.of({"base", "nudged 1", "nudged 2"},
                  [&](int i) { return i == 0 ? run : nudged(run, static_cast<unsigned>(i)); },
                  {infinite, infinite});
    ledger.base = twins[0];
    if (!ledger.base.whole()) throw SceneError(ledger.scene + ": " + ledger.base.ending);
    for (std::size_t m = 0; m < metrics.size(); ++m)
        ledger.tolerances.push_back(
            toleranceOf(metrics[m], m, ledger.base, twins, options.tolerance));
    std::vector<std::string> words;
    for (const Ingredient& ingredient : all) words.push_back(ingredient.name());
    const std::vector<Trial> tried = trials.of(
        words, [&](int i) { return without(run, {&all[static_cast<std::size_t>(i)], 1}); },
        limitOf(ledger.base));
    for (std::size_t i = 0; i < all.size(); ++i) {
        ledger.rows.push_back(rowOf(ledger, metrics, all[i].part, all[i].change, tried[i]));
        ledger.rows.back().need = needOf(ledger.rows.back(), run.entry->essentials);
    }
    ledger.together = leaveOutTogether(ledger, run, all, trials);
    return ledger;
}

}  // namespace plait
