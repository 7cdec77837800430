// What falls in one piece of several dimensions, what is launched, and what begins crossed.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/solids/collider.h>

#include <string>

using namespace plait;
using namespace plait::test;

// A tetrahedron, a triangle that shares an edge with it, a link that dangles from that, and a
// point.
TEST_CASE("launches: a complex of mixed dimensions falls, lands and keeps its lengths",
          "[contacts][SH2]") {
    World world;
    const Simplices parts{
        .edges = {{4, 5}}, .triangles = {{2, 3, 4}}, .tetrahedra = {{0, 1, 2, 3}}};
    const Points at{{0, 0.5, 0},      {0.2, 0.5, 0},    {0, 0.7, 0},    {0, 0.5, 0.2},
                    {-0.2, 0.7, 0.2}, {-0.5, 0.8, 0.2}, {0.6, 0.9, 0.1}};
    const Range all = world.add({SimplicialComplex(7, parts), at}, {.density = 100});
    REQUIRE(world.complex.count(1) == 9);
    for (double& mass : world.mass) mass = 0.1;
    world.act<Gravity>(GravityOptions{});
    const Rows<Stretch> links = linksOf(world);
    world.constrain(links, {.name = "links"});
    meet(world, {{.vertices = all, .thickness = 0.01}}, {.order = 1});
    collide(world, {Collider{.solid = Solid::plane()}}, {{.vertices = all, .thickness = 0.01}},
            {.name = "floor", .order = 2});
    Solver<float> solver(world, meeting(20, 8));
    double lowest = 1;
    for (int frame = 0; frame < 72; ++frame) {
        solver.frame();
        for (const Vec<double>& x : solver.positions()) lowest = std::min(lowest, x.y);
    }
    const Points x = solver.positions();
    for (const Vec<double>& p : x) CHECK(p.y < 0.25);
    CHECK(report("into the floor, m", 0.01 - lowest, 1e-5));
    double strain = 0;
    for (const double e : strainsOf(links, x)) strain = std::max(strain, std::fabs(e));
    CHECK(report("strain at rest", strain, 1e-3));
    CHECK(report("the lone point rests, m", std::fabs(x[6].y - 0.01), 1e-5));
}

// A sheet that bulges at 3 (1 - r^2) m/s, flat as it meets the points that wait above it.
TEST_CASE("launches: what changes its shape launches what it meets as fast as it comes there",
          "[contacts][CC14]") {
    constexpr double speed = 3, gap = 0.02;
    for (const double e : {0.0, 0.5}) {
        World world;
        const Range sheet = world.add(grid({.columns = 41, .rows = 41, .width = 2, .height = 2},
                                           {.origin = {-1, 0, 1}, .up = {0, 0, -1}}));
        std::vector<int> all(static_cast<std::size_t>(sheet.size()));
        for (int v = 0; v < sheet.size(); ++v) all[static_cast<std::size_t>(v)] = v;
        const auto rate = [](const Vec<double>& x) {
            return speed * std::max(0.0, 1 - x.x * x.x - x.z * x.z);
        };
        world.pin(all, [rate](const Vec<double>& x, double t) {
            return x + Vec<double>{0, rate(x) * t, 0};
        });
        const Points waiting{{0.01, gap, 0.02}, {0.31, gap, -0.2}, {-0.5, gap, 0.42}};
        const Range points = world.add({SimplicialComplex(3), waiting}, {.density = 0.01});
        Surface below{.vertices = sheet, .thickness = 0.001, .restitution = e};
        Surface above{.vertices = points, .thickness = 0.001, .restitution = e};
        below.staticFriction = below.dynamicFriction = 0;
        above.staticFriction = above.dynamicFriction = 0;
        below.self = Self::none;
        meet(world, {below, above});
        Points launched(3);
        for (int i = 0; i < 3; ++i) {
            Solver<double> one(world, stepping(2400));
            while (length(one.velocities()[points.first + i]) == 0 && one.time() < 1) one.frame();
            one.frame();
            launched[static_cast<std::size_t>(i)] = one.velocities()[points.first + i];
        }
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(report("launched at, e " + std::to_string(e),
                         std::fabs(launched[i].y / ((1 + e) * rate(waiting[i])) - 1), 0.01));
    }
}

// M 4.5: a bad start is not solved. Contacts keep what they find, on either side.
TEST_CASE("launches: two sheets that begin across each other stay so", "[contacts][FH14]") {
    World world;
    const Range one = world.add(grid({.columns = 9, .rows = 9}, {.up = {0, 0, -1}}));
    const Range other = world.add(
        grid({.columns = 9, .rows = 9}, {.origin = {0.03, -0.5, -0.53}, .across = {1, 0, 0}}));
    world.constrain(linksOf(world), {.name = "links"});
    meet(world, {{.vertices = one, .thickness = 0.005}, {.vertices = other, .thickness = 0.005}},
         {.order = 1});
    Solver<float> solver(world, meeting(20, 8));
    const int before = countIntersections(solver.positions(), trianglesOf(world));
    advance(solver, 48);
    const int after = countIntersections(solver.positions(), trianglesOf(world));
    note("pairs of triangles that cross, at the start", before);
    note("two seconds later", after);
    CHECK(before > 10);
    CHECK(after > 10);
    for (const Vec<double>& x : solver.positions()) CHECK(length(x) < 3);
}
