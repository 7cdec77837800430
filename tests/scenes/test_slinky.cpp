// The slinky against what its wire says (validation A7).
#include "scenes/slinky/slinky.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/solver.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace plait;
using namespace plait::test;

// 86 turns, 68 mm, 2.5 x 0.62 mm of steel: as others have weighed and timed it.
TEST_CASE("slinky: its wire alone says what it weighs and how it swings", "[rods][FX4]") {
    const Slinky slinky;
    CHECK(report("mass off 223.5 g", std::fabs(slinky.mass() / 0.2235 - 1), 2e-3));
    CHECK(report("stiffness off 0.621 N/m", std::fabs(slinky.stiffness() / 0.621 - 1), 5e-3));
    CHECK(report("period off 2.40 s", std::fabs(slinky.period() / 2.40 - 1), 5e-3));
    CHECK(report("collapse off T0 / 4 sqrt(3)",
                 std::fabs(slinky.collapse() / slinky.period() * 4 * std::sqrt(3.0) - 1), 1e-12));
}

TEST_CASE("slinky: hung, let go, its last turn hangs in the air", "[rods][figures][FX4]") {
    const Scene scene = build(findScene("levitation"));
    const Slinky slinky;
    const double extension = -scene.world.start[0].y - slinky.turns * slinky.wire.across;
    note("extension, m", extension);
    CHECK(report("extension off 0.968 m g / 2 k", std::fabs(extension / slinky.extension() - 1),
                 0.025));

    Solver<float> solver(scene.world, scene.options);
    std::vector<double> most(scene.metrics.size());
    for (int frame = 1; frame <= 150; ++frame) {
        solver.frame();
        const auto x = solver.positions(), v = solver.velocities();
        const Snapshot at{x, v, solver.time(), frame, solver.failures()};
        for (std::size_t i = 0; i < most.size(); ++i)
            most[i] = std::max(most[i], scene.metrics[i].measure(at));
    }
    CHECK(report("it hangs off sqrt(m / 3 k)", std::fabs(most[0] / slinky.collapse() - 1), 0.03));
    CHECK(report("last turn moves until then, % of the extension", most[1], 0.5));
    CHECK(report("middle of all off a stone that falls beside it, mm", most[2], 1));
    CHECK(report("what contacts did not hold", most[4], 0));
}

// An end lands where the lower of its turns first lies within 4 mm of a tread below the last one.
TEST_CASE("slinky: it walks down the stairs by itself", "[rods][long][FX4]") {
    const Scene scene = build(findScene("slinky"));
    const Slinky slinky;
    constexpr double rise = 0.12, tread = 0.14;
    Solver<float> solver(scene.world, scene.options);
    const int points = slinky.turns * slinky.links + 1;
    std::vector<double> landings;
    std::array<int, 2> at{0, 0};
    double strain = 0;
    while (solver.time() < scene.seconds) {
        solver.frame();
        const auto x = solver.positions();
        for (const int end : {0, 1}) {
            Vec<double> middle{};
            for (int i = 0; i < slinky.links; ++i)
                middle += (1.0 / slinky.links) * x[end ? points - 1 - i : i];
            const int on = static_cast<int>(std::floor(middle.x / tread));
            if (on <= at[end] || middle.y + on * rise > 4e-3) continue;
            at[end] = on;
            landings.push_back(solver.time());
        }
        for (int i = 0; i + 1 < points; ++i)
            strain = std::max(strain,
                              std::fabs(length(x[i + 1] - x[i]) /
                                            length(scene.world.rest[i + 1] - scene.world.rest[i]) -
                                        1));
    }
    // The first is the hand's, and the one after it begins as the hand left it.
    REQUIRE(landings.size() >= 6);
    const double mean = (landings.back() - landings[1]) / static_cast<double>(landings.size() - 2);
    double uneven = 0;
    for (std::size_t i = 1; i < landings.size(); ++i) {
        const double step = landings[i] - landings[i - 1];
        note("step " + std::to_string(i) + ", s", step);
        if (i > 1) uneven = std::max(uneven, std::fabs(step / mean - 1));
    }
    CHECK(report("mean step off 0.65 s, s", std::fabs(mean - 0.65), 0.05));
    CHECK(report("steps off their mean", uneven, 0.06));
    CHECK(report("wire strain at worst", strain, 0.01));
    CHECK(std::abs(at[0] - at[1]) <= 1);
}
