// Scenes of points that come and go: how long sparks live, that sand is not lost, and that drops
// stay on what they roll over.
#include "bands.h"
#include "tests/report.h"

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

int thereOf(const Solver<float>& solver, Range range) {
    const auto ages = solver.ages();
    return static_cast<int>(std::count_if(ages.begin() + range.first, ages.begin() + range.last,
                                          [](double age) { return age >= 0; }));
}

}  // namespace

// They live for 2 s, two thirds more or less, evenly; the first shell bursts at 3.32 s.
TEST_CASE("fireworks: sparks come at once and go as their lifespans say",
          "[sources][scenes][FX18][PA2]") {
    const Scene scene = draftOf("fireworks", {});
    const Range stars = scene.view.looks[1].object;
    Solver<float> solver(scene.world, scene.options);
    double oldest = 0, worst = 0;
    for (int frame = 1; frame <= 24 * 6.25; ++frame) {
        solver.frame();
        const double age = frame / 24.0 - 3.3181;
        const double expected = age < 0 ? 0 : std::clamp((8.0 / 3 - age) / (4.0 / 3), 0.0, 1.0);
        const double part = thereOf(solver, stars) / double(stars.size());
        if (std::fabs(age) > 0.05) worst = std::max(worst, std::fabs(part - expected));
        for (const double each : solver.ages()) oldest = std::max(oldest, each);
    }
    // Of 500 by chance: two standard deviations of a half are 0.045.
    CHECK(report("part alight against that of their lifespans, off by", worst, 0.06));
    CHECK(report("oldest of all, s", oldest, 8.0 / 3 + 1.0 / 240));
    CHECK(thereOf(solver, stars) == 0);
}

TEST_CASE("dissolve: what is let go of falls, and none is lost", "[grains][scenes][FX19]") {
    const Scene scene = draftOf("dissolve", {});
    const int all = static_cast<int>(scene.world.start.size());
    Solver<float> solver(scene.world, scene.options);
    double held = 0, lowest = 1;
    std::vector<Vec<double>> before;
    for (int frame = 1; frame <= 30; ++frame) {
        solver.frame();
        const auto at = solver.positions();
        REQUIRE(thereOf(solver, {0, all}) == all);
        // Nothing is let go of before 0.7 s.
        for (int v = 0; v < all && !before.empty() && frame < 17; ++v)
            held = std::max(held, length(at[v] - before[v]));
        before = before.empty() ? at : before;
        for (const Vec<double>& p : at) lowest = std::min(lowest, p.y);
    }
    CHECK(report("what is held moves by, m", held, 2e-3));
    CHECK(lowest > 0);
}

TEST_CASE("droplets: drops stay on the leaf, none in it", "[liquid][tension][scenes][FX21]") {
    const Scene scene = draftOf("droplets", {});
    Solver<float> solver(scene.world, scene.options);
    double deepest = 1;
    for (int frame = 1; frame <= 12; ++frame) {
        solver.frame();
        for (const Vec<double>& p : solver.positions())
            deepest = std::min(deepest, length(p + Vec<double>{0, 0.1, 0}) - 0.1);
    }
    CHECK(deepest > 0);
    CHECK(report("the first is nearer than, m", deepest, 1e-4));
}
