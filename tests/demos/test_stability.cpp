// The failure atlas: methods end where theory says, and nowhere before what golden/stability holds.
#include "demos/stability/atlas.h"
#include "demos/stability/hanging_chain.h"
#include "demos/stability/spring_sheet.h"
#include "demos/stability/watch.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "program.h"
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace plait;
using plait::test::note;
using plait::test::report;

namespace {

std::vector<Boundary> stored(const StabilityMap& map) {
    const std::string path = std::string(PLAIT_ROOT) + "/golden/stability/" + map.name + ".csv";
    return boundariesFrom(readWhole(path), path);
}

// At the first `most` places of these panels, or of all.
void checkMap(const std::string& name, const std::vector<std::string>& panels = {},
              std::size_t most = 100) {
    const StabilityMap& map = stabilityMapNamed(name);
    const std::vector<Boundary> found = traceBoundaries(map, panels, most);
    REQUIRE(!found.empty());
    std::printf("%s", boundaryText(map, found).c_str());
    for (const std::string& complaint : complaints(map, stored(map), found)) {
        INFO(complaint);
        CHECK(false);
    }
}

// The unit spring of the scenes, let go at 1 m. Symplectic Euler keeps (x^2 + v^2 - h x v) / 2; of
// the others E is (x^2 + v^2) / 2.
plait::Outcome unitSpring(Method method, double h, int steps) {
    Scene scene = build(findScene("unit-spring"));
    scene.options = {.method = method,
                     .schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = 1},
                     .timeScale = h};
    Solver<double> solver(scene.world, scene.options);
    const double cross = method == Method::symplectic ? h : 0;
    Judge judge(0.5, 2);
    watch(solver, steps, judge, [&] {
        const double x = solver.positions()[0].x, v = solver.velocities()[0].x;
        return judge.see((x * x + v * v - cross * x * v) / 2, 0);
    });
    return judge.outcome();
}

}  // namespace

TEST_CASE("stability: what a cell is", "[stability]") {
    const auto outcome = [](double energy, double strain, double work = 0) {
        Judge judge(2, 0.1);
        judge.see(energy, strain, work);
        return judge.outcome();
    };
    CHECK(outcome(2.0, 0.1) == plait::Outcome::ok);
    CHECK(outcome(2.03, 0.1) == plait::Outcome::drifting);
    CHECK(outcome(2.0, 0.11) == plait::Outcome::drifting);
    CHECK(outcome(2.11, 0) == plait::Outcome::exploded);
    CHECK(outcome(3.0, 0, 1) == plait::Outcome::ok);
    CHECK(outcome(0, 2.01) == plait::Outcome::exploded);
    CHECK(outcome(std::numeric_limits<double>::quiet_NaN(), 0) == plait::Outcome::notFinite);
    CHECK(outcome(0, std::numeric_limits<double>::infinity()) == plait::Outcome::notFinite);
    Judge judge(1, 1);
    CHECK_FALSE(judge.see(2, 0));
    judge.see(1, 0);
    judge.seeDrift();
    CHECK(judge.outcome() == plait::Outcome::exploded);  // once is enough
}

TEST_CASE("stability: the unit spring explodes beyond h = 2", "[stability][IN6]") {
    double good = 1, bad = 3;
    while (bad - good > 1e-7) {
        const double h = (good + bad) / 2;
        (unitSpring(Method::symplectic, h, 30000) < plait::Outcome::exploded ? good : bad) = h;
    }
    CHECK(report("symplectic, boundary - 2", std::fabs(good - 2), 1e-6));
    // 1 + h^2 a step (A0): 5 % of energy in ln 1.05 / ln 1.0001 = 487.9 steps.
    CHECK(unitSpring(Method::explicitEuler, 0.01, 487) < plait::Outcome::exploded);
    CHECK(unitSpring(Method::explicitEuler, 0.01, 489) == plait::Outcome::exploded);
    for (const double h : {0.01, 1.9, 2.1, 100.0})
        CHECK(unitSpring(Method::implicit, h, 1000) == plait::Outcome::ok);
}

TEST_CASE("stability: boundaries are found, kept and compared", "[stability]") {
    StabilityMap map{.name = "steps",
                     .title = {},
                     .words = {},
                     .note = {},
                     .theoryWords = {},
                     .x = {"x", 1, 10},
                     .y = {"y", 1, 1024, true},
                     .boundaryAt = {2},
                     .panels = {{"a",
                                 [](double, double y) {
                                     return y > 100 ? plait::Outcome::exploded : plait::Outcome::ok;
                                 },
                                 [](double) { return 101.0; }, true}}};
    const Boundary found = traceBoundary(map, map.panels[0], 2);
    CHECK(found == Boundary{"a", 2, 100});
    map.goodAtLowY = false;
    CHECK(traceBoundary(map, map.panels[0], 2) == Boundary{"a", 2, 1, true});
    map.panels[0].cell = [](double, double y) {
        return y < 100 ? plait::Outcome::exploded : plait::Outcome::ok;
    };
    CHECK(traceBoundary(map, map.panels[0], 2) == Boundary{"a", 2, 100});
    map.panels[0].cell = [](double, double) { return plait::Outcome::exploded; };
    CHECK(traceBoundary(map, map.panels[0], 2) == Boundary{"a", 2, {}});
    map.goodAtLowY = true;
    CHECK(traceBoundary(map, map.panels[0], 2) == Boundary{"a", 2, {}});
    map.panels[0].cell = [](double, double) { return plait::Outcome::drifting; };
    CHECK(traceBoundary(map, map.panels[0], 2) == Boundary{"a", 2, 1024, true});

    const std::vector<Boundary> all{found, {"b, c", 3, {}}, {"d", 4, 5.5, true}};
    CHECK_THROWS_AS(boundariesFrom("panel,x,y,open\na,1", "file"), FileError);
    CHECK(boundariesFrom(csvOf({found, {"d", 4, 5.5, true}}), "file") ==
          std::vector{found, Boundary{"d", 4, 5.5, true}});

    const auto complains = [&](std::optional<double> now) {
        return complaints(map, {found}, {{"a", 2, now}}).size();
    };
    CHECK(complains(100) == 0);
    CHECK(complains(96) == 0);
    CHECK(complains(95) == 1);
    CHECK(complains({}) == 1);
    CHECK(complains(112) == 1);  // does not fail where theory says it must
    CHECK(complaints(map, {}, {found}).size() == 1);
    map.goodAtLowY = false;
    CHECK(complains(104) == 0);
    CHECK(complains(106) == 1);
    CHECK(complains(90) == 1);
}

TEST_CASE("stability: theory of a settled chain is the law of one sweep", "[stability]") {
    for (const int links : {2, 10, 40}) {
        const HangingChain chain{std::vector<double>(links, 1.0), std::vector<double>(links, 0.0)};
        const double h = 1.0 / 180;
        const double excess = settledExcess(chain, {.substeps = 3}) / (9.81 * h * h);
        // Two colours, the top link's first; swept back as well, as good as forward alone (A1).
        CHECK(report(std::to_string(links) + " links: excess over g h^2 (N^2 / 2 - 1)",
                     std::fabs(excess / (links * links / 2.0 - 1) - 1), 1e-12));
    }
}

TEST_CASE("stability: the sheet's fastest mode", "[stability]") {
    const double omega = SpringSheet(8, 100).omegaMax();
    // Gershgorin (A0): at most 2 max sum k / m; inner vertices join six springs.
    const double m = 0.02 / 64;
    CHECK(omega * omega <= 2 * 6 * 100 / m);
    CHECK(report("omega max grows as the root of k",
                 std::fabs(SpringSheet(8, 10000).omegaMax() / omega / 10 - 1), 1e-12));
    const StabilityMap& map = stabilityMapNamed("step-stiffness");
    for (const double k : {10.0, 100.0}) {
        const Boundary found = traceBoundary(map, map.panels[1], k);
        REQUIRE(found.y);
        CHECK(report("symplectic, h omega / 2 - 1",
                     std::fabs(*found.y / map.panels[1].theory(k) - 1), 0.02));
    }
}

TEST_CASE("stability: boundaries stay where they are", "[stability][figures]") {
    checkMap("chain-length", {}, 3);
    checkMap("rotation", {}, 2);
    checkMap("rod-segments", {}, 2);
    checkMap("speed-thickness", {}, 2);
    checkMap("layers-passes", {}, 1);
    checkMap("stiffness-ratio", {"xpbd"}, 2);
    checkMap("step-stiffness", {"explicit", "symplectic", "xpbd"}, 2);
}

TEST_CASE("stability: every boundary stays where it is", "[stability][long]") {
    for (const StabilityMap& map : stabilityMaps())
        if (!map.boundaryAt.empty()) checkMap(map.name);
}

TEST_CASE("stability: what is interrupted goes on where it was", "[stability]") {
    const plait::test::TemporaryFolder folder;
    int worked = 0, stopAt = 5;
    const StabilityMap map{.name = "halves",
                           .title = {},
                           .words = {},
                           .note = {},
                           .theoryWords = {},
                           .x = {"x", 1, 10},
                           .y = {"y", 1, 10},
                           .boundaryAt = {},
                           .panels = {{"a", [&](double x, double y) {
                                           if (worked == stopAt) throw Interrupted("stopped");
                                           ++worked;
                                           return x < y ? plait::Outcome::ok
                                                        : plait::Outcome::exploded;
                                       }}}};
    CHECK_THROWS_AS(workOut(map, 3, 1, true, folder / "done.csv"), Interrupted);
    stopAt = 100;
    // What is kept of other cells is of no use.
    const Atlas other = workOut(map, 2, 1, true, folder / "other.csv");
    CHECK(other.outcomes[0] == std::vector{2, 2, 0, 2});
    worked = 0;
    const Atlas atlas = workOut(map, 3, 1, true, folder / "done.csv");
    CHECK(worked == 4);
    CHECK(atlas.outcomes[0] == std::vector{2, 2, 2, 0, 2, 2, 0, 0, 2});
    CHECK_FALSE(std::filesystem::exists(folder / "done.csv"));
}

TEST_CASE("stability: maps by name", "[stability][program]") {
    const plait::test::TemporaryFolder folder;
    const plait::test::Outcome list = plait::test::plait(folder, {"stability"});
    CHECK(list.status == 0);
    for (const StabilityMap& map : stabilityMaps()) {
        CHECK(list.out.find(map.name) != std::string::npos);
        CHECK(!map.words.empty());
    }
    const plait::test::Outcome wrong = plait::test::plait(folder, {"stability", "chain-lenght"});
    CHECK(wrong.status == exitUsage);
    CHECK(wrong.out.empty());
    CHECK(wrong.err.find("nearest: chain-length") != std::string::npos);
    CHECK(std::count(wrong.err.begin(), wrong.err.end(), '\n') == 1);
    CHECK(plait::test::plait(folder, {"stability", "rotation", "--jobs", "0"}).status == exitUsage);
}
