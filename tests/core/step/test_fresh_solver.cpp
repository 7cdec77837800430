// Nothing outlives a substep but State: each frame on a solver that has seen no other, restored
// from the last state, must leave the bits of the run as a whole. Whatever a set, a force or a
// method keeps in itself shows here.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/small_scenes.h"

#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

template <class Real>
void checkFresh(const Scene& scene, int frames) {
    const auto world = std::make_shared<const World>(scene.world);
    Solver<Real> whole(world, scene.options);
    for (int frame = 0; frame < frames; ++frame) {
        Solver<Real> fresh(world, scene.options);
        fresh.restore(whole.state(), whole.evaluations());
        fresh.frame();
        whole.frame();
        INFO("frame " << frame + 1);
        REQUIRE(fresh.hash() == whole.hash());
        REQUIRE(fresh.evaluations() == whole.evaluations());
    }
}

}  // namespace

TEST_CASE("fresh solver: each frame of every scene leaves the same bits",
          "[fresh][determinism][figures]") {
    for (const SceneEntry& entry : scenes()) {
        INFO(entry.name);
        checkFresh<float>(build(entry, Quality::draft), 2);
    }
}

TEST_CASE("fresh solver: each frame of every scene, a second long, in both precisions",
          "[fresh][determinism][long]") {
    for (const SceneEntry& entry : scenes()) {
        INFO(entry.name);
        const Scene scene = build(entry, Quality::draft);
        checkFresh<float>(scene, 24);
        checkFresh<double>(scene, 24);
    }
}

TEST_CASE("fresh solver: bdf2, a limit of acceleration, the method global", "[fresh]") {
    const SceneEntry& entry = findScene("hanging-sheet");
    Scene scene = build(entry, Quality::draft);
    scene.options.integrator = Integrator::bdf2;
    checkFresh<float>(scene, 6);
    scene.options.integrator = Integrator::first;
    scene.options.limitAcceleration = true;
    scene.options.maxAcceleration = 12;
    checkFresh<float>(scene, 6);

    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.texts["solve"] = "sweeps";
    Scene swept = entry.build(knobs);
    swept.options.method = Method::global;
    swept.options.integrator = Integrator::bdf2;
    swept.options.schedule.substeps = 4;
    checkFresh<float>(swept, 6);
}
