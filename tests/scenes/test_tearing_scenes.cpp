// Scenes that tear: how far, from when on, and no further.
#include "bands.h"
#include "tests/report.h"

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

std::ptrdiff_t tornOf(const Solver<float>& solver) {
    return std::ranges::count_if(solver.state().cuts,
                                 [](std::int32_t entry) { return entry >= 0; });
}

}  // namespace

// The hands pull from 0.4 to 2.6 s and let go at 3.1 s.
TEST_CASE("torn vest: the tear grows with the pull and stops when it is let go",
          "[tearing][scenes][FX9][BR10]") {
    const Scene near = draftOf("torn-vest", {{"pull", 0.065}}), far = draftOf("torn-vest");
    Solver<float> less(near.world, near.options), more(far.world, far.options);
    std::ptrdiff_t before = 0;
    for (int frame = 1; frame <= 64; ++frame) {
        less.frame(), more.frame();
        if (frame == 9) CHECK(tornOf(more) == 0);
        if (frame == 40) before = tornOf(more);
    }
    note("edges torn by hands that go 6.5 cm", double(tornOf(less)));
    note("by hands that go 13 cm", double(tornOf(more)));
    CHECK(before > 4);
    CHECK(tornOf(more) > before);
    CHECK(tornOf(more) >= 2 * tornOf(less));
    const std::ptrdiff_t all = tornOf(more);
    for (int frame = 65; frame <= 96; ++frame) more.frame();
    CHECK(tornOf(more) == all);
}

// Its needle is there at 0.8 ms, 9.6 frames of 1/12 ms.
TEST_CASE("burst: nothing tears before the needle, then the gas leaves", "[tearing][scenes][gas]") {
    const Scene scene = draftOf("burst");
    Solver<float> solver(scene.world, scene.options);
    const auto left = [&] { return double(solver.state().kept[0].numbers[0]); };
    for (int frame = 1; frame <= 9; ++frame) solver.frame();
    CHECK(solver.state().cuts.empty());
    const double full = left();
    for (int frame = 10; frame <= 36; ++frame) solver.frame();
    CHECK(tornOf(solver) > 10);
    CHECK(left() < full);
    double fastest = 0;
    for (const Vec<double>& v : solver.velocities()) fastest = std::max(fastest, length(v));
    // What is stretched 3.2 times snaps back with that, at the most by waves of its own.
    note("fastest, m/s", fastest);
    CHECK(fastest < 200);
}
