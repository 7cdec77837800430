// What overlays show of a state that is known.
#include "demos/output/overlays.h"
#include "program.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/numbers/math.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

RunFrame frameAt(const Run& run, const std::function<Vec<double>(const Vec<double>&)>& place) {
    RunFrame frame;
    for (const Vec<double>& x : run.scene.world.rest) {
        frame.positions.push_back(place(x));
        frame.velocities.push_back(0.5 * x);
        frame.touched.push_back(x.x > 0);
    }
    return frame;
}

}  // namespace

// |length less rest| / rest, in percent, the most of the edges at a vertex.
TEST_CASE("an overlay shows strain by its formula", "[program][DI2]") {
    const Run run = makeRun({{"scene", "hanging-sheet"}, {"quality", "draft"}});
    const World& world = run.scene.world;
    const Overlays overlays(run, "strain");
    CHECK(overlays.legend().unit == "%");

    // Longer one way and shorter the other.
    const RunFrame frame =
        frameAt(run, [](const Vec<double>& x) { return Vec<double>{1.03 * x.x, 0.98 * x.y, x.z}; });
    const Overlay overlay = overlays.of(frame);
    std::vector<double> expected(world.rest.size(), 0);
    for (int e = 0; e < world.complex.count(1); ++e) {
        const auto [a, b] = world.complex.edge(e);
        const Vec<double> d = world.rest[a] - world.rest[b];
        const double rest = std::hypot(d.x, d.y, d.z),
                     now = std::hypot(1.03 * d.x, 0.98 * d.y, d.z),
                     percent = 100 * std::fabs(now - rest) / rest;
        expected[a] = std::max(expected[a], percent);
        expected[b] = std::max(expected[b], percent);
    }
    double worst = 0, least = 100, most = 0;
    for (std::size_t v = 0; v < expected.size(); ++v) {
        const double shown = overlay.values[v];
        worst = std::max(worst, std::fabs(shown - expected[v]));
        least = std::min(least, shown), most = std::max(most, shown);
    }
    CHECK(report("strain shown, off, %", worst, 1e-5));
    CHECK(most == Approx(3).margin(1e-4));
    CHECK(least > 1.9);
    // What it is drawn in runs from dark at 0 to light at the legend's end.
    CHECK(overlayColor(overlay, 0) == paletteColors(overlay.palette).front());
    CHECK(overlayColor(overlay, overlays.legend().high) == paletteColors(overlay.palette).back());

    const RunFrame still = frameAt(run, [](const Vec<double>& x) { return x; });
    for (const float value : overlays.of(still).values) CHECK(value == 0);
}

TEST_CASE("an overlay shows speed and contact by vertex", "[program]") {
    const Run run = makeRun({{"scene", "hanging-sheet"}, {"quality", "draft"}});
    const RunFrame frame = frameAt(run, [](const Vec<double>& x) { return x; });
    const Overlay speed = Overlays(run, "velocity").of(frame),
                  contact = Overlays(run, "contacts").of(frame);
    for (std::size_t v = 0; v < frame.velocities.size(); ++v) {
        CHECK(speed.values[v] == static_cast<float>(length(frame.velocities[v])));
        CHECK(contact.values[v] == (run.scene.world.rest[v].x > 0 ? 1.0f : 0.0f));
    }
}
