// The ledgers of the demos (golden/ledger) and their tunings (golden/tune): they still are about
// their scenes, and leave nothing to complain of. By counted work alone.
#include "demos/ledger/ledger.h"
#include "demos/ledger/tune.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "tests/catch.h"

#include <algorithm>
#include <limits>

namespace plait::test {
namespace {

Ledger stored(const std::string& scene) {
    const std::string path = PLAIT_ROOT "/golden/ledger/" + scene + ".csv";
    return ledgerFrom(readWhole(path), path);
}

Tuning storedTuning(const std::string& scene) {
    const std::string path = PLAIT_ROOT "/golden/tune/" + scene + ".csv";
    return tuningFrom(readWhole(path), path);
}

void none(const std::string& scene, const std::vector<std::string>& lines) {
    INFO(scene << ": mend it, or store its ledger again: golden/README.md");
    CHECK(lines == std::vector<std::string>{});
}

void checkBase(const std::string& scene) {
    const Ledger ledger = stored(scene);
    const double unlimited = std::numeric_limits<double>::infinity();
    none(scene, differences(ledger, tryOut(runOf(ledger.settings), {unlimited, unlimited})));
}

std::vector<std::string> demos() {
    std::vector<std::string> names;
    for (const SceneEntry& entry : scenes())
        if (entry.demo) names.push_back(entry.name);
    return names;
}

// What is tried beside a run anew, and would be cheaper.
void checkCheapest(const std::string& scene) {
    const Tuning tuning = storedTuning(scene);
    const Run run = runOf(tuning.settings);
    const double unlimited = std::numeric_limits<double>::infinity();
    const Trial own = tryOut(run, {unlimited, unlimited});
    const auto [far, metric] = furthest(own, tuning.metrics, tuning.tolerances);
    INFO(scene << ": " << tuning.metrics[metric].name);
    CHECK(far <= 1);
    for (const Run& from : {run, bySet(run)})
        for (const Ingredient& change : cheaperSettings(from)) {
            const Trial trial = tryOut(without(from, {&change, 1}), limitOf(own));
            INFO(change.name());
            CHECK((furthest(trial, tuning.metrics, tuning.tolerances).first > 1 ||
                   trial.evaluations() >= own.evaluations()));
        }
}

// Not tuned yet: a trial of either takes minutes.
const std::vector<std::string> untuned{"dress", "liquid"};

// Those whose whole clip takes a few seconds at draft.
const std::vector<std::string> cheap{"wine-glass", "glass", "flag"};

}  // namespace

TEST_CASE("ledgers: demos have no needless ingredient and no idle metric", "[ledger]") {
    std::vector<std::string> found;
    for (const std::string& scene : demos())
        for (const std::string& line : stored(scene).complaints()) found.push_back(line);
    CHECK(found == std::vector<std::string>{});
}

TEST_CASE("ledgers: settings, metrics and ingredients are those of the demos", "[ledger]") {
    for (const std::string& scene : demos()) {
        const Ledger ledger = stored(scene);
        none(scene, differences(ledger, runOf(ledger.settings)));
    }
}

TEST_CASE("ledgers: cheap demos come to what their ledgers say", "[ledger][figures]") {
    for (const std::string& scene : cheap) checkBase(scene);
}

TEST_CASE("ledgers: the other demos come to what their ledgers say", "[ledger][long]") {
    for (const std::string& scene : demos())
        if (std::ranges::count(cheap, scene) == 0) checkBase(scene);
}

// Its ledger is of half a second, in which mending moves nothing.
TEST_CASE("ledgers: without mending the dress's threads stretch after four seconds",
          "[ledger][dress][long]") {
    const Run run = makeRun(
        {{"scene", "dress"}, {"quality", "draft"}, {"without", "silk mending,tulle mending"}});
    const double unlimited = std::numeric_limits<double>::infinity();
    const Trial trial = tryOut(run, {unlimited, unlimited});
    const Metric& strain = run.scene.metrics[0];
    REQUIRE(strain.name == "strain");
    CHECK(figuresOf(strain, 0, trial.rows).most > strain.high);
}

TEST_CASE("tunings: demos have the cheapest settings that keep what is converged", "[ledger]") {
    for (const std::string& scene : demos()) {
        const bool stored = std::filesystem::exists(PLAIT_ROOT "/golden/tune/" + scene + ".csv");
        CHECK(stored == (std::ranges::count(untuned, scene) == 0));
        if (!stored) continue;
        const Tuning tuning = storedTuning(scene);
        none(scene, differences(tuning, runOf(tuning.settings)));
    }
}

TEST_CASE("tunings: those that are cheap, tried anew", "[ledger][long]") {
    for (const char* scene : {"flag", "glass", "wine-glass"}) checkCheapest(scene);
}

TEST_CASE("tunings: one that no longer is of its scene is found out", "[ledger]") {
    const Tuning tuning = storedTuning("flag");
    const Run run = runOf(tuning.settings);
    REQUIRE(differences(tuning, run).empty());
    CHECK(csvOf(tuningFrom(csvOf(tuning), "flag")) == csvOf(tuning));
    Run other = run;
    other.scene.options.schedule.substeps *= 2;
    CHECK(differences(tuning, other).size() == 2);
    other = run;
    other.scene.metrics[0].high *= 2;
    CHECK(differences(tuning, other).size() == 2);
    Tuning worse = tuning;
    worse.ownWorst = 1.5;
    CHECK(differences(worse, run).size() == 1);
    worse.options = "--substeps 30";
    CHECK(differences(worse, run).size() == 2);
}

TEST_CASE("ledgers: one that no longer is of its scene is found out", "[ledger]") {
    const Ledger ledger = stored("flag");
    const Run run = runOf(ledger.settings);
    REQUIRE(differences(ledger, run).empty());
    CHECK(csvOf(ledgerFrom(csvOf(ledger), "flag")) == csvOf(ledger));
    Run other = run;
    other.scene.options.schedule.substeps /= 2;
    CHECK(differences(ledger, other).size() == 4);  // it, and what half of it is, before and now
    other = run;
    other.scene.metrics[0].high *= 2;
    CHECK(differences(ledger, other).size() == 2);
    other = run;
    other.scene.world.forces.pop_back();
    CHECK_FALSE(differences(ledger, other).empty());

    Trial base;
    base.rows.push_back({0, 0, ledger.work, {}});
    for (const MetricTolerance& tolerance : ledger.tolerances)
        base.rows[0].values.push_back(tolerance.base.mean);
    Ledger still = ledger;
    for (MetricTolerance& tolerance : still.tolerances)
        tolerance.base.least = tolerance.base.most = tolerance.base.mean;
    CHECK(differences(still, base).empty());
    base.rows[0].evaluations += ledger.work / 40;
    CHECK(differences(still, base).size() == 1);
    base.rows[0].values[0] += 1.01 * ledger.tolerances[0].allowed.mean +
                              ledger.tolerances[0].allowed.least +
                              ledger.tolerances[0].allowed.most;
    CHECK(differences(still, base).size() == 2);
    CHECK_THROWS_AS(ledgerFrom("setting,value\nscene,flag\n\nmetric\n", "x"), FileError);
}

}  // namespace plait::test
