#include "ledger.h"

#include "demos/tools/errors.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <set>
#include <utility>

namespace plait {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double freeOfCharge = 0.02;  // of the work

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
    const Trials trials("ablate", run, options, folder);
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
