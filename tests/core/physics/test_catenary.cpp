// The natural pose of a world, and the one that Bernoulli asked for.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/relax.h>
#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

// Rigid links, 2 m of them between two pins 1 m apart; hung up as a V.
World looseChain(int links, bool direct) {
    World world;
    Shape shape = chain({.links = links, .to = {2, 0, 0}});
    Points start = shape.positions;
    for (Vec<double>& x : start) {
        const double s = x.x / 2;
        x = {s, -std::sqrt(3.0) * std::min(s, 1 - s), 0};
    }
    world.add(shape, {.start = start});
    world.pin({0, links});
    world.act<Gravity>(GravityOptions{});
    world.constrain(linksOf(world), {.name = "links", .direct = direct});
    return world;
}

SolverOptions small(int substeps) { return {.schedule = {.substeps = substeps, .iterations = 1}}; }

double sag(const World& world) { return -world.start[world.start.size() / 2].y; }

// Of N equal links with a mass at each joint (validation A2).
constexpr struct {
    int links;
    double sag;
} catenaries[] = {{10, 0.8043710}, {20, 0.7982731}, {40, 0.7968531}, {80, 0.7965042}};
constexpr double smoothSag = 0.796388356;

}  // namespace

TEST_CASE("a chain hangs in the catenary [A2]", "[statics][catenary][SH8]") {
    double last = 1;
    for (const auto& [links, exact] : catenaries) {
        const std::string name = "catenary of " + std::to_string(links) + " links, sag, ";
        World direct = looseChain(links, true);
        REQUIRE(relax(direct, small(100), {.speed = 1e-7}).frames < 2400);
        REQUIRE(report(name + "direct", std::fabs(sag(direct) / exact - 1), 1e-6));
        const double smooth = std::fabs(sag(direct) / smoothSag - 1);
        REQUIRE(report(name + "direct, against the smooth curve", smooth, last / 3));
        last = smooth;
        World swept = looseChain(links, false);
        REQUIRE(relax(swept, small(links * 4), {.speed = 1e-6}).frames < 2400);
        REQUIRE(report(name + "one palindrome in " + std::to_string(links * 4) + " substeps",
                       std::fabs(sag(swept) / exact - 1), 1e-3));
    }
}

TEST_CASE("relaxed once, a world is at rest", "[statics][relax][SH11]") {
    World world = looseChain(20, true);
    const Relaxed first = relax(world, small(20));
    note("frames until at rest", first.frames);
    REQUIRE(report("speed left, m/s", first.speed, 1e-4));
    const Points pose = world.start;
    const Relaxed second = relax(world, small(20));
    double moved = 0;
    for (std::size_t i = 0; i < pose.size(); ++i)
        moved = std::max(moved, length(world.start[i] - pose[i]));
    REQUIRE(second.frames == 2);
    REQUIRE(report("moved by relaxing again, m", moved, 1e-5));
    // Without damping it stays where it is.
    Solver<double> solver(world, small(20));
    advance(solver, 24);
    REQUIRE(report("speed after a second without damping, m/s", topSpeed(solver), 1e-4));
    REQUIRE(world.rest[1].x == 0.1);
    REQUIRE(world.start[0] == Vec<double>{});
}

TEST_CASE("relaxing holds the pins where the film begins", "[statics][relax]") {
    World world = looseChain(10, true);
    world.pins.clear();
    const auto ride = [](const Vec<double>& x, double t) { return x + Vec<double>{0, t, 0}; };
    world.pin({0, 10}, ride);
    REQUIRE(relax(world, small(100), {.speed = 1e-7}).speed <= 1e-7);
    REQUIRE(report("sag between pins that will move", std::fabs(sag(world) / 0.8043710 - 1), 1e-6));
}

TEST_CASE("relaxing refuses nonsense, and gives up when told", "[statics][relax]") {
    World world = looseChain(10, true);
    REQUIRE_THROWS_AS(relax(world, small(1), {.speed = 0}), std::invalid_argument);
    REQUIRE_THROWS_AS(relax(world, small(1), {.frames = 0}), std::invalid_argument);
    REQUIRE_THROWS_AS(relax(world, small(1), {.damping = 1}), std::invalid_argument);
    const Relaxed cut = relax(world, small(20), {.frames = 3});
    REQUIRE(cut.frames == 3);
    REQUIRE(cut.speed > 1e-4);
}
