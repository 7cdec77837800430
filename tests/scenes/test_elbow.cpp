// The pinched elbow: its arm leaves the cloth room, and the cloth comes free again.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/solver.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

Scene elbowBent(double degrees) {
    const SceneEntry& entry = findScene("elbow");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.numbers.at("bend") = degrees;
    return entry.build(knobs);
}

// Metrics by frame of the film, from the first `frames`.
std::vector<std::vector<double>> filmed(const Scene& scene, int frames) {
    SolverOptions options = scene.options;
    options.threads = 2;
    Solver<float> solver(scene.world, options);
    const int lead = static_cast<int>(24 * scene.lead);
    std::vector<std::vector<double>> rows;
    for (int frame = 1; frame <= lead + frames; ++frame) {
        solver.frame();
        if (frame <= lead) continue;
        const auto x = solver.positions(), v = solver.velocities();
        rows.emplace_back();
        for (const Metric& metric : scene.metrics)
            rows.back().push_back(metric.measure(
                {x, v, solver.time() - scene.lead, frame - lead, solver.failures()}));
    }
    return rows;
}

// The greatest of a metric from a time (s) on.
double greatest(const Scene& scene, const std::vector<std::vector<double>>& rows,
                const std::string& name, double from) {
    const auto metric = std::ranges::find(scene.metrics, name, &Metric::name);
    REQUIRE(metric != scene.metrics.end());
    double most = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<double>(i + 1) / 24 >= from)
            most =
                std::max(most, rows[i][static_cast<std::size_t>(metric - scene.metrics.begin())]);
    return most;
}

}  // namespace

// The arm at its most bent is what the pins of the world say, without a solver. The room in its
// crook is a circle round the axis about which the middles of its sections turn.
TEST_CASE("elbow: its crook has room for a fold, up to 148 degrees", "[elbow]") {
    const auto room = [](double degrees) {
        constexpr int sides = 24;
        const Scene scene = elbowBent(degrees);
        const World::Pins& arm = scene.world.pins.back();
        std::vector<Vec<double>> x(arm.vertices.size());
        arm.animation(scene.lead + 1.2, x);
        const auto middle = [&](int ring) {
            return 0.5 * (x[ring * sides] + x[ring * sides + 12]);
        };
        const Vec<double> a = middle(30), u = middle(36) - a, v = middle(42) - a, n = cross(u, v);
        const Vec<double> axis = a + (0.5 / dot(n, n)) * cross(dot(u, u) * v - dot(v, v) * u, n);
        double least = 1;
        for (std::size_t i = 0; i + sides < x.size(); i += sides)
            least = std::min(least, length(x[i] - axis));
        note("room, mm", 1000 * least);
        return least;
    };
    constexpr double fold = 3 * 0.001;  // m: half of skin, two layers, skin
    CHECK(room(145) > fold);
    CHECK(report("radius at 148 degrees, of three thicknesses", std::fabs(room(148) / fold - 1),
                 0.05));  // half a degree
    CHECK(room(158) < 0.2 * fold);
}

TEST_CASE("elbow: as its sleeve falls nothing passes through anything", "[elbow]") {
    const Scene scene = elbowBent(145);
    const auto rows = filmed(scene, 1);
    for (const char* name : {"crossings", "inside", "pinched"})
        CHECK(greatest(scene, rows, name, 0) == 0);
}

TEST_CASE("elbow: cloth is pinched, keeps its bands and comes free", "[elbow][long][FX36]") {
    for (const double degrees : {120.0, 145.0, 158.0}) {
        const Scene scene = elbowBent(degrees);
        const auto rows = filmed(scene, 72);
        for (const Metric& metric : scene.metrics) {
            INFO(metric.name << " at " << degrees << " degrees");
            const double most = greatest(scene, rows, metric.name, metric.from);
            note(metric.name + " at most", most);
            CHECK(most <= metric.high);
        }
        note("pinched at most", greatest(scene, rows, "pinched", 0));
        CHECK(greatest(scene, rows, "pinched", 0) >= 8);
    }
}

// The arm goes through itself, so that no cloth can stay out of it; opened, it lets the cloth go.
TEST_CASE("elbow: beyond 159 degrees it fails while bent, and comes free all the same",
          "[elbow][long]") {
    const Scene scene = elbowBent(165);
    const auto rows = filmed(scene, 72);
    CHECK(greatest(scene, rows, "crossings", 0) > 0);
    for (const char* name : {"crossings", "inside", "pinched"})
        CHECK(greatest(scene, rows, name, 2.3) == 0);
}
