// The pictures of Stam 2009, section 7: what they show is so.
#include "demos/study/pages/collision.h"
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/solver.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

TEST_CASE("collision: on a line, ends change hands or are shared", "[collision]") {
    const std::vector<LineParticle> two{{0, 1}, {0.5, 0.25}};
    const auto elastic = resolveOnLine(two, 1, 9), inelastic = resolveOnLine(two, 0, 9);
    REQUIRE(elastic.size() == 2);
    CHECK(std::fabs(elastic[1][0].end - 0.25) < 1e-15);
    CHECK(std::fabs(elastic[1][1].end - 1) < 1e-15);
    // Half of the sum of their paths: they go on together.
    CHECK(std::fabs(inelastic.back()[0].end - 0.625) < 1e-15);
    CHECK(std::fabs(inelastic.back()[1].end - 0.625) < 1e-15);
    CHECK(resolveOnLine({{0, 0.4}, {0.5, 0.45}}, 1, 9).size() == 1);  // these do not meet
    CHECK(resolveOnLine(two, 1, 0).size() == 1);
}

// Alike and elastic, particles only hand on their ends: whatever the order of their meetings, in
// the end these are sorted.
TEST_CASE("collision: seven on a line end in order", "[collision][CC13][FX34]") {
    std::vector<LineParticle> particles;
    std::vector<double> ends;
    for (int i = 0; i < 7; ++i) {
        particles.push_back({i / 6.0, (i * 5 % 7 * 13 % 7) / 6.0});
        ends.push_back(particles.back().end);
    }
    const auto stages = resolveOnLine(particles, 1, 100);
    std::sort(ends.begin(), ends.end());
    double worst = 0;
    for (std::size_t i = 0; i < ends.size(); ++i)
        worst = std::max(worst, std::fabs(stages.back()[i].end - ends[i]));
    CHECK(report("ends - ends in order", worst, 1e-14));
    CHECK(stages.size() < 100);
}

TEST_CASE("collision: bullets are found on their way, and missed where they end",
          "[collision][CC2]") {
    for (const double length : {1.0, 30.0, 1e3, 1e5})
        CHECK(foundBullets(length, 500).onTheWay == 1);
    CHECK(foundBullets(1, 500).atEnd == 1);
    // A step of n thicknesses, upright, ends within one of them in one of n cases.
    CHECK(foundBullets(30, 500).atEnd < 1.5 / 30);
    CHECK(foundBullets(1e5, 500).atEnd < 0.01);
}

TEST_CASE("collision: a sheet holds a ball that is looked for on its way, and only that",
          "[collision][CC2][FX33]") {
    const auto leastClearance = [](const char* detection) {
        const SceneEntry& entry = findScene("bullet");
        Knobs knobs = Knobs::defaults(entry.knobs, Quality::preview);
        knobs.texts["detection"] = detection;
        const Scene scene = entry.build(knobs);
        Solver<float> solver(scene.world, scene.options);
        double least = 1;
        for (int frame = 1; frame <= 12; ++frame) {
            solver.frame();
            const std::vector<Vec<double>> x = solver.positions(), v = solver.velocities();
            least = std::min(least, scene.metrics[0].measure({x, v, solver.time(), frame}));
        }
        return least;
    };
    CHECK(leastClearance("path") > 0.018);
    CHECK(leastClearance("end") < -0.5);
}
