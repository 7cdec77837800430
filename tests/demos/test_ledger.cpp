// What a scene needs: ingredients read off it, taken away, and judged.
#include "demos/ledger/ledger.h"
#include "demos/ledger/tune.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "tests/catch.h"
#include "tests/scratch_folder.h"

#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <limits>
#include <set>

namespace plait::test {
namespace {

std::set<std::string> namesOf(const std::vector<Ingredient>& all) {
    std::set<std::string> names;
    for (const Ingredient& ingredient : all) names.insert(ingredient.name());
    return names;
}

const Ingredient& find(const std::vector<Ingredient>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &Ingredient::name);
    REQUIRE(found != all.end());
    return *found;
}

std::vector<std::string> setsOf(const Run& run) {
    std::vector<std::string> names;
    for (const World::Set& set : run.scene.world.sets) names.push_back(set.options.name);
    return names;
}

Range addRope(World& world, double x, int links, const std::string& name) {
    const Range rope =
        world.add(chain({.links = links, .from = {x, 0, 0}, .to = {x + 0.1 * links, 0, 0}}));
    world.pin({rope.first});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, rope), world.rest),
                    {.name = name});
    return rope;
}

// A rope that is watched, one that nobody looks at, a metric that says nothing, and a guard.
Scene twoRopes(const Knobs&) {
    Scene scene;
    const Range watched = addRope(scene.world, 0, 4, "watched");
    addRope(scene.world, 10, 16, "unwatched");
    scene.world.act<Gravity>(GravityOptions{});
    scene.options.schedule = {.substeps = 20, .iterations = 4};
    scene.options.smoothing = 0;
    scene.seconds = 0.5;
    scene.metrics = {{.name = "height",
                      .unit = "m",
                      .measure =
                          [=](const Snapshot& at) {
                              return at.positions[static_cast<std::size_t>(watched.last) - 1].y;
                          },
                      .low = -0.5,
                      .high = 0.1},
                     {.name = "one",
                      .unit = "",
                      .measure = [](const Snapshot&) { return 1.0; },
                      .low = 0,
                      .high = 2},
                     {.name = "none",
                      .unit = "",
                      .measure = [](const Snapshot&) { return 0.0; },
                      .low = 0,
                      .high = 0}};
    return scene;
}

Run ropes(const SceneEntry& entry) {
    Run run;
    run.entry = &entry;
    run.knobs.quality = Quality::draft;
    run.scene = entry.build(run.knobs);
    return run;
}

const SceneEntry ropesEntry{.name = "two-ropes",
                            .title = "",
                            .lesson = "",
                            .ingredients = {},
                            .omissions = {},
                            .build = twoRopes};

Need needOf(const Ledger& ledger, const std::string& part) {
    const auto row = std::ranges::find_if(
        ledger.rows, [&](const LedgerRow& r) { return r.part == part && r.change == "left out"; });
    REQUIRE(row != ledger.rows.end());
    return row->need;
}

}  // namespace

TEST_CASE("ledger: ingredients are read off the world and its options", "[ledger]") {
    const Run flag = makeRun({{"scene", "flag"}, {"quality", "draft"}});
    const std::set<std::string> names = namesOf(ingredientsOf(flag));
    for (const std::string& set : setsOf(flag)) CHECK(names.contains(set + ": left out"));
    for (const char* name :
         {"gravity: left out", "air: left out", "air: without what it carries",
          "air: without gusts", "contacts: without friction",
          "contacts: without contact with itself", "contacts: without the way there",
          "substeps: 30 for 60", "integrator: first order", "direction: one way"}) {
        INFO(name);
        CHECK(names.contains(name));
    }
    CHECK_FALSE(names.contains("mesh: that of draft"));  // there is none coarser
    CHECK_FALSE(names.contains("iterations: 0 for 1"));
    const Run finer = makeRun({{"scene", "flag"}, {"quality", "preview"}});
    const std::vector<Ingredient> all = ingredientsOf(finer);
    const Run coarse = without(finer, {&find(all, "mesh: that of draft"), 1});
    CHECK(coarse.scene.world.start.size() == flag.scene.world.start.size());
    CHECK(coarse.scene.options.schedule.substeps == finer.scene.options.schedule.substeps);
    const Run sheet = makeRun({{"scene", "hanging-sheet"}, {"knob.size", "24"}});
    CHECK(namesOf(ingredientsOf(sheet)).contains("size: 12 for 24"));
}

TEST_CASE("ledger: what is left out is gone, and the rest finds its place", "[ledger]") {
    const Run glass = makeRun({{"scene", "glass"}, {"quality", "draft"}});
    const std::vector<Ingredient> all = ingredientsOf(glass);
    std::vector<std::string> sets = setsOf(glass);
    const std::size_t welds = static_cast<std::size_t>(glass.scene.world.clusters);
    const std::string name = sets.at(welds);
    for (const std::string& other : sets) {
        const Run run = without(glass, {&find(all, other + ": left out"), 1});
        CHECK(setsOf(run).size() == sets.size() - 1);
        CHECK(std::ranges::count(setsOf(run), other) == 0);
        const int clusters = run.scene.world.clusters;
        if (other == name)
            CHECK(clusters == -1);
        else
            CHECK(setsOf(run).at(static_cast<std::size_t>(clusters)) == name);
    }
    // One that is gone stays so, whatever else would be made of it.
    const std::vector<Ingredient> both{find(all, "contacts: left out"),
                                       find(all, "contacts: without friction")};
    CHECK(setsOf(without(glass, both)).size() == sets.size() - 1);
    CHECK(without(glass, {&find(all, "gravity: left out"), 1}).scene.world.forces.size() ==
          glass.scene.world.forces.size() - 1);
}

TEST_CASE("ledger: a change is measured in what is allowed", "[ledger]") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const MetricTolerance t{{1, 0, 2}, {0.5, 0.25, 0}};
    CHECK(t.changeOf({1, 0, 2}) == 0);
    CHECK(t.changeOf({1.5, 0, 2}) == 1);
    CHECK(t.changeOf({1.5, 0.75, 2}) == 3);
    CHECK(t.changeOf({1, 0, 2.0001}) == infinite);  // nothing is allowed
    CHECK(t.changeOf({std::nan(""), 0, 2}) == infinite);
    const Metric late{.name = "", .unit = "", .measure = {}, .from = 1};
    const std::vector<MetricRow> rows{{0, 0, 0, {7}}, {1, 1, 0, {2}}, {2, 2, 0, {4}}};
    const Figures figures = figuresOf(late, 0, rows);
    CHECK(figures.mean == 3);
    CHECK(figures.least == 2);
    CHECK(figures.most == 4);
}

TEST_CASE("ledger: what costs and moves nothing is found, and what tells nothing", "[ledger]") {
    const ScratchFolder folder;
    const Run run = ropes(ropesEntry);
    const LedgerOptions options{.quiet = true};
    const Ledger ledger = ledgerOf(run, options, folder / "ledger");
    CHECK(needOf(ledger, "watched") == Need::needed);
    CHECK(needOf(ledger, "gravity") == Need::needed);
    CHECK(needOf(ledger, "unwatched") == Need::needless);
    const auto row = std::ranges::find(ledger.rows, "unwatched", &LedgerRow::part);
    CHECK(row->work == Approx(16.0 / 20));  // of 20 links 16
    CHECK(ledger.idleMetrics() == std::vector<std::string>{"one"});
    CHECK(ledger.complaints().size() >= 2);
    Ledger outside = ledger;
    outside.tolerances[2].base.most = 1;
    CHECK(outside.complaints().back() == "two-ropes: none: outside its band");
    CHECK(ledger.together.work >= row->work);
    CHECK(ledger.together.change.find("unwatched: left out") != std::string::npos);

    SceneEntry loved = ropesEntry;
    loved.essentials = {"unwatched"};
    const Ledger other = ledgerOf(ropes(loved), options, folder / "other");
    CHECK(needOf(other, "unwatched") == Need::essential);
    CHECK(other.together.change.find("unwatched: left out") == std::string::npos);
}

TEST_CASE("ledger: one that was stopped goes on with what it has", "[ledger]") {
    const ScratchFolder folder;
    const Run run = ropes(ropesEntry);
    const LedgerOptions options{.quiet = true};
    const std::filesystem::path path = folder / "ledger";
    const Ledger before = ledgerOf(run, options, path);
    const auto again = [&] {  // or gone on with: then the times are the same, too
        const Ledger ledger = ledgerOf(run, options, path);
        REQUIRE(ledger.rows.size() == before.rows.size());
        bool same = true;
        for (std::size_t i = 0; i < ledger.rows.size(); ++i) {
            CHECK(ledger.rows[i].work == before.rows[i].work);
            same = same && ledger.rows[i].time == before.rows[i].time;
        }
        return !same;
    };
    CHECK_FALSE(again());
    Run shorter = run;
    shorter.scene.seconds = 0.25;
    CHECK(csvOf(ledgerOf(shorter, options, path)) != csvOf(before));  // is not taken for the other
    CHECK_FALSE(again());
    // What another build has tried says nothing of this one.
    for (const auto& file : std::filesystem::directory_iterator(path / "trials")) {
        std::string trial = readWhole(file.path());
        const std::size_t build = trial.find(" build=");
        REQUIRE(build < trial.find('\n'));
        trial[build + 7] = trial[build + 7] == '0' ? '1' : '0';
        writeWhole(file.path(), trial);
    }
    CHECK(again());
}

TEST_CASE("ledger: evaluations by set are as many as by a count for all", "[ledger]") {
    const Run run = makeRun({{"scene", "flag"}, {"quality", "draft"}, {"iterations", "3"}});
    const Run own = bySet(run);
    CHECK(own.scene.options.schedule.iterations == 0);
    const auto evaluations = [](const Run& of) {
        return tryOut(without(of, {}), {1e18, 1e18}).evaluations();
    };
    Run shortRun = run, shortOwn = own;
    shortRun.scene.seconds = shortOwn.scene.seconds = 0.1;
    CHECK(evaluations(shortRun) == evaluations(shortOwn));
    const std::vector<Ingredient> all = cheaperSettings(own);
    const std::set<std::string> names = namesOf(all);
    CHECK_FALSE(names.contains("gravity: left out"));
    const std::string set = own.scene.world.sets[0].options.name;
    const int importance = own.scene.world.sets[0].options.importance;
    const Run less =
        without(own, {&find(all, set + ": importance " + std::to_string(importance / 2) + " for " +
                                     std::to_string(importance)),
                      1});
    CHECK(less.scene.world.sets[0].options.importance == importance / 2);
    // As the command line says it.
    const std::string words = valueOf(settingsOf(less), "importance");
    const Run told = makeRun({{"scene", "flag"},
                              {"quality", "draft"},
                              {"iterations", "0"},
                              {"passes", valueOf(settingsOf(less), "passes")},
                              {"importance", words}});
    CHECK(valueOf(settingsOf(told), "importance") == words);
    CHECK_THROWS_AS(makeRun({{"scene", "flag"}, {"importance", "none=3"}}), UsageError);
    CHECK_THROWS_AS(makeRun({{"scene", "flag"}, {"importance", set}}), UsageError);
}

// Sweeps of a rope that hangs: four times the substeps of what is converged are needless, and 20 of
// 4 evaluations are not enough.
TEST_CASE("ledger: the cheapest settings keep what is converged", "[ledger]") {
    const ScratchFolder folder;
    const LedgerOptions options{.tolerance = 0.02, .quiet = true};
    Run run = ropes(ropesEntry);
    run.scene.metrics.resize(1);
    const Tuning tuning = tune(run, options, folder / "own");
    REQUIRE_FALSE(tuning.options.empty());
    const auto distance = [&](const Trial& trial) {
        const MetricTolerance t = toleranceOf(run.scene.metrics[0], 0, tuning.converged, {}, 0.02);
        return t.changeOf(figuresOf(run.scene.metrics[0], 0, trial.rows));
    };
    CHECK(distance(tuning.chosen) <= 1);
    for (const TuneStep& step : tuning.steps)
        if (step.taken) CHECK(step.worst <= 1);
    // Told on the command line, it is that run.
    CHECK(tuning.options.find("--") == 0);

    Run fine = run;
    fine.scene.options.schedule.substeps = 400;
    const Tuning lower = tune(fine, options, folder / "fine");
    CHECK(lower.chosen.evaluations() < lower.own.evaluations() / 2);
    CHECK(distance(lower.chosen) <= 1.5);
}

}  // namespace plait::test
