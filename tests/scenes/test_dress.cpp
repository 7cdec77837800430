// The ballerina's dress, by measures that know nothing of the solver.
#include "scenes/ballerina/ballerina.h"
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"

#include <plait/measure/surfaces/intersections.h>
#include <plait/measure/surfaces/penetration.h>
#include <plait/solver.h>

#include <algorithm>
#include <fstream>

using namespace plait;
using namespace plait::test;

namespace {

// The greatest of each metric over the frames after the first `skip`.
std::vector<double> worst(const Scene& scene, int skip, int frames, int substeps = 0) {
    SolverOptions options = scene.options;
    options.threads = 2;
    if (substeps > 0) options.schedule.substeps = substeps;
    Solver<float> solver(scene.world, options);
    std::vector<double> most(scene.metrics.size(), 0);
    for (int frame = 1; frame <= skip + frames; ++frame) {
        solver.frame();
        if (frame <= skip) continue;
        const auto x = solver.positions(), v = solver.velocities();
        const Snapshot at{x, v, solver.time() - scene.lead, frame - skip, solver.failures()};
        for (std::size_t i = 0; i < most.size(); ++i)
            most[i] = std::max(most[i], scene.metrics[i].measure(at));
    }
    return most;
}

}  // namespace

TEST_CASE("dress: it begins free of her and of itself", "[dress]") {
    const Scene scene = build(findScene("dress"), Quality::draft);
    const Snapshot at{scene.world.start, scene.world.velocity, 0, 0};
    for (const Metric& metric : scene.metrics)
        if (metric.high == 0) CHECK(metric.measure(at) == 0);
}

// The first quarter of a second: both layers fall on each other and on her hips.
TEST_CASE("dress: while it falls nothing passes through anything", "[dress][figures][FX10]") {
    const Scene scene = build(findScene("dress"), Quality::draft);
    const std::vector<double> most = worst(scene, 0, 6);
    for (std::size_t i = 0; i < most.size(); ++i) CHECK(most[i] <= scene.metrics[i].high);
}

// A sixth of the substeps. Where contacts look at where these end alone, layers that meet have gone
// through each other, and stay so for the rest of the dance.
TEST_CASE("dress: paths hold in few substeps, and where they end is not enough",
          "[dress][long][FX2]") {
    const auto failed = [](const std::string& detection) {
        const SceneEntry& entry = findScene("dress");
        Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
        knobs.texts["detection"] = detection;
        const Scene scene = entry.build(knobs);
        const std::vector<double> most = worst(scene, 0, 8, 4);
        double sum = 0;
        for (std::size_t i = 0; i < most.size(); ++i)
            if (scene.metrics[i].high == 0) sum += most[i];
        note(detection + ": crossings, failures and vertices inside", sum);
        return sum;
    };
    CHECK(failed("path") == 0);
    CHECK(failed("end") > 100);
}

TEST_CASE("dress: it keeps its bands through the dance", "[dress][long][FX2]") {
    const Scene scene = build(findScene("dress"), Quality::draft);
    const int lead = static_cast<int>(scene.lead * 24);
    const std::vector<double> most = worst(scene, lead, static_cast<int>(scene.seconds * 24));
    for (std::size_t i = 0; i < most.size(); ++i) {
        note(scene.metrics[i].name + " at most", most[i]);
        CHECK(most[i] <= scene.metrics[i].high);
    }
}

TEST_CASE("dress: a character of the user's own wears it", "[dress]") {
    const test::ScratchFolder folder;
    const Ballerina dancer;
    const auto write = [&](const std::string& name, double t) {
        std::ofstream out(folder / name);
        out.precision(12);
        for (const Vec<double>& x : dancer.positions(t))
            out << "v " << x.x << ' ' << x.y << ' ' << x.z << '\n';
        for (const auto& [a, b, c] : dancer.triangles())
            out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    };
    for (int frame = 0; frame < 3; ++frame)
        write("body" + std::to_string(frame) + ".obj", frame / 12.0);
    write("turning0.obj", 4.3);  // on one leg
    const SceneEntry& entry = findScene("dress");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    const Scene own = entry.build(knobs);
    knobs.texts["body"] = (folder / "body*.obj").string();
    knobs.numbers["waist"] = dancer.waist(0).origin.y;
    knobs.numbers["rate"] = 12;
    const Scene scene = entry.build(knobs);
    CHECK(scene.seconds == 2 / 12.0);
    REQUIRE(scene.world.start.size() == own.world.start.size());
    double apart = 0;
    for (std::size_t i = 0; i < own.world.start.size(); ++i)
        apart = std::max(apart, length(scene.world.start[i] - own.world.start[i]));
    CHECK(report("from the dancer's own, m", apart, 1e-9));
    const Snapshot at{scene.world.start, scene.world.velocity, 0, 0};
    for (const Metric& metric : scene.metrics)
        if (metric.high == 0) CHECK(metric.measure(at) == 0);

    Knobs turning = knobs;
    turning.texts["body"] = (folder / "turning*.obj").string();
    REQUIRE_THROWS_WITH(entry.build(turning), Catch::Matchers::StartsWith("body: it must stand"));
    knobs.numbers["waist"] = 2;  // over her head
    REQUIRE_THROWS_WITH(entry.build(knobs), Catch::Matchers::StartsWith("waist: it must be on"));
}
