// What begins too near parts slowly, at ContactOptions::recovery (M 4.5, V).
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/energy.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double never = 1e9;  // m/s, a recovery that holds nothing back

// Two sheets of 0.2 kg, 1 mm apart, each with a skin of 2 cm.
struct Parting {
    double first,
        most;       // m, by which they part in the first substep, and in any of a quarter second
    double energy;  // J, at most
    double apart;   // m, in the end
};

World sheets(double recovery) {
    World world;
    for (const double height : {0.0, 0.001})
        world.add(grid({.columns = 6, .rows = 6}, {.origin = {0, height, 0}, .up = {0, 0, -1}}),
                  {.density = 0.2});
    world.constrain(linksOf(world), {.name = "links"});
    meet(world,
         {{.vertices = {0, 36}, .thickness = 0.02}, {.vertices = {36, 72}, .thickness = 0.02}},
         {.order = 1, .recovery = recovery});
    return world;
}

Parting parting(double recovery, Integrator integrator) {
    const World world = sheets(recovery);
    SolverOptions options = stepping(480);
    options.integrator = integrator;
    Solver<double> solver(world, options);
    Parting found{};
    double before = 0.001;
    for (int i = 0; i < 120; ++i) {
        solver.frame();
        const Points x = solver.positions();
        double now = 1;
        for (int v = 0; v < 36; ++v) now = std::min(now, x[36 + v].y - x[v].y);
        if (i == 0) found.first = now - before;
        found.most = std::max(found.most, now - before);
        found.energy = std::max(found.energy, kineticEnergy(world.mass, solver.velocities()));
        before = now;
    }
    found.apart = before;
    return found;
}

}  // namespace

// They part at r, and keep nothing of it.
TEST_CASE("overlap: two that begin too near part, and do not fly on",
          "[contacts][overlap][CC15][SH9]") {
    const auto see = [](double r, Integrator integrator) {
        const Parting ours = parting(r, integrator);
        const double way = std::min(r / 480, 0.039), v = 480 * way;
        const std::string of = "let go at " + std::to_string(r) + " m/s, ";
        CHECK(report(of + "first way / r h", std::fabs(ours.first / way - 1), 1e-9));
        CHECK(report(of + "most / r h", ours.most / way - 1, 1e-9));
        CHECK(report(of + "energy / m r^2 / 4", ours.energy / (0.2 * v * v / 4), 1e-9));
        CHECK(report(of + "lacks, m", std::min(0.04, 0.001 + r / 4) - ours.apart, 1e-9));
    };
    for (const double r : {0.01, 0.1, 0.5, never}) see(r, Integrator::first);
    see(0.1, Integrator::bdf2);
}

TEST_CASE("overlap: a run resumed while it parts has the same bits",
          "[contacts][overlap][determinism]") {
    const World world = sheets(0.1);
    Solver<float> straight(world, stepping(480)), resumed(world, stepping(480));
    for (int i = 0; i < 20; ++i) straight.frame();
    resumed.restore(straight.state(), straight.evaluations());
    for (int i = 0; i < 40; ++i) {
        straight.frame();
        resumed.frame();
    }
    CHECK(straight.hash() == resumed.hash());
}

// A skin that is thicker than the triangles.
TEST_CASE("overlap: a sheet thicker than its mesh stays at rest",
          "[contacts][overlap][CC15][SH9]") {
    World world;
    const Range sheet = world.add(grid({.columns = 8, .rows = 8}));
    holdSheet(world, sheet);
    meet(world, {{.vertices = sheet, .thickness = 0.2}}, {.order = 9, .recovery = never});
    Solver<double> solver(world, meeting(8));
    advance(solver, 12);
    REQUIRE(countsOf(solver, world).contacts > 1000);
    CHECK(report("speed, m/s", topSpeed(solver), 1e-9));
}

// What counts of two thicknesses is the least of both together and of what is between
// them and r h: never less than it was.
TEST_CASE("overlap: thickness opens as particles part, and never closes again",
          "[contacts][overlap][CC17]") {
    constexpr int count = 24;
    constexpr double radius = 0.1, recovery = 0.2;
    World world;
    Random random(12);
    Points at, velocity;
    for (int i = 0; i < count; ++i) {
        at.push_back(random.point(0.25));
        velocity.push_back(-0.8 * at.back() + random.point(0.1));  // upon each other
    }
    // Each is a surface of its own: two of one would stay as near as at rest.
    std::vector<Surface> surfaces(count);
    for (int i = 0; i < count; ++i) {
        surfaces[i].vertices = addPoint(world, at[i], 1, velocity[i]);
        surfaces[i].thickness = radius;
        surfaces[i].staticFriction = surfaces[i].dynamicFriction = 0;
    }
    meet(world, surfaces, {.recovery = recovery});
    SolverOptions options = stepping(240);
    options.schedule.collisionPasses = 50;
    Solver<double> solver(world, options);
    const double h = solver.substepLength();
    const auto counted = [&](const Points& x, int i, int j) {
        return std::min(2 * radius, length(x[i] - x[j]) + recovery * h);
    };
    Points before = solver.positions();
    int overlapping = 0;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) overlapping += length(before[i] - before[j]) < 2 * radius;
    double closed = 0;
    for (int step = 0; step < 720; ++step) {
        solver.frame();
        const Points x = solver.positions();
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < i; ++j)
                closed = std::max(closed, counted(before, i, j) - counted(x, i, j));
        before = x;
    }
    double least = 1;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) least = std::min(least, length(before[i] - before[j]));
    note("pairs that begin too near", overlapping);
    REQUIRE(overlapping > 20);
    CHECK(report("closed again in a step, m", closed, 1e-9));
    CHECK(report("not yet open after 3 s, m", 2 * radius - least, 1e-6));
}

// A point deep in the skin of a plate that would be flung out at once.
TEST_CASE("overlap: a contact moves nothing further than its limit",
          "[contacts][overlap][CC20][FH13]") {
    for (const double limit : {0.0, 0.001}) {
        World world;
        const Range floor = addSlope(world, 0);
        const Range point = addPoint(world, {0.3, 0.01, 0});
        meet(world,
             {{.vertices = floor, .thickness = 0.05}, {.vertices = point, .thickness = 0.05}},
             {.recovery = 1e6, .displacementLimit = limit});
        Solver<double> solver(world, stepping(240));
        double most = 0, y = 0.01, v = 0;
        for (int step = 0; step < 24; ++step) {
            solver.frame();
            const double now = solver.positions()[point.first].y;
            most = std::max(most, std::fabs(now - (y + v / 240)));
            y = now;
            v = solver.velocities()[point.first].y;
        }
        const long limited = countsOf(solver, world).limited;
        CHECK((limited > 0) == (limit > 0));
        if (limit > 0) CHECK(report("moved by contact, m", most, limit * (1 + 1e-9)));
        if (limit == 0) CHECK(report("without a limit, at once, m", std::fabs(most - 0.09), 1e-9));
        CHECK(y > 0.1 - 1e-6);
    }
}
