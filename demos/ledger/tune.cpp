#include "tune.h"

#include "demos/tools/errors.h"
#include "ingredients.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace plait {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int mostRefined = 32;

Run refined(Run run, int times) {
    run.scene.options.schedule.substeps *= times;
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
        : run_(run), metrics_(run_.scene.metrics), trials_("tune", run_, options, folder) {
        tuning_.scene = run.entry->name;
        tuning_.tolerance = options.tolerance;
    }

    Tuning tuning() {
        converge();
        Run run = lower(start(), "");
        if (const Run own = lower(bySet(run), "by set; "); isChanged(own, bySet(run))) run = own;
        tuning_.settings = optionsOf(run, run_);
        return std::move(tuning_);
    }

private:
    Trial trialOf(const std::string& words, const Run& run) const {
        return trials_.of({words}, [&](int) { return run; }, {unlimited, unlimited})[0];
    }

    std::pair<double, std::size_t> worstOf(const Trial& trial) const {
        std::pair<double, std::size_t> worst{0, 0};
        for (std::size_t m = 0; m < metrics_.size(); ++m) {
            const double change =
                trial.whole() ? tolerances_[m].changeOf(figuresOf(metrics_[m], m, trial.rows))
                              : unlimited;
            if (change > worst.first) worst = {change, m};
        }
        return worst;
    }

    void holdTo(const Trial& converged) {
        tolerances_.clear();
        for (std::size_t m = 0; m < metrics_.size(); ++m)
            tolerances_.push_back(
                toleranceOf(metrics_[m], m, converged, twins_, tuning_.tolerance));
    }

    void converge() {
        twins_ = trials_.of(
            {"base", "nudged 1", "nudged 2"},
            [&](int i) { return i == 0 ? run_ : nudged(run_, static_cast<unsigned>(i)); },
            {unlimited, unlimited});
        tuning_.own = twins_[0];
        if (!tuning_.own.whole()) throw SceneError(tuning_.scene + ": " + tuning_.own.ending);
        Trial coarse = tuning_.own;
        for (int times = 2; times <= mostRefined; times *= 2) {
            Trial fine = trialOf("substeps times " + std::to_string(times), refined(run_, times));
            if (!fine.whole()) throw SceneError(tuning_.scene + ": " + fine.ending);
            holdTo(fine);
            ladder_.push_back(std::exchange(coarse, fine));
            if (worstOf(ladder_.back()).first > 1) continue;
            tuning_.refined = times;
            tuning_.converged = std::move(fine);
            tuning_.ownWorst = worstOf(tuning_.own).first;
            return;
        }
        throw SceneError(tuning_.scene + ": converges within no " + std::to_string(mostRefined) +
                         " times its substeps");
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
                tuning_.steps.push_back({how + all[i].name(), tried[i].ending, workOf(tried[i]),
                                         worst, metrics_.empty() ? "" : metrics_[metric].name});
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
    const std::vector<Metric>& metrics_;
    Trials trials_;
    std::vector<Trial> twins_, ladder_;
    std::vector<MetricTolerance> tolerances_;
    Tuning tuning_{};
};

}  // namespace

Tuning tune(const Run& run, const LedgerOptions& options, const std::filesystem::path& folder) {
    return Tuner(run, options, folder).tuning();
}

}  // namespace plait
