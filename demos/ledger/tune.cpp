#include "tune.h"

#include "demos/tools/errors.h"
#include "ingredients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace plait {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int mostRefined = 32, nudges = 6, mostImportant = 1'000'000;

// Each set as often in every substep as before.
Run refined(Run run, int times) {
    run.scene.options.schedule.substeps *= times;
    for (World::Set& set : run.scene.world.sets)
        set.options.importance = std::min(mostImportant, times * set.options.importance);
    return run;
}

// Settings that the first has and the second has not.
std::string optionsOf(const Run& chosen, const Run& own) {
    const Settings before = settingsOf(own);
    std::string words;
    for (const auto& [name, value] : settingsOf(chosen))
        if (value != valueOf(before, name))
            words += (words.empty() ? "--" : " --") + name + " " + value;
    return words;
}

bool isChanged(const Run& run, const Run& before) { return !optionsOf(run, before).empty(); }

// What is tried, and how far it is from what is converged.
class Tuner {
public:
    Tuner(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder)
        : run_(run), trials_("tune", run_, options, folder) {
        tuning_.settings = settingsOf(run);
        tuning_.tolerance = options.tolerance;
        tuning_.metrics = run.scene.metrics;
    }

    Tuning tuning() {
        converge();
        Run run = lower(start(), "");
        if (isChanged(bySet(run), run))
            if (const Run own = lower(bySet(run), "by set; "); isChanged(own, bySet(run)))
                run = own;
        tuning_.options = optionsOf(run, run_);
        return std::move(tuning_);
    }

private:
    Trial trialOf(const std::string& words, const Run& run) const {
        return trials_.of({words}, [&](int) { return run; }, {unlimited, unlimited})[0];
    }

    std::pair<double, std::size_t> worstOf(const Trial& trial) const {
        return furthest(trial, tuning_.metrics, tuning_.tolerances);
    }

    void holdTo(const Trial& converged) {
        tuning_.tolerances.clear();
        for (std::size_t m = 0; m < tuning_.metrics.size(); ++m)
            tuning_.tolerances.push_back(
                tuneToleranceOf(tuning_.metrics[m], m, converged, twins_, tuning_.tolerance));
    }

    void converge() {
        std::vector<std::string> words{"base"};
        for (int i = 1; i <= nudges; ++i) words.push_back("nudged " + std::to_string(i));
        twins_ = trials_.of(
            words, [&](int i) { return i == 0 ? run_ : nudged(run_, static_cast<unsigned>(i)); },
            {unlimited, unlimited});
        tuning_.own = twins_[0];
        if (!tuning_.own.whole()) throw SceneError(run_.entry->name + ": " + tuning_.own.ending);
        Trial coarse = tuning_.own;
        std::vector<double> changes;  // by each doubling, in tolerances
        for (int times = 2; times <= mostRefined; times *= 2) {
            Trial fine = trialOf("substeps times " + std::to_string(times), refined(run_, times));
            if (!fine.whole()) throw SceneError(run_.entry->name + ": " + fine.ending);
            holdTo(fine);
            ladder_.push_back(std::exchange(coarse, fine));
            tuning_.refined = times;
            changes.push_back(worstOf(ladder_.back()).first);
            if (changes.back() <= 1 || isStuck(changes)) break;
        }
        tuning_.converged = std::move(coarse);
        holdToBands(ladder_.back());
        tuning_.ownWorst = worstOf(tuning_.own).first;
    }

    // First order would have brought it to a quarter.
    static bool isStuck(const std::vector<double>& changes) {
        const std::size_t n = changes.size();
        return n > 2 && std::isfinite(changes[n - 1]) && changes[n - 1] > changes[n - 3] / 2;
    }

    // What half the substeps of the finest run still move too far.
    void holdToBands(const Trial& half) {
        for (std::size_t m = 0; m < tuning_.metrics.size(); ++m) {
            const Metric& metric = tuning_.metrics[m];
            MetricTolerance& tolerance = tuning_.tolerances[m];
            if (tolerance.changeOf(figuresOf(metric, m, half.rows)) <= 1) continue;
            const double middle = (metric.low + metric.high) / 2, part = metric.high - middle;
            if (!std::isfinite(part))
                throw SceneError(run_.entry->name + ": " + metric.name +
                                 " has not converged with " + std::to_string(tuning_.refined) +
                                 " times its substeps");
            tolerance = {{middle, middle, middle}, {part, part, part}};
            tuning_.unsettled.push_back(metric.name);
        }
    }

    // The cheapest of the ladder of substeps that is within tolerance.
    Run start() {
        int times = 1;
        for (const Trial& trial : ladder_) {
            tuning_.chosen = trial;
            if (worstOf(trial).first <= 1) break;
            times *= 2;
        }
        return refined(run_, times);
    }

    // What saves most is taken, until nothing is left that may be. `how` it stands in trials.
    Run lower(Run run, const std::string& how) {
        std::set<std::string> refused;
        std::string before = how + optionsOf(run, run_);
        for (bool better = true; std::exchange(better, false);) {
            std::vector<Ingredient> all = cheaperSettings(run);
            std::erase_if(all, [&](const Ingredient& i) { return refused.contains(i.name()); });
            std::vector<std::string> words;
            for (const Ingredient& each : all) words.push_back(before + "; " + each.name());
            const std::vector<Trial> tried = trials_.of(
                words, [&](int i) { return without(run, {&all[static_cast<std::size_t>(i)], 1}); },
                limitOf(tuning_.chosen));
            std::size_t best = all.size();
            for (std::size_t i = 0; i < all.size(); ++i) {
                const auto [worst, metric] = worstOf(tried[i]);
                tuning_.steps.push_back(
                    {how + all[i].name(), tried[i].ending, workOf(tried[i]), worst,
                     tuning_.metrics.empty() ? "" : tuning_.metrics[metric].name});
                if (worst > 1)
                    refused.insert(all[i].name());
                else if (isLess(tried[i], best < all.size() ? tried[best] : tuning_.chosen))
                    best = i;
            }
            if (best == all.size()) break;
            better = true;
            tuning_.steps[tuning_.steps.size() - all.size() + best].taken = true;
            tuning_.chosen = tried[best];
            before = words[best];
            run = without(run, {&all[best], 1});
        }
        return run;
    }

    // By counted work; where that is the same, as of a lower precision, by time.
    static bool isLess(const Trial& a, const Trial& b) {
        constexpr double noise = 0.9;
        if (a.evaluations() != b.evaluations()) return a.evaluations() < b.evaluations();
        return a.seconds < noise * b.seconds;
    }

    double workOf(const Trial& trial) const {
        return static_cast<double>(trial.evaluations()) /
               static_cast<double>(std::max(1L, tuning_.own.evaluations()));
    }

    const Run run_;
    Trials trials_;
    std::vector<Trial> twins_, ladder_;
    Tuning tuning_{};
};

}  // namespace

MetricTolerance tuneToleranceOf(const Metric& metric, std::size_t column, const Trial& converged,
                                const std::vector<Trial>& twins, double tolerance) {
    if (metric.low == 0 && metric.high > 0 && std::isfinite(metric.high))
        return {{0, 0, 0}, {metric.high, metric.high, metric.high}};
    Metric any = metric;
    if (metric.low < metric.high) any.low = -infinity, any.high = infinity;
    return toleranceOf(any, column, converged, twins, tolerance);
}

std::pair<double, std::size_t> furthest(const Trial& trial, const std::vector<Metric>& metrics,
                                        const std::vector<MetricTolerance>& tolerances) {
    if (!trial.whole()) return {unlimited, 0};
    std::pair<double, std::size_t> worst{0, 0};
    for (std::size_t m = 0; m < metrics.size(); ++m)
        if (const double change = tolerances[m].changeOf(figuresOf(metrics[m], m, trial.rows));
            change > worst.first)
            worst = {change, m};
    return worst;
}

Tuning tune(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder) {
    return Tuner(run, options, folder).tuning();
}

}  // namespace plait
