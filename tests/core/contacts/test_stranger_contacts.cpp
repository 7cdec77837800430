// What no contact can hold: rounds that would go on until everything has gone back are bounded, and
// whatever was not held is counted.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/solids/collider.h>

using namespace plait;
using namespace plait::test;

namespace {

// Sheets of one square that fly at a pinned one, each past five of those before it in a substep.
World flying(int sheets) {
    constexpr double apart = 0.004;  // m
    World world;
    std::vector<Surface> surfaces;
    for (int n = 0; n <= sheets; ++n) {
        const Points velocity(4, {0, 0, n == 0 ? 0 : -24 * 5 * apart});
        const Range sheet =
            world.add(grid({.width = 0.1, .height = 0.1}, {.origin = {0, 0, n * apart}}),
                      {.density = 1, .velocity = velocity});
        if (n == 0) world.pin(pointStencils(sheet));
        surfaces.push_back({.vertices = sheet, .thickness = 0.001});
    }
    meet(world, surfaces, {.order = 1});
    return world;
}

// A long sleeve of two layers on a pinned rod that is elsewhere, `jump` (m) away, from the second
// frame on.
World jumping(double jump) {
    World world;
    const Range rod = world.add(tube({.segments = 6, .rings = 2, .radius = 0.1, .height = 1}));
    std::vector<Surface> surfaces{{.vertices = rod, .thickness = 0.002, .self = Self::none}};
    std::vector<int> held = pointStencils(rod);
    for (const double radius : {0.107, 0.114}) {
        const Range layer =
            world.add(tube({.segments = 12, .rings = 24, .radius = radius, .height = 0.8},
                           {.origin = {0, 0.1, 0}}));
        for (int v = layer.last - 12; v < layer.last; ++v) held.push_back(v);
        world.constrain(restRows<Stretch>(edgeStencils(world.complex, layer), world.rest),
                        {.name = "links" + std::to_string(surfaces.size())});
        surfaces.push_back({.vertices = layer, .thickness = 0.002});
    }
    world.pin(held, [jump](const Vec<double>& x, double t) {
        return x + Vec<double>{jump * std::clamp(24 * t - 1, 0.0, 1.0), 0, 0};
    });
    world.act<Gravity>(GravityOptions{});
    meet(world, surfaces, {.order = 1});
    return world;
}

// Of three frames.
long failuresOf(const World& world) {
    Solver<double> solver(world, meeting(10));
    long failures = 0;
    for (int frame = 0; frame < 3; ++frame) {
        solver.frame();
        failures += solver.failures();
    }
    return failures;
}

}  // namespace

// Each that goes back is in the way of the next ones.
TEST_CASE("contacts: what goes back round after round is given up, and counted",
          "[contacts][strangers]") {
    for (const int sheets : {20, 400}) {
        const World world = flying(sheets);
        Solver<float> solver(world, meeting(1, 1));
        solver.frame();
        const bool few = sheets < 100;
        CHECK((countsOf(solver, world).givenUp == 0) == few);
        CHECK((solver.failures() == 0) == few);
    }
}

TEST_CASE("contacts: what jumps away is given up, and counted", "[contacts][strangers]") {
    for (const double jump : {0.02, 2.0}) {
        const World world = jumping(jump);
        Solver<float> solver(world, meeting(4, 4));
        solver.frame();
        CHECK(solver.failures() == 0);
        for (int frame = 2; frame <= 3; ++frame) solver.frame();
        const bool walks = jump < 0.1;
        CHECK((countsOf(solver, world).failures() == 0) == walks);
        CHECK((countsOf(solver, world).givenUp == 0) == walks);
        note("searches", static_cast<double>(countsOf(solver, world).searches));
    }
}

// Balls are points and never cross: three that are pressed into each other end concentric, and that
// is a failure.
TEST_CASE("contacts: what is pressed into each other is counted", "[contacts][strangers]") {
    for (const double left : {0.0, 0.95}) {  // of the way to the pinned one
        World world;
        const Range ball = addPoint(world, {0, 0, 0}), wall = addPoint(world, {0.1, 0, 0}),
                    press = addPoint(world, {-0.1, 0, 0});
        world.pin({wall.first});
        world.pin({press.first}, [left](const Vec<double>& x, double t) {
            return x + std::min(12 * t, 1.0) * left * Vec<double>{0.2, 0, 0};
        });
        meet(world, {{.vertices = ball, .thickness = 0.05},
                     {.vertices = wall, .thickness = 0.05},
                     {.vertices = press, .thickness = 0.05}});
        const long failures = failuresOf(world);
        INFO(left << " of the way, " << failures << " failures");
        CHECK((failures > 0) == (left > 0));
    }
}

TEST_CASE("colliders: a ball that is pressed into a solid is counted", "[colliders][strangers]") {
    for (const double left : {0.12, 0.055}) {  // m, between a floor and what comes down on it
        World world;
        const Range ball = addPoint(world, {0, 0.05, 0});
        Collider press{.solid = Solid::box(1, 0.2, 1)};
        press.motion = [left](double t) {
            return Frame{.origin = {0, 0.1 + left + 0.1 * (1 - std::min(12 * t, 1.0)), 0}};
        };
        collide(world, {{.solid = Solid::plane()}, press}, {{.vertices = ball, .thickness = 0.05}});
        const long failures = failuresOf(world);
        INFO(left << " m, " << failures << " failures");
        CHECK((failures > 0) == (left < 0.1));
    }
}

TEST_CASE("colliders: what bounces on is counted", "[colliders][strangers]") {
    for (const double times : {3.0, 40.0}) {
        World world;
        const Range ball = addPoint(world, {0, 0.05, 0}, 1, {0, -24 * 0.098 * times, 0});
        std::vector<Collider> walls{{.solid = Solid::plane(), .restitution = 1},
                                    {.solid = Solid::plane(),
                                     .frame = {.origin = {0, 0.1, 0}, .up = {0, -1, 0}},
                                     .restitution = 1}};
        collide(world, walls, {{.vertices = ball, .thickness = 0.001, .restitution = 1}});
        Solver<double> solver(world, meeting(1));
        solver.frame();
        CHECK((solver.failures() > 0) == (times > 3));
    }
}

// A heavy ball drives a light one against a wall: they meet some pi sqrt(mass) times, of which 16
// and 4 a pair are followed.
TEST_CASE("contacts: what bounces on is counted", "[contacts][strangers]") {
    for (const double mass : {1.0, 10000.0}) {
        World world;
        const Range wall = addPoint(world, {0, 0, 0}),
                    light = addPoint(world, {0.05, 0, 0}, 1, {-24 * 0.1, 0, 0}),
                    heavy = addPoint(world, {0.1, 0, 0}, mass, {-24 * 0.5, 0, 0});
        world.pin({wall.first});
        std::vector<Surface> surfaces;
        for (const Range ball : {wall, light, heavy})
            surfaces.push_back({.vertices = ball, .thickness = 0.001, .restitution = 1});
        meet(world, surfaces);
        Solver<double> solver(world, meeting(1));
        solver.frame();
        note("bounces", static_cast<double>(countsOf(solver, world).bounces));
        CHECK((countsOf(solver, world).cut > 0) == (mass > 1));
        CHECK((solver.failures() > 0) == (mass > 1));
    }
}
