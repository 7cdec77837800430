// What pinned matter gives, and where it goes: no energy is in no line.
#include "ledger.h"
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>
#include <plait/numbers/elementary.h>

#include <cmath>
#include <numeric>

using namespace plait;
using namespace plait::test;

namespace {

constexpr Vec<double> g{0, -9.81, 0};

// A lift that also goes aside, from rest to rest in 1 s, and then stays.
Vec<double> lifted(const Vec<double>& start, double t) {
    const double s = std::min(t, 1.0);
    return start + (0.5 - 0.5 * cosine(pi * s)) * Vec<double>{0.3, 0.5, 0};
}

// All that is pinned goes the same way, so what it gives follows from the momentum of what hangs on
// it or stands on it, without a look at any constraint.
void checkLift(World& world) {
    world.act<Gravity>(GravityOptions{.acceleration = g});
    Ledger ledger(world, g);
    constexpr int rate = 1000;
    SolverOptions options = stepping(rate);
    options.schedule.iterations = 20;
    options.schedule.collisionPasses = 20;
    options.damping = 0.02;
    Solver<double> solver(world, options);
    std::vector<double> free = world.mass;  // kg, 0 where pinned
    for (std::size_t v = 0; v < free.size(); ++v)
        if (world.pinned[v]) free[v] = 0;
    const double mass = std::accumulate(free.begin(), free.end(), 0.0);
    double given = 0;
    for (int step = 0; step < 1.5 * rate; ++step) {
        const Vec<double> before = momentum(free, solver.velocities());
        solver.frame();
        // Damping takes its part of the momentum after everything else.
        const double kept = std::pow(1 - options.damping, 24.0 / rate);
        const Vec<double> taken =
            (1 / kept) * momentum(free, solver.velocities()) - before - (mass / rate) * g;
        given += dot(taken, lifted({}, (step + 1.0) / rate) - lifted({}, step * 1.0 / rate)) * rate;
    }
    note("given, J", ledger.given());
    note("lost in sets, J", ledger.lost());
    note("to damping, J", ledger.damping());
    CHECK(ledger.given() > 0.4 * mass * 9.81);
    CHECK(report("given, against momentum", std::fabs(ledger.given() / given - 1), 1e-5));
    CHECK(
        report("in no line, of what is given", std::fabs(ledger.missing() / ledger.given()), 1e-5));
}

Surface rough(Range vertices) {
    return {
        .vertices = vertices, .thickness = 0.005, .staticFriction = 0.2, .dynamicFriction = 0.2};
}

}  // namespace

TEST_CASE("ledger: a lift gives its way times the momentum of a cloth that hangs on it",
          "[accounts]") {
    World world;
    const Range cloth = world.add(grid({.columns = 6, .rows = 8, .width = 0.6, .height = 0.8}));
    world.pin(world.select(cloth, [](const Vec<double>& x) { return x.y > 0.79; }), lifted);
    world.constrain(linksOf(world), {.name = "links"});
    meet(world, {{.vertices = cloth, .thickness = 1e-4}});  // for the ledger to be closed by
    checkLift(world);
}

TEST_CASE("ledger: a lift gives its way times the momentum of a cube that stands on it",
          "[accounts]") {
    World world;
    const Range floor = addSlope(world, 0, 4);
    world.pin({0, 1, 2, 3}, lifted);
    const Range cube = addCube(world, 0, 0.011);
    meet(world, {rough(floor), rough(cube)});
    checkLift(world);
}

// Through the whole dance, once the skirt has settled on her. That no set gives energy, to a
// hundredth of hers: those that bend and shear may give back what they held.
TEST_CASE("ledger: what the dancer gives is accounted for", "[accounts][dress][long]") {
    Scene scene = build(findScene("dress"), Quality::draft);
    Ledger ledger(scene.world, g);
    Solver<double> solver(scene.world, scene.options);
    for (int frame = 0; frame < static_cast<int>(scene.lead * 24); ++frame) solver.frame();
    ledger.clear();
    for (int frame = 0; frame < static_cast<int>(scene.seconds * 24); ++frame) solver.frame();
    note("she gives, J", ledger.given());
    note("to the air, J", ledger.air());
    note("to damping, J", ledger.damping());
    for (const Ledger::Line& line : ledger.lines()) {
        note("to " + line.set + ", J", line.lost);
        CHECK(line.lost > -0.01 * ledger.given());
        CHECK(report("impulses of " + line.set + " that nothing answers, of all",
                     divide(length(line.excess), line.felt + 1e-6), 1e-6));
    }
    note("gained, J", ledger.gained());
    CHECK(ledger.given() > 1);
    CHECK(ledger.air() > 0);
    CHECK(ledger.damping() > 0);
    CHECK(report("in no line, of what she gives", std::fabs(ledger.missing() / ledger.given()),
                 1e-9));
}
