// Small scenes of curves, against closed forms and what is conserved.
#include "bands.h"

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

struct Tie {
    int hook, knot;
};

// A hook is the one thing that is pinned, half of its tie from its knot.
std::vector<Tie> tiesOf(const World& world, double tie) {
    std::vector<Tie> ties;
    const int net = world.complex.count(1) > 0 ? world.complex.edge(0)[0] : 0;
    for (int hook = 0; hook < static_cast<int>(world.mass.size()); ++hook) {
        if (!world.pinned[hook]) continue;
        for (int v = net; v < hook; ++v)
            if (!world.pinned[v] &&
                std::fabs(length(world.start[v] - world.start[hook]) / (0.5 * tie) - 1) < 1e-9) {
                ties.push_back({hook, v});
                break;
            }
    }
    return ties;
}

struct Shot {
    double worst = 0;  // change of momentum, of what the ball had
    double kept = 1;   // by the ball, when the first tie is drawn out
    double seconds = 0;
};

template <class Real>
Shot shoot() {
    constexpr double tie = 0.5, speed = 18;
    const Scene scene = draftOf("goal", {{"gravity", 0.0}, {"slack", tie}, {"speed", speed}});
    const World& world = scene.world;
    const std::vector<Tie> ties = tiesOf(world, tie);
    CHECK(ties.size() > 50);
    std::vector<double> mass = world.mass;
    for (std::size_t v = 0; v < mass.size(); ++v)
        if (world.pinned[v]) mass[v] = 0;
    const Range ball = scene.view.looks[1].object;
    const auto momentum = [&](const std::vector<Vec<double>>& v, Range range) {
        Vec<double> sum{};
        for (int i = range.first; i < range.last; ++i) sum += mass[i] * v[i];
        return sum;
    };
    const Range all{0, static_cast<int>(mass.size())};
    const Vec<double> before = momentum(world.velocity, all);
    Solver<Real> solver(world, scene.options);
    Shot shot;
    for (int frame = 0; frame < 120; ++frame) {
        solver.frame();
        const auto x = solver.positions(), v = solver.velocities();
        for (const auto& [hook, knot] : ties)
            if (length(x[hook] - x[knot]) > 0.97 * tie) return shot;
        shot.worst = std::max(shot.worst, length(momentum(v, all) - before) / length(before));
        shot.kept = momentum(v, ball).z / momentum(world.velocity, ball).z;
        shot.seconds = solver.time();
    }
    return shot;
}

}  // namespace

TEST_CASE("tendrils: limp cords hang as catenaries, curled ones as their wire says",
          "[scenes][rods][figures][FX23][SH8]") {
    const Scene scene = draftOf("tendrils");
    holdToBands(scene, 7 * 24);
}

namespace {

Scene heavyRodOf(const char* solve, double links) {
    const SceneEntry& entry = findScene("heavy-rod");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.texts["solve"] = solve;
    knobs.numbers["links"] = links;
    return entry.build(knobs);
}

}  // namespace

TEST_CASE("heavy rod: each joint bears what lies beyond it; swept, the more the finer it is",
          "[scenes][rods][SH8][DC9]") {
    for (const char* solve : {"points", "frames"})
        for (const double links : {8.0, 64.0}) holdToBands(heavyRodOf(solve, links), 480);
    double before = 0;
    for (const double links : {4.0, 8.0, 16.0, 32.0}) {
        const Scene scene = heavyRodOf("sweeps", links);
        Solver<float> solver(scene.world, scene.options);
        for (int frame = 0; frame < 480; ++frame) solver.frame();
        const auto x = solver.positions(), v = solver.velocities();
        const double off = scene.metrics[0].measure({x, v, solver.time(), 480});
        note("swept, " + std::to_string(std::lround(links)) + " links: moment off, %", off);
        CHECK(off > before);
        before = off;
    }
    CHECK(before > 10);
}

// Fewer locks, so that it is soon done.
TEST_CASE("tress: waves are kept in gusts, and nothing goes through the head",
          "[scenes][rods][contacts][FX30]") {
    holdToBands(draftOf("tress", {{"locks", 24}}), 60);
}

TEST_CASE("goal: ball and net keep their momentum until the posts act",
          "[scenes][rods][contacts][figures][AR1][FX26]") {
    const Shot shot = shoot<double>();
    note("until, s", shot.seconds);
    note("kept by the ball", shot.kept);
    CHECK(shot.kept < 0.9);
    CHECK(report("change of momentum, double", shot.worst, 1e-8));
}

TEST_CASE("goal: in float too ball and net keep their momentum",
          "[scenes][rods][contacts][long][AR1][FX26]") {
    const Shot shot = shoot<float>();
    CHECK(shot.kept < 0.9);
    CHECK(report("change of momentum, float", shot.worst, 1e-6));
}

TEST_CASE("goal: the net stops the ball", "[scenes][rods][contacts][long][FX26]") {
    const Scene scene = draftOf("goal");
    const Range ball = scene.view.looks[1].object;
    const auto x = holdToBands(scene, 120);
    // It came from in front, and lies before what the net can reach behind the goal.
    CHECK(x[ball.first].z > -3);
}

TEST_CASE("sheet slinky: shear of its walls holds it, and nothing else",
          "[scenes][rods][contacts][long][DC2][FX4]") {
    const Scene scene = draftOf("sheet-slinky");
    const auto x = holdToBands(scene, 96);
    const Range limp = scene.view.looks[1].object;
    double height = 0;
    for (int v = limp.first; v < limp.first + 72; ++v) height = std::max(height, x[v].y);
    CHECK(report("lowest turn of what has no shear, above the floor, m", height, 0.05));
}
