// Rods with a material frame, against closed forms of their wire.
#include "tests/catch.h"
#include "tests/core/rods/rod_worlds.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

// A slinky's wire, few turns of it in weak gravity: extension m g / 2 k with k = G J / 2 pi n R^3.
TEST_CASE("frames: a coil hangs as far as its wire says", "[rods][DC1][DC3]") {
    constexpr int turns = 10, links = 24;
    constexpr double radius = 0.034, g = 0.5;
    World world;
    const Shape coil =
        helix({.links = turns * links, .radius = radius, .turns = turns, .pitch = 0.62e-3});
    std::vector<Vec<double>> outward;
    for (int e = 0; e < turns * links; ++e) {
        const Vec<double> mid = 0.5 * (coil.positions[e] + coil.positions[e + 1]);
        outward.push_back({mid.x, 0, mid.z});
    }
    const Wire wire{.poisson = 200.0 / 158 - 1, .along = 2.5e-3, .across = 0.62e-3};
    const Rod rod = addRod(world, coil, {.wire = wire, .toward = outward}, {.name = "coil"});
    // The last turn but none is held, and the coil hangs from it.
    std::vector<int> held;
    for (int i = 0; i <= links; ++i) held.push_back(rod.points.last - 1 - i);
    for (int i = 0; i < links; ++i) held.push_back(rod.directors.last - 1 - i);
    world.pin(held);
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    double mass = 0;
    for (const double m : world.mass) mass += m;
    const double free = turns - 1,
                 stiffness = wire.twisting() / (2 * pi * free * radius * radius * radius),
                 expected = mass * free / turns * g / 2 / stiffness;
    const auto lowest = [&](const std::vector<Vec<double>>& x) {
        double sum = 0;
        for (int i = 0; i < links; ++i) sum += x[rod.points.first + i].y;
        return sum / links;
    };
    Solver<float> solver(world, stepping(24, 4));
    const double before = lowest(solver.positions());
    for (int frame = 0; frame < 24 * 6; ++frame) solver.frame();
    const double extension = before - lowest(solver.positions());
    note("extension against that of the wire", extension / expected);
    CHECK(report("extension off", std::fabs(extension / expected - 1), 0.03));
    CHECK(report("speed, m/s", fastest(solver), 1e-5));
}

// A straight rod whose far end is turned about its axis by 1 rad is twisted evenly.
TEST_CASE("frames: twist spreads evenly along a straight rod", "[rods][DC3]") {
    constexpr int links = 32;
    World world;
    const Rod rod = addRod(world, chain({.links = links}),
                           {.wire = {.along = 5e-3}, .toward = {{0, 1, 0}}}, {.name = "rod"});
    clampStart(world, rod);
    const int last = rod.directors.last - 1;
    const Vec<double> middle{1 - 0.5 / links, 0, 0};
    world.pin({rod.points.last - 1, rod.points.last - 2});
    world.pin({last}, [middle](const Vec<double>& x, double t) {
        const double angle = std::min(t, 1.0), arm = x.y;
        return middle + Vec<double>{0, arm * std::cos(angle), arm * std::sin(angle)};
    });
    Solver<float> solver(world, stepping(20, 4));
    for (int frame = 0; frame < 72; ++frame) solver.frame();
    const auto x = solver.positions();
    double worst = 0, aside = 0;
    for (int e = 0; e < links; ++e) {
        const Vec<double> d = x[rod.directors.first + e];
        worst =
            std::max(worst, std::fabs(std::atan2(d.z, d.y) - static_cast<double>(e) / (links - 1)));
    }
    for (int v = rod.points.first; v < rod.points.last; ++v)
        aside = std::max(aside, std::hypot(x[v].y, x[v].z));
    CHECK(report("angle of the frames, rad", worst, 1e-5));
    CHECK(report("off the axis, m", aside, 1e-6));
}

// Half of a weightless rod is bent by the angle between its clamps: an arc, of either stiffness.
TEST_CASE("frames: between clamps that turn a rod is an arc", "[rods]") {
    for (const Vec<double> up : {Vec<double>{0, 1, 0}, Vec<double>{0, 0, 1}}) {
        constexpr int links = 30;
        constexpr double angle = 1.5, l = 1.0 / links;
        World world;
        const Rod rod =
            addRod(world, chain({.links = links}),
                   {.wire = {.along = 8e-3, .across = 2e-3}, .toward = {up}}, {.name = "rod"});
        clampStart(world, rod);
        // Where the last link lies on the arc, in the plane x y.
        Vec<double> at{};
        for (int e = 0; e < links - 1; ++e) {
            const double turn = angle * e / (links - 1);
            at += l * Vec<double>{std::cos(turn), std::sin(turn), 0};
        }
        const Vec<double> along{std::cos(angle), std::sin(angle), 0},
            side{-std::sin(angle), std::cos(angle), 0};
        const std::vector<int> ends{rod.points.last - 2, rod.points.last - 1,
                                    rod.directors.last - 1};
        const Vec<double> arm =
            (l / 2) * (up.y > 0 ? side : Vec<double>{0, 0, 1}) + (l / 2) * along;
        world.pin(ends, Animation([=](double t, std::span<Vec<double>> x) {
                      if (t == 0) return;
                      const double part = std::min(t, 1.0);
                      const Vec<double> to[3]{at, at + l * along, at + arm};
                      for (int i = 0; i < 3; ++i) x[i] = x[i] + part * (to[i] - x[i]);
                  }));
        Solver<float> solver(world, stepping(40, 4));
        for (int frame = 0; frame < 96; ++frame) solver.frame();
        const auto x = solver.positions();
        double worst = 0;
        for (int e = 1; e < links; ++e) {
            const Vec<double> edge = x[e + 1] - x[e];
            worst =
                std::max(worst, std::fabs(std::atan2(edge.y, edge.x) - angle * e / (links - 1)));
        }
        CHECK(report("angle of the links, rad", worst, 1e-4));
        CHECK(report("speed, m/s", fastest(solver), 1e-4));
    }
}

TEST_CASE("frames: what cannot be a rod is refused by name", "[rods]") {
    const auto add = [](const Shape& curve, const RodOptions& options) {
        World world;
        addRod(world, curve, options, {.name = "wire"});
    };
    const Shape line = chain({.links = 4});
    CHECK_NOTHROW(add(line, {}));
    CHECK_THROWS_WITH(add(line, {.wire = {.youngs = 0}}), Catch::Contains("wire: Young's modulus"));
    CHECK_THROWS_WITH(add(line, {.wire = {.poisson = 0.6}}), Catch::Contains("Poisson"));
    CHECK_THROWS_WITH(add(line, {.toward = {{1, 0, 0}}}), Catch::Contains("points along it"));
    CHECK_THROWS_WITH(add(line, {.arm = 1e-5}), Catch::Contains("too short"));
    CHECK_THROWS_WITH(add(grid({}), {}), Catch::Contains("a curve"));
}
