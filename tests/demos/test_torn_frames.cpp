// What a run leaves of matter that comes apart.
#include "demos/output/export.h"
#include "demos/output/exposure.h"
#include "demos/output/overlays.h"
#include "demos/runs/simulation.h"
#include "program.h"
#include "tests/catch.h"
#include "tests/torn_sheet.h"

#include <plait/files/mesh_file.h>
#include <plait/stencils.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

// Cuts a world's edges, as a force that tears it would, once `after` (s) is over.
template <class Real>
class Knife : public Force<Real> {
public:
    Knife(std::vector<std::int32_t> cuts, double after) : cuts_(std::move(cuts)), after_(after) {}
    std::string name() const override { return "knife"; }
    void apply(State<Real>&, double, double, Workers&) override {}
    void settle(State<Real>& state, Drawer<Real>&, double t, double) override {
        if (t > after_) state.cuts = cuts_;
    }

private:
    std::vector<std::int32_t> cuts_;
    double after_;
};

// A run of the sheet, in place of a scene's world.
Run runOf(const TornSheet& sheet) {
    Run run = makeRun({{"scene", "pendulum"}, {"quality", "draft"}});
    run.scene.world = sheet.world;
    run.scene.options = {};
    run.scene.metrics = {{.name = "cuts", .unit = "", .measure = [](const Snapshot& at) {
                              return static_cast<double>(at.cuts.size());
                          }}};
    return run;
}

// Whole and at rest at time 0, then torn, its right half 0.3 m away.
std::array<RunFrame, 2> framesOf(const TornSheet& sheet) {
    std::array<RunFrame, 2> frames;
    const std::size_t n = sheet.world.rest.size();
    for (RunFrame& frame : frames) {
        frame.metrics = {0};
        frame.positions = sheet.world.rest;
        frame.velocities.resize(n, Vec<double>{100, 0, 0});
        frame.touched.resize(n);
        frame.ids.resize(n);
        frame.ages.resize(n);
        std::fill(frame.ids.begin() + 6, frame.ids.end(), -1);
        std::fill(frame.ages.begin() + 6, frame.ages.end(), -1);
    }
    RunFrame& torn = frames[1];
    torn.number = 1;
    torn.time = 1 / 24.0;
    torn.positions = sheet.parted(0.3);
    torn.cuts = sheet.cuts;
    for (const int copy : {6, 7}) torn.ids[copy] = copy, torn.ages[copy] = 0.01;
    return frames;
}

std::vector<std::array<int, 3>> trianglesOf(const SimplicialComplex& complex) {
    std::vector<std::array<int, 3>> all;
    for (int i = 0; i < complex.count(2); ++i) all.push_back(complex.triangle(i));
    return all;
}

}  // namespace

TEMPLATE_TEST_CASE("a frame has what has come apart by then, and a checkpoint goes on with it",
                   "[program][tearing]", float, double) {
    const TornSheet sheet;
    Run run = runOf(sheet);
    if (sizeof(TestType) == sizeof(double)) run.precision = Precision::full;
    World& world = run.scene.world;
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet.cloth), world.rest),
                    {.name = "stretch"});
    world.forces.push_back(
        recipeOf<Force>([cuts = sheet.cuts]<class Real>(
                            const World&, KernelChoice) -> std::unique_ptr<Force<Real>> {
            return std::make_unique<Knife<Real>>(cuts, 1.5 / 24);
        }));
    const auto paused = makeSimulation(run, 1), resumed = makeSimulation(run, 2);
    paused->advance();
    const RunFrame whole = paused->frame();
    CHECK(whole.cuts.empty());
    CHECK(whole.metrics == std::vector<double>{0});
    CHECK(whole.ids == std::vector<std::int32_t>{0, 0, 0, 0, 0, 0, -1, -1, -1});
    paused->advance();
    const RunFrame torn = paused->frame();
    CHECK(torn.cuts == sheet.cuts);
    CHECK(torn.metrics == std::vector<double>{1});
    CHECK(torn.ids == std::vector<std::int32_t>{0, 0, 0, 0, 0, 0, 6, 7, -1});
    CHECK((torn.ages[6] >= 0 && torn.ages[7] >= 0 && torn.ages[8] < 0));

    resumed->restore(paused->checkpoint(), "checkpoint");
    CHECK(resumed->frame().cuts == sheet.cuts);
    CHECK(resumed->hash() == paused->hash());
    for (const auto& simulation : {paused.get(), resumed.get()}) simulation->advance();
    CHECK(resumed->frame().cuts == sheet.cuts);
    CHECK(resumed->hash() == paused->hash());
}

TEST_CASE("an exported mesh is torn as its frame is", "[program][tearing]") {
    const TornSheet sheet;
    const Run run = runOf(sheet);
    const auto frames = framesOf(sheet);
    const TemporaryFolder folder;
    const RunFolder into(folder / "run", settingsOf(run), {});
    for (const RunFrame& frame : frames)
        writeWhole(into.framePath(frame.number), encodeFrame(frame, sizeof(double)));
    for (const std::string format : {"obj", "ply"}) {
        exportRun(into, run, 1, format);
        for (const RunFrame& frame : frames) {
            const Shape mesh = readMesh(into.exportPath(numbered(frame.number, "." + format)));
            CHECK(mesh.positions.size() == frame.positions.size());
            CHECK(trianglesOf(mesh.complex) == trianglesOf(sheet.world.tornBy(frame.cuts).complex));
            CHECK(mesh.complex.boundary(1).size() == (frame.cuts.empty() ? 6u : 8u));
        }
    }
    exportRun(into, run, 1, "pc2");
    CHECK(contents(into.exportPath("points.pc2")).size() == 32 + 2 * 12 * sheet.world.rest.size());
    CHECK(trianglesOf(readMesh(into.exportPath("points.obj")).complex) ==
          trianglesOf(sheet.world.complex));
}

TEST_CASE("overlays are of what is torn", "[program][tearing]") {
    const TornSheet sheet;
    const Run run = runOf(sheet);
    RunFrame frame = framesOf(sheet)[1];
    const Overlays strain(run, "strain"), colours(run, "colours");
    for (const float value : strain.of(frame).values) CHECK(value == Approx(0).margin(1e-6));
    const std::vector<float> colour = colours.of(frame).values;
    CHECK((colour[6] == colour[1] && colour[7] == colour[4]));
    frame.cuts.clear();
    CHECK(std::ranges::max(strain.of(frame).values) > 10);
}

TEST_CASE("in an exposure lips part from where they were one", "[program][tearing]") {
    const TornSheet sheet;
    const auto [before, frame] = framesOf(sheet);
    const Exposure exposure(sheet.world, before, frame, 4);
    REQUIRE(exposure.all.size() == 4);
    for (const Moment& moment : exposure.all) {
        CHECK(std::ranges::equal(moment.cuts, sheet.cuts));
        const double part = moment.time / frame.time;
        CHECK((part > 0.5 && part <= 1));
        for (const int copy : {6, 7})
            CHECK(moment.positions[copy].x == Approx(0.3 * part).margin(1e-12));
        for (const int kept : {1, 4}) CHECK(moment.positions[kept].x == Approx(0).margin(1e-12));
    }
}
