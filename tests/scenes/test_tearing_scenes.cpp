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
    const Scene scene = draftOf("torn-vest");
    Solver<float> solver(scene.world, scene.options);
    std::ptrdiff_t before = 0;
    for (int frame = 1; frame <= 64; ++frame) {
        solver.frame();
        if (frame == 9) CHECK(tornOf(solver) == 0);
        if (frame == 36) before = tornOf(solver);
    }
    const std::ptrdiff_t all = tornOf(solver);
    note("edges torn half way", double(before));
    note("edges torn by the whole pull", double(all));
    CHECK(before > 4);
    CHECK(all > before + 4);
    for (int frame = 65; frame <= 84; ++frame) solver.frame();
    CHECK(tornOf(solver) == all);
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
