// The pane of the scene: whole until it is struck, and then in shards.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/fracture/welds.h>
#include <plait/solver.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

TEST_CASE("glass: nothing breaks before the ball comes, and then it goes through",
          "[welds][figures][scenes][FX3]") {
    const Scene scene = build(findScene("glass"), Quality::draft);
    const World& world = scene.world;
    Solver<float> solver(world, scene.options);
    const auto broken = [&] {
        const auto holds = holdingOf(world, solver.state());
        return std::count(holds.begin(), holds.end(), 0);
    };
    for (int frame = 0; frame < 10; ++frame) solver.frame();
    REQUIRE(broken() == 0);
    for (int frame = 10; frame < 100; ++frame) solver.frame();
    note("welds of a pane that broke", static_cast<double>(broken()));
    REQUIRE(broken() > 100);
    const auto x = solver.positions(), v = solver.velocities();
    const Snapshot now{.positions = x, .velocities = v, .time = solver.time(), .frame = 100};
    for (const Metric& metric : scene.metrics) {
        const double value = metric.measure(now);
        note(metric.name + ", " + metric.unit, value);
        REQUIRE(value >= metric.low);
        REQUIRE(value <= metric.high);
    }
}
