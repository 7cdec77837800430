#include "ledger.h"

#include "demos/tools/errors.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace plait {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double freeOfCharge = 0.02;  // of the work

LedgerRow rowOf(const Ledger& ledger, const Trial& base, const std::string& part,
                const std::string& change, const Trial& trial) {
    LedgerRow row{.part = part, .change = change, .ending = trial.ending};
    if (ledger.work > 0)
        row.work = 1 - static_cast<double>(trial.evaluations()) / static_cast<double>(ledger.work);
    row.time = 1 - trial.seconds / base.seconds;
    for (std::size_t m = 0; m < ledger.metrics.size(); ++m)
        row.changes.push_back(trial.whole() ? ledger.tolerances[m].changeOf(
                                                  figuresOf(ledger.metrics[m], m, trial.rows))
                                            : infinite);
    return row;
}

bool canGo(const LedgerRow& row) { return row.need == Need::needless || row.need == Need::spare; }

// Left out one after the other, what saves most first, as long as all metrics stay; of what changes
// the same part, one.
LedgerRow leaveOutTogether(const Ledger& ledger, const Trial& base, const Run& run,
                           const std::vector<Ingredient>& all, const Trials& trials) {
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
            trials.of({words}, [&](int) { return without(run, leave); }, limitOf(base))[0];
        const LedgerRow row = rowOf(ledger, base, "together", words, trial);
        if (needOf(row, {}) == Need::needed || row.work < best.work) continue;
        best = row, taken = more;
        parts.insert(all[i].part);
    }
    return best;
}

}  // namespace

Need needOf(const LedgerRow& row, const std::vector<std::string>& essentials) {
    if (std::ranges::any_of(row.changes, [](double change) { return change > 1; }))
        return Need::needed;
    if (isEssential({row.part, row.change, {}}, essentials)) return Need::essential;
    return row.work > freeOfCharge ? Need::needless : Need::spare;
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
        if (metrics[m].low != metrics[m].high &&
            std::ranges::none_of(rows, [&](const LedgerRow& row) { return row.changes[m] > 1; }))
            idle.push_back(metrics[m].name);
    return idle;
}

std::vector<std::string> Ledger::complaints() const {
    std::vector<std::string> lines;
    for (const LedgerRow& row : rows)
        if (row.need == Need::needless)
            lines.push_back(scene() + ": " + row.part + ", " + row.change + ": saves " +
                            rounded("%.1f", 100 * row.work) + " % of the work, and nothing moves");
    for (const std::string& metric : idleMetrics())
        lines.push_back(scene() + ": " + metric + ": moved by nothing that was left out");
    for (std::size_t m = 0; m < metrics.size(); ++m)
        if (const Figures& base = tolerances[m].base;
            !(base.least >= metrics[m].low && base.most <= metrics[m].high))
            lines.push_back(scene() + ": " + metrics[m].name + ": outside its band");
    return lines;
}

Ledger ledgerOf(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder) {
    const std::vector<Ingredient> all = ingredientsOf(run);
    const Trials trials("ablate", run, options, folder);
    Ledger ledger{
        .settings = settingsOf(run), .tolerance = options.tolerance, .metrics = run.scene.metrics};
    const std::vector<Trial> twins =
        trials.of({"base", "nudged 1", "nudged 2"},
                  [&](int i) { return i == 0 ? run : nudged(run, static_cast<unsigned>(i)); },
                  {infinite, infinite});
    const Trial& base = twins[0];
    if (!base.whole()) throw SceneError(ledger.scene() + ": " + base.ending);
    ledger.work = base.evaluations();
    for (std::size_t m = 0; m < ledger.metrics.size(); ++m)
        ledger.tolerances.push_back(
            toleranceOf(ledger.metrics[m], m, base, twins, options.tolerance));
    std::vector<std::string> words;
    for (const Ingredient& ingredient : all) words.push_back(ingredient.name());
    const std::vector<Trial> tried = trials.of(
        words, [&](int i) { return without(run, {&all[static_cast<std::size_t>(i)], 1}); },
        limitOf(base));
    for (std::size_t i = 0; i < all.size(); ++i) {
        ledger.rows.push_back(rowOf(ledger, base, all[i].part, all[i].change, tried[i]));
        ledger.rows.back().need = needOf(ledger.rows.back(), run.entry->essentials);
    }
    ledger.together = leaveOutTogether(ledger, base, run, all, trials);
    return ledger;
}

}  // namespace plait
