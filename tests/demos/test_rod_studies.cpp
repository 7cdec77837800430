// Studies of rods: errors of the solver alone, what is measured of a falling coil, and Jolt's
// table.
#include "demos/study/definitions/definitions.h"
#include "demos/study/definitions/peers.h"
#include "demos/study/references/heavy_rod.h"
#include "demos/study/solve.h"
#include "scenes/slinky/slinky.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>
#include <sstream>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// Off in drop, in length; m/s.
std::vector<double> droop(const Settings& settings) {
    const Study& study = studyNamed("cantilever");
    const Run run = studyRun(study, settings);
    return study.measure(study, run, solve(study, run, false), {});
}

}  // namespace

// The slowest swing is damped by 4/s, so that of its first fall exp(-2 t) is left.
TEST_CASE("study: at once a heavy rod rests where its chain does, swept it does not",
          "[study][rods]") {
    const double left = std::exp(-2.0 * 8);
    for (const char* substeps : {"1", "10", "50"}) {
        const auto errors = droop({{"substeps", substeps}});
        const std::string name = std::string("at once, substeps ") + substeps;
        CHECK(report(name + ": drop off", errors[0], 2 * left));
        CHECK(report(name + ": length off", errors[1], 1e-6));
        CHECK(report(name + ": speed, m/s", errors[2], 1e-5));
    }
    for (const char* substeps : {"10", "50"}) {
        const auto errors = droop({{"knob.solve", "sweeps"}, {"substeps", substeps}});
        note(std::string("swept, substeps ") + substeps + ": drop off", errors[0]);
        CHECK(errors[0] > 0.25);
    }
}

// Of the mesh alone: a joint has 2 tan(psi / 2) for psi, and directors weigh beside the rod. That
// nothing else is off, the scene's own metric holds (test_curves.cpp).
TEST_CASE("study: with frames a heavy rod is as stiff for any substeps", "[study][rods]") {
    const auto off = [](const char* substeps) {
        return droop({{"knob.solve", "frames"}, {"substeps", substeps}})[0];
    };
    const double coarse = off("1"), fine = off("20");
    CHECK(report("with frames: drop off", fine, 5e-4));
    CHECK(report("with frames, 1 substep beside 20: drop off", std::fabs(coarse - fine), 5e-6));
}

// Rows as they were measured: substeps in 1/60 s | error of the drop | stretch of the rod | m/s of
// the tip at rest; 64 segments, w L^3 / B = 10, 43 ns a segment and substep.
TEST_CASE("Jolt's rods stand in charts as they were measured", "[study][rods]") {
    constexpr const char* measured =
        "10 9.1 3.2 5e-5\n20 2.3 .78 3e-4\n50 .3 .12 1e-3\n100 2.0 .03 4e-3\n200 4.4 .007 1e-2\n";
    const std::vector<Peer> peers = peersOnRod();
    REQUIRE(peers.size() == 1);
    std::istringstream rows(measured);
    double substeps, drop, stretch, speed;
    std::size_t i = 0;
    for (; rows >> substeps >> drop >> stretch >> speed; ++i) {
        INFO(substeps << " substeps");
        REQUIRE(i < peers[0].points.size());
        const PeerPoint& point = peers[0].points[i];
        // .14 ms a frame of 1/60 s with 50 of them.
        CHECK(std::fabs(point.cost / (2.5 * 0.1376 * substeps / 50) - 1) < 1e-3);
        CHECK(std::fabs(point.errors[0] / (drop / 100) - 1) < 1e-9);
        CHECK(std::fabs(point.errors[1] / (stretch / 100) - 1) < 1e-9);
        CHECK(point.errors[2] == speed);
    }
    CHECK(i == peers[0].points.size());
    // The chain whose first link is rigid, which is what they are off.
    CHECK(std::fabs(heavyRodTip(10, 64, 0).drop - .68878) < 1e-5);
    CHECK(std::fabs(heavyRodTip(10, 64, 0).reach - .66636) < 1e-5);
}

TEST_CASE("study: what is measured of a slinky that is let go", "[study][rods]") {
    const Study& study = studyNamed("slinky");
    const Run run = studyRun(study, {});
    REQUIRE(run.scene.metrics[0].name == "last turn hangs");
    REQUIRE(run.scene.metrics[1].name == "last turn moves");
    // In what it plays what hangs 2 % too long is seen.
    CHECK(run.frames() / run.frameRate() - 0.25 > 1.02 * Slinky{}.collapse());
    Recording recording;
    recording.metrics = {{0.34, 0.3}, {0.35, 0.1}};
    const auto errors = study.measure(study, run, recording, {});
    recording.metrics[1][0] = 0.345;
    const auto earlier = study.measure(study, run, recording, {});
    REQUIRE(errors.size() == 3);
    // It hangs 2.2 % shorter than its wire, whose last turn would hang for 0.984 sqrt(m / 3 k):
    // what is stretched by 0.968 of m g / 2 k closes sooner.
    const double own = 0.35 / (1 + errors[0]);
    CHECK(report("time from its shape, off",
                 std::fabs(own / (std::sqrt(0.968 * (1 - errors[1])) * Slinky{}.collapse()) - 1),
                 0.01));
    CHECK(report("time, of what is told",
                 std::fabs((1 + errors[0]) / (1 + earlier[0]) - 0.35 / 0.345), 1e-12));
    CHECK(report("extension off, hung", errors[1], 0.025));
    CHECK(report("way of the last turn", std::fabs(errors[2] - 0.003), 1e-12));
    recording.ending = "diverged";
    CHECK(std::isinf(study.measure(study, run, recording, {})[0]));
}

TEST_CASE("study: settings are those of its runs, of another model too", "[study]") {
    Study study = studyNamed("unit-spring");
    const Settings settings{{"substeps", "3"}};
    CHECK(studySettings(study, settings) == settingsOf(studyRun(study, settings)));
    study.model.emplace_back("seed", "7");
    CHECK(valueOf(studySettings(study, settings), "seed") == "7");
}
