// Presets of fabrics, and what they do to a drape.
#include "scenes/parts/fabrics.h"
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/solver.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

Scene draftOf(const std::string& fabric) {
    const SceneEntry& entry = findScene("swatches");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.texts["fabric"] = fabric;
    return entry.build(knobs);
}

// In %, by fabric, at the end: of 40 passes in 4 substeps, bending in every `interval`-th.
std::vector<double> drapes(Scene scene, int interval) {
    for (World::Set& set : scene.world.sets)
        if (set.options.name.ends_with("bend")) set.options.secondaryInterval = interval;
    scene.options.schedule = {.substeps = 4, .iterations = 10};
    Solver<float> solver(scene.world, scene.options);
    for (int frame = 0; frame < 24 * scene.seconds; ++frame) solver.frame();
    const auto x = solver.positions(), v = solver.velocities();
    const Snapshot at{x, v, solver.time(), 0, 0};
    std::vector<double> found;
    for (std::size_t i = 0; i < fabrics().size(); ++i)
        found.push_back(scene.metrics[i].measure(at));
    return found;
}

}  // namespace

// Bending in one pass of ten is enough for what is limp; what is stiff droops by a third of what
// overhangs more.
TEST_CASE("swatches: fabrics drape in their order, and a secondary pass is for limp ones",
          "[scenes][figures][FX16]") {
    const Scene scene = draftOf("each");
    const std::vector<double> all = drapes(scene, 0), fewer = drapes(scene, 10);
    std::vector<double> off;
    for (std::size_t i = 0; i < all.size(); ++i) {
        note(fabrics()[i].name + ", drape in %", all[i]);
        off.push_back(std::fabs(fewer[i] - all[i]));
        note(fabrics()[i].name + ", off with a secondary pass, points", off.back());
        if (i > 0) CHECK(all[i] > all[i - 1] + 3);
        if (i > 0) CHECK(fabrics()[i].bendingLength() > fabrics()[i - 1].bendingLength());
    }
    CHECK(off[0] < 5);   // silk
    CHECK(off[3] > 20);  // leather
}

// Weight, bending and bias are the preset's, and nothing else is.
TEST_CASE("swatches: a preset changes exactly what it lists", "[scenes][UN6]") {
    const Scene silk = draftOf("silk"), leather = draftOf("leather");
    const World &a = silk.world, &b = leather.world;
    CHECK(a.start == b.start);
    CHECK(a.pinned == b.pinned);
    CHECK(a.sets.size() == b.sets.size());
    CHECK(silk.options.schedule.substeps == leather.options.schedule.substeps);
    CHECK(silk.options.damping == leather.options.damping);
    const double ratio = findFabric("leather").density / findFabric("silk").density;
    for (std::size_t v = 0; v < a.mass.size(); ++v) {
        INFO(v);
        REQUIRE(b.mass[v] == Approx(ratio * a.mass[v]).epsilon(1e-12));
    }
    const Fabric& cotton = findFabric("cotton");
    const Surface own = cotton.surface({3, 9}), plain;
    CHECK(own.vertices.first == 3);
    CHECK(own.thickness == cotton.thickness / 2);
    CHECK(own.staticFriction == cotton.friction);
    CHECK(own.dynamicFriction == cotton.friction);
    CHECK(own.restitution == plain.restitution);
    CHECK(own.stickiness == plain.stickiness);
    CHECK(own.layer == plain.layer);
    CHECK_THROWS_AS(findFabric("velvet"), std::invalid_argument);
}
