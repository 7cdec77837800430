// What cannot pass through: counted by exact tests that know nothing of the solver.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <numbers>

using namespace plait;
using namespace plait::test;

namespace {

// Frames in which something crosses, and crossings in all.
int crossingsOf(const World& world, int frames, const SolverOptions& options,
                const std::vector<std::array<int, 3>>& triangles) {
    Solver<float> solver(world, options);
    int crossings = 0;
    for (int frame = 0; frame < frames; ++frame) {
        solver.frame();
        crossings += countIntersections(solver.positions(), triangles);
    }
    CHECK(countsOf(solver, world).failed == 0);
    return crossings;
}

// Points that are shot at a sheet with a fixed border, from one side, a step at up to 10,000 times
// its thickness; how many are on the other side afterwards.
struct Shots {
    int through = 0, hits = 0;
};

Shots shoot(int bullets, std::uint64_t seed, bool contacts = true) {
    constexpr double thickness = 1e-4, h = 1.0 / 120;
    constexpr int side = 9;
    World world;
    Random random(seed);
    const Range sheet = world.add(
        grid({.columns = side, .rows = side}, {.origin = {-0.5, -0.5, 0}}), {.density = 0.2});
    std::vector<int> border;
    for (int v = sheet.first; v < sheet.last; ++v)
        if (v % side == 0 || v % side == side - 1 || v < side || v >= side * (side - 1))
            border.push_back(v);
    world.pin(border);
    Points from, velocity;
    for (int i = 0; i < bullets; ++i) {
        const Vec<double> target{random.uniform(-0.45, 0.45), random.uniform(-0.45, 0.45), 0};
        const Vec<double> aim{0.3 * random.uniform(-1, 1), 0.3 * random.uniform(-1, 1), -1};
        const double speed = random.uniform(100, 1e4) * thickness / h;
        from.push_back(target - random.uniform(1e-3, 2.5 * speed * h) * aim);
        velocity.push_back(speed * divide(1.0, length(aim)) * aim);
    }
    const Range shots =
        world.add({SimplicialComplex(bullets), from}, {.density = 1e-3, .velocity = velocity});
    holdSheet(world, sheet);
    if (contacts)
        meet(world,
             {{.vertices = sheet, .thickness = 0.5 * thickness},
              {.vertices = shots, .thickness = 0.5 * thickness, .self = Self::none}},
             {.order = 9});
    Solver<float> solver(world, [] {
        SolverOptions options = stepping(120);
        options.schedule.collisionPasses = 2;
        return options;
    }());
    advance(solver, 4);
    // A line from a bullet to the side it came from leaves through the border's loop as often as
    // it comes back: through an odd number of triangles if it is on the other side.
    Points x = solver.positions();
    const Points v = solver.velocities();
    const std::vector<std::array<int, 3>> triangles = trianglesOf(world);
    Shots found;
    for (int b = shots.first; b < shots.last; ++b) {
        if (length(v[b] - world.velocity[b]) > 1e-3) ++found.hits;
        if (std::fabs(x[b].x) > 0.5 || std::fabs(x[b].y) > 0.5) continue;
        x.push_back({x[b].x, x[b].y, 10});
        const std::vector<std::array<int, 2>> line{{b, static_cast<int>(x.size()) - 1}};
        found.through += countIntersections(x, line, triangles) % 2;
    }
    return found;
}

Shots shootAll(int bullets) {
    Shots all;
    for (int i = 0; i < bullets / 25; ++i) {
        const Shots some = shoot(25, static_cast<std::uint64_t>(i));
        all.through += some.through;
        all.hits += some.hits;
    }
    return all;
}

}  // namespace

// [D8]
TEST_CASE("crossings: no bullet goes through a thin sheet", "[contacts][crossings][CC2]") {
    const Shots all = shootAll(500);
    note("bullets that hit", all.hits);
    CHECK(all.hits > 400);
    CHECK(all.through == 0);
    CHECK(shoot(25, 1, false).through > 15);
}

TEST_CASE("crossings: no bullet of 10,000", "[contacts][crossings][long][CC2]") {
    const Shots all = shootAll(10000);
    note("bullets that hit", all.hits);
    CHECK(all.through == 0);
}

TEST_CASE("crossings: a sheet dropped on its edge", "[contacts][crossings]") {
    World world;
    const Range sheet =
        world.add(grid({.columns = 14, .rows = 14},
                       {.origin = {-0.5, 0.05, 0}, .up = {0, 0.99503719, 0.09950372}}),
                  {.density = 0.2});
    const Range floor = addSlope(world, 0, 4);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet);
    meet(world, {{.vertices = sheet, .thickness = 0.002}, {.vertices = floor, .thickness = 0.002}},
         {.order = 9});
    CHECK(crossingsOf(world, 36, meeting(12), trianglesOf(world)) == 0);
}

namespace {

// A strip whose ends turn against each other, a turn a second in all, and come nearer as they do.
int twist(int columns, int rows, double turns, double nearer, const SolverOptions& options) {
    World world;
    const Range strip = world.add(
        grid({.columns = columns, .rows = rows, .height = 0.25}, {.origin = {-0.5, -0.125, 0}}),
        {.density = 0.2});
    for (const int end : {-1, 1}) {
        std::vector<int> side;
        for (int row = 0; row < rows; ++row)
            side.push_back(strip.first + row * columns + (end > 0 ? columns - 1 : 0));
        world.pin(side, [=](const Vec<double>& x, double t) {
            const double angle = end * std::numbers::pi * t, in = end * nearer * t / turns / 2;
            const double c = cosine(angle), s = sine(angle);
            return Vec<double>{x.x - in, c * x.y - s * x.z, s * x.y + c * x.z};
        });
    }
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, strip);
    meet(world, {{.vertices = strip, .thickness = 0.001}}, {.order = 9});
    return crossingsOf(world, static_cast<int>(24 * turns), options, trianglesOf(world));
}

}  // namespace

// A strip of 1 m by 0.25 m has its sides on helices of 0.125 m about the axis: two turns leave
// sqrt(1 - (0.125 * 4 pi)^2) of its length and less than nothing, so it folds.
TEST_CASE("crossings: a twisted strip", "[contacts][crossings]") {
    CHECK(twist(25, 7, 2, 0.5, meeting(16)) == 0);
}

// [D9]
TEST_CASE("crossings: a strip twisted ten turns", "[contacts][crossings][long]") {
    CHECK(twist(41, 11, 10, 0.85, meeting(24)) == 0);
}

namespace {

// A cloth on a table under a cube, drawn away over the edge. Crossings of cloth and table in all
// frames, and whether the cube is still above.
struct Pull {
    int crossings = 0;
    double lowest = 0;  // m, of the cube above the table
};

Pull pull(double speed) {
    World world;
    const Range table = world.add(
        block({.width = 1, .height = 0.05, .depth = 0.6}, {.origin = {-0.5, -0.05, -0.3}}));
    std::vector<int> fixed;
    for (int v = table.first; v < table.last; ++v) fixed.push_back(v);
    world.pin(fixed);
    constexpr int columns = 21, rows = 9;
    const Range cloth =
        world.add(grid({.columns = columns, .rows = rows, .width = 1, .height = 0.4},
                       {.origin = {-0.3, 0.003, 0.2}, .up = {0, 0, -1}}),
                  {.density = 0.2});
    std::vector<int> hem;
    for (int row = 0; row < rows; ++row) hem.push_back(cloth.first + row * columns + columns - 1);
    world.pin(hem, [=](const Vec<double>& x, double t) {
        return x + Vec<double>{speed * t, -0.2 * speed * t, 0};
    });
    const Range cube = world.add(
        block({.width = 0.1, .height = 0.1, .depth = 0.1}, {.origin = {-0.1, 0.006, -0.05}}),
        {.density = 300});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, cube), world.rest),
                    {.name = "cube"});
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, cloth, {.order = 1});
    meet(world, {{.vertices = table}, {.vertices = cloth}, {.vertices = cube}}, {.order = 9});
    Solver<float> solver(world, meeting(16, 3));
    const int frames = static_cast<int>(24 * 1.5 / speed) + 3;
    Pull found{0, 1};
    for (int frame = 0; frame < frames; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        found.crossings += countIntersections(x, trianglesOf(world));
        found.lowest = std::min(found.lowest, meanOf(x, cube).y - 0.05);
    }
    CHECK(countsOf(solver, world).failed == 0);
    return found;
}

}  // namespace

// [D7]
TEST_CASE("crossings: a cloth drawn from under a cube", "[contacts][crossings]") {
    for (const double speed : {0.5, 2.0, 8.0}) {
        const Pull found = pull(speed);
        INFO(speed);
        note("lowest of the cube, m", found.lowest);
        CHECK(found.crossings == 0);
        if (speed >= 2) CHECK(found.lowest > 0);  // slower, the cloth takes the cube along
    }
}
