// Rods with frames and of points only, and shapes that they would rather have than the one they
// start in.
#include "tests/catch.h"
#include "tests/core/rods/rod_worlds.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

struct Run {
    std::vector<Vec<double>> x;
    double speed;
};

// Two evaluations a substep: what is let go far from its shape turns too far in one.
Run runFor(const World& world, double seconds, double damping = 0) {
    Solver<float> solver(world, stepping(10, damping, 2));
    for (int frame = 0; frame < 24 * seconds; ++frame) solver.frame();
    return {solver.positions(), fastest(solver)};
}

Vec<double> unit(const Vec<double>& a) { return (1 / length(a)) * a; }

// `a` turned by the vector `turn` (Rodrigues).
Vec<double> turned(const Vec<double>& a, const Vec<double>& turn) {
    const double angle = length(turn);
    const Vec<double> n = unit(turn);
    return std::cos(angle) * a + std::sin(angle) * cross(n, a) +
           ((1 - std::cos(angle)) * dot(n, a)) * n;
}

constexpr int links = 40;
constexpr Wire wire{.along = 4e-3};

}  // namespace

// What starts straight, or bent otherwise, becomes the coil that it is told to be: joint by joint
// each edge is the one before it, turned.
TEST_CASE("rods: one with a shape of its own takes it", "[rods]") {
    const Vec<double> natural{1.5, 7, 3};  // 1/m
    World world;
    const Rod rod =
        addRod(world, chain({.links = links}),
               {.wire = wire, .natural = {natural}, .toward = {{0, 1, 0}}}, {.name = "tendril"});
    world.pin({rod.points.first, rod.points.first + 1, rod.directors.first});
    const Run run = runFor(world, 6, 6);
    const double l = 1.0 / links;
    Vec<double> d{0, 1, 0}, t{1, 0, 0}, x{};
    double off = 0;
    for (int e = 0; e < links; ++e) {
        x += l * t;
        off = std::max(off, length(run.x[rod.points.first + e + 1] - x));
        const Vec<double> turn = l * (natural.x * d + natural.y * cross(t, d) + natural.z * t);
        d = turned(d, turn);
        t = turned(t, turn);
    }
    CHECK(report("off its own shape, m", off, 1e-5));
    CHECK(report("speed, m/s", run.speed, 1e-5));
}

// Of points only: an arc that would rather be a coil. Only what bends and turns counts, so that the
// distance of both ends does.
TEST_CASE("rods: a curved one of points only takes a shape of its own", "[rods]") {
    const Shape arc = helix({.links = links, .radius = 0.3, .turns = 0.5, .pitch = 0});
    const double l = length(arc.positions[1] - arc.positions[0]);
    for (const double twist : {3.0, -3.0}) {
        constexpr double curvature = 7;
        World world;
        const Rod rod =
            addRod(world, arc,
                   {.wire = wire, .model = RodModel::curved, .natural = {{0, curvature, twist}}},
                   {.name = "tendril"});
        world.pin({rod.points.first, rod.points.first + 1});
        const Run run = runFor(world, 4, 6);
        // Edge after edge is turned about the binormal, and that about the edge.
        Vec<double> t{1, 0, 0}, b{0, 0, 1}, x{};
        for (int e = 0; e < links; ++e) {
            x += l * t;
            t = turned(t, (curvature * l) * b);
            b = turned(b, (twist * l) * t);
        }
        const Vec<double> from = run.x[rod.points.first], to = run.x[rod.points.last - 1];
        CHECK(report("distance of the ends, m", std::fabs(length(to - from) - length(x)), 1e-5));
        // Right handed where the twist is positive.
        const Vec<double> e0 = run.x[1] - run.x[0], e1 = run.x[2] - run.x[1],
                          e2 = run.x[3] - run.x[2];
        const double handed = dot(cross(e0, e1), e2) * twist;
        CHECK(handed > 0);
        CHECK(report("speed, m/s", run.speed, 1e-5));
    }
}

TEST_CASE("rods: what starts as an arc and is straight by nature straightens", "[rods]") {
    const Shape arc = helix({.links = links, .radius = 0.2, .turns = 0.75, .pitch = 0.1});
    for (const bool framed : {true, false}) {
        RodOptions options{.wire = wire};
        if (framed)
            options.natural = {{}};
        else
            options.model = RodModel::straight;
        World world;
        const Rod rod = addRod(world, arc, options, {.name = "wire"});
        const Run run = runFor(world, 6, 6);
        const double whole = links * length(arc.positions[1] - arc.positions[0]);
        const double reach = length(run.x[rod.points.first] - run.x[rod.points.last - 1]);
        CHECK(report("reach off its length", std::fabs(reach / whole - 1), 1e-6));
    }
}

TEST_CASE("rods: a coil at rest stays", "[rods]") {
    const Shape coil = helix({.links = 3 * links, .radius = 0.03, .turns = 5, .pitch = 0.02});
    for (const RodModel model : {RodModel::framed, RodModel::curved}) {
        World world;
        addRod(world, coil, {.wire = {.along = 2e-3, .across = 1e-3}, .model = model},
               {.name = "coil"});
        const Run run = runFor(world, 4);
        double off = 0;
        for (std::size_t v = 0; v < run.x.size(); ++v)
            off = std::max(off, length(run.x[v] - world.rest[v]));
        CHECK(report("off its place, m", off, 1e-8));
        CHECK(report("speed, m/s", run.speed, 1e-8));
    }
}

TEST_CASE("rods: those of one set move as each alone does, to the bit", "[rods]") {
    std::vector<Shape> shapes;
    for (const double z : {0.0, 0.1, 0.2, 0.3, 0.4})
        shapes.push_back(
            helix({.links = links, .radius = 0.03, .turns = 2, .pitch = 0.02 + 0.1 * z},
                  {.origin = {0, 0, z}}));
    const RodOptions options{.wire = {.along = 2e-3, .across = 1e-3}};
    const auto clamp = [](World& world, const Rod& rod) {
        world.pin({rod.points.first, rod.points.first + 1, rod.directors.first});
    };
    World world;
    const std::vector<Rod> rods = addRods(world, shapes, options, {.name = "coils"});
    for (const Rod& rod : rods) clamp(world, rod);
    world.act<Gravity>(GravityOptions{});
    const Run together = runFor(world, 0.5);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        World single;
        const Rod rod = addRod(single, shapes[i], options, {.name = "coil"});
        clamp(single, rod);
        single.act<Gravity>(GravityOptions{});
        const Run alone = runFor(single, 0.5);
        double off = 0;
        for (int v = 0; v < rod.points.size(); ++v)
            off = std::max(off, length(together.x[rods[i].points.first + v] - alone.x[v]));
        CHECK(off == 0);
    }
}

TEST_CASE("rods: one of points only droops as one with frames does", "[rods]") {
    double tip[2];
    for (const bool framed : {true, false}) {
        World world;
        const Rod rod =
            addRod(world, chain({.links = links}),
                   {.wire = wire, .model = framed ? RodModel::framed : RodModel::straight},
                   {.name = "rod"});
        world.pin({rod.points.first, rod.points.first + 1});
        if (framed) world.pin({rod.directors.first});
        world.act<Gravity>(GravityOptions{.acceleration = {0, -5, 3}});
        tip[framed] = runFor(world, 6, 6).x[rod.points.last - 1].y;
    }
    note("droop, m", -tip[0]);
    CHECK(report("apart, m", std::fabs(tip[0] - tip[1]), 1e-4));
}

// Without stiffness it is a chain, and a frame that nothing turns is not twisted.
TEST_CASE("rods: one as good as without stiffness swings as a chain", "[rods]") {
    const auto swing = [](auto hold) {
        World world;
        const int first = hold(world);
        world.pin({first});
        world.act<Gravity>(GravityOptions{.acceleration = {0, -9.81, 1}});
        Solver<double> solver(world, stepping(40, 0, 2));
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        const auto x = solver.positions();
        return std::vector(x.begin() + first, x.begin() + first + links + 1);
    };
    constexpr Wire limp{.youngs = 1e-3, .along = 1e-3};
    const auto chained = swing([&](World& world) {
        const Range all = world.add(chain({.links = links}), {.density = limp.density * 7.85e-7});
        world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest),
                        {.name = "links", .direct = true});
        return all.first;
    });
    for (const RodModel model : {RodModel::straight, RodModel::framed}) {
        const auto limply = swing([&](World& world) {
            return addRod(world, chain({.links = links}), {.wire = limp, .model = model},
                          {.name = "rod"})
                .points.first;
        });
        double off = 0;
        for (std::size_t v = 0; v < limply.size(); ++v)
            off = std::max(off, length(limply[v] - chained[v]));
        CHECK(report("off the chain after 1 s, m", off, 1e-3));  // two sets, each of first order
    }
}

// A flat wire as a coil, few turns of it in weak gravity, as in test_frames.cpp: torsion alone.
TEST_CASE("rods: a coil of points only hangs as far as its wire says", "[rods]") {
    constexpr int turns = 10, around = 24;
    constexpr double radius = 0.034, g = 0.5;
    World world;
    const Wire flat{.poisson = 200.0 / 158 - 1, .along = 2.5e-3, .across = 0.62e-3};
    const Rod rod = addRod(
        world, helix({.links = turns * around, .radius = radius, .turns = turns, .pitch = 0.62e-3}),
        {.wire = flat, .model = RodModel::curved}, {.name = "coil"});
    std::vector<int> held;
    for (int i = 0; i <= around; ++i) held.push_back(rod.points.last - 1 - i);
    world.pin(held);
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    double mass = 0, start = 0, end = 0;
    for (const double m : world.mass) mass += m;
    const double free = turns - 1,
                 stiffness = flat.twisting() / (2 * pi * free * radius * radius * radius),
                 expected = mass * free / turns * g / 2 / stiffness;
    const Run run = runFor(world, 6, 4);
    for (int i = 0; i < around; ++i) {
        start += world.start[i].y / around;
        end += run.x[i].y / around;
    }
    note("extension against that of the wire", (start - end) / expected);
    CHECK(report("extension off", std::fabs((start - end) / expected - 1), 0.03));
    CHECK(report("speed, m/s", run.speed, 1e-5));
}

TEST_CASE("rods: what points alone cannot hold is refused by name", "[rods]") {
    const auto add = [](const Shape& curve, const RodOptions& options) {
        World world;
        addRod(world, curve, options, {.name = "wire"});
    };
    const Shape line = chain({.links = 4}), coil = helix({.links = 12});
    CHECK_NOTHROW(add(coil, {.model = RodModel::curved}));
    CHECK_THROWS_WITH(add(line, {.model = RodModel::curved}),
                      Catch::Contains("joint 0 is straight"));
    CHECK_THROWS_WITH(add(coil, {.model = RodModel::curved, .natural = {{}}}),
                      Catch::Contains("joint 0 is straight"));
    CHECK_THROWS_WITH(add(line, {.model = RodModel::straight, .natural = {{}}}),
                      Catch::Contains("no natural curvature"));
    CHECK_THROWS_WITH(add(line, {.wire = {.across = 2e-3}, .model = RodModel::straight}),
                      Catch::Contains("round wire"));
    CHECK_THROWS_WITH(add(line, {.model = RodModel::straight, .toward = {{0, 1, 0}}}),
                      Catch::Contains("no directors"));
    CHECK_THROWS_WITH(add(line, {.natural = {{}, {}}}), Catch::Contains("one natural curvature"));
    CHECK_THROWS_WITH(add(line, {.natural = {{0, 20, 0}}}), Catch::Contains("half a turn"));
}
