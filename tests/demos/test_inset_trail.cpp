// The inset of a view in the pictures of a run.
#include "demos/output/inset_trail.h"
#include "demos/output/pictures.h"
#include "demos/tools/errors.h"
#include "program.h"
#include "tests/catch.h"

using namespace plait;
using namespace plait::test;

namespace {

constexpr int frames = 12;

Run runWithInset() {
    Run run = makeRun({{"scene", "pendulum"}, {"quality", "draft"}, {"seconds", "0.5"}});
    run.scene.metrics = {{.name = "a", .unit = "m", .measure = {}},
                         {.name = "b", .unit = "", .measure = {}}};
    run.scene.view.inset = Inset{.x = "b", .y = "a", .curve = {{{0, 0}, {12, 1}}}};
    return run;
}

RunFrame frameOf(const Run& run, int number) {
    return {.number = number,
            .time = number / run.frameRate(),
            .metrics = {number % 2 / 2.0, double(number)},
            .positions = run.scene.world.rest,
            .velocities = {},
            .touched = {}};
}

// Films the frames from the start to `last` of those asked for.
void film(const Run& run, const std::filesystem::path& path, int first, int last, bool keep) {
    const RunFolder folder(path, settingsOf(run), {.resume = true});
    PictureOptions options;
    options.width = 320;
    options.height = 180;
    options.first = first;
    options.last = last;
    options.caption = false;
    options.keep = keep;
    Pictures pictures(run, folder, options);
    for (int i = 0; i <= last; ++i) pictures.add(frameOf(run, i));
    while (!pictures.finish(0.1)) continue;
}

}  // namespace

TEST_CASE("the inset follows two metrics, and knows nothing of later frames", "[program][inset]") {
    const Run run = runWithInset();
    InsetTrail trail(run);
    for (int i = 0; i < frames; ++i) trail.add(frameOf(run, i));
    const InsetChart inset = trail.at(5).value_or(InsetChart{});
    CHECK(inset.x == "b");
    CHECK(inset.y == "a [m]");
    REQUIRE(inset.curve.size() == 2);
    CHECK(inset.curve[1].x == 12);
    REQUIRE(inset.trail.size() == 6);
    CHECK(inset.trail.back().x == 5);
    CHECK(inset.trail.back().y == 0.5);

    Run other = runWithInset();
    other.scene.view.inset = Inset{.x = "b", .y = "c", .curve = {{{0, 0}, {12, 1}}}};
    CHECK_THROWS_AS(InsetTrail(other), SceneError);
    other.scene.view.inset = Inset{.x = "a", .y = "b", .curve = {{{0, 0}}}};
    CHECK_THROWS_AS(InsetTrail(other), SceneError);
    other.scene.view.inset.reset();
    CHECK_FALSE(InsetTrail(other).at(0).has_value());
}

TEST_CASE("the inset's trail is the same in a film that is cut, gone on with or begun later",
          "[program][inset]") {
    const TemporaryFolder folder;
    const auto picture = [&](const std::string& name, int i) {
        return contents(folder / name / "frames" / numbered(i, ".png"));
    };
    const Run run = runWithInset();
    film(run, folder / "whole", 1, frames, false);
    const bool moves = picture("whole", 6) != picture("whole", 7);
    CHECK(moves);

    film(run, folder / "late", 5, frames, false);
    const bool late = picture("late", 6) == picture("whole", 6);
    CHECK(late);

    film(run, folder / "resumed", 1, frames, false);
    std::filesystem::remove(folder / "resumed" / "frames" / numbered(7, ".png"));
    film(run, folder / "resumed", 1, frames, true);
    const bool resumed = picture("resumed", 7) == picture("whole", 7);
    CHECK(resumed);

    // Frame 6 is shown again after frame 12 was.
    Run cut = runWithInset();
    cut.scene.view.takes = {{.from = 8 / 24.0, .to = 12 / 24.0},
                            {.from = 5 / 24.0, .to = 8 / 24.0}};
    film(cut, folder / "cut", 1, frames, false);
    const bool last = picture("cut", 4) == picture("whole", 12),
               again = picture("cut", 5) == picture("whole", 6);
    CHECK(last);
    CHECK(again);
}
