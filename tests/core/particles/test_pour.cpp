// Water that leaves what holds it: poured from a jug, and through a hole in the bottom of a tank.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/solids/placement.h>
#include <plait/numbers/elementary.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace plait;
using namespace plait::test;

namespace {

// A beaker with a wall this thick, all m, from y = 0 up.
Profile beaker(double radius, double height, double thick) {
    return Profile({{0, -thick},
                    {radius + thick, -thick},
                    {radius + thick, height},
                    {radius, height},
                    {radius, 0},
                    {0, 0}});
}

Collider smooth(Profile profile) {
    Collider wall{.solid = Solid::turned(std::move(profile))};
    wall.staticFriction = wall.dynamicFriction = 0;
    return wall;
}

// Over its rim in a second, until it is upside down.
Frame jugAt(double t, double radius, double height) {
    const double a = 2.8 * std::clamp(t - 0.2, 0.0, 1.0), c = cosine(a), s = sine(a);
    return {.origin = {-0.14 - radius * c - height * s, 0.9 + radius * s - height * c, 0},
            .across = {c, -s, 0},
            .up = {s, c, 0}};
}

}  // namespace

TEST_CASE("pour: what a jug held is in the pot below, and none of it went through a wall",
          "[liquid]") {
    const double spacing = 0.02, radius = 0.1, height = 0.24;
    Collider jug = smooth(beaker(radius, height, 2 * spacing));
    jug.motion = [=](double t) { return jugAt(t, radius, height); };
    const Collider pot = smooth(beaker(0.3, 0.6, 2 * spacing));
    auto positions = blockOf(7, 8, 7, spacing, 0.05);
    const Frame start = jugAt(0, radius, height);
    for (Vec<double>& p : positions) p += start.origin + Vec<double>{-0.07, 0.005, -0.07};
    const auto count = static_cast<long>(positions.size());
    Pool pool(std::move(positions), spacing, {jug, pot});
    pool.fall();
    Solver<float> solver(pool.world, perSecond(1200));
    const auto isIn = [](const Vec<double>& p) {
        return std::hypot(p.x, p.z) < 0.3 && p.y > 0 && p.y < 0.6;
    };
    const auto isBeside = [](const Vec<double>& p) {
        return p.y < 0 || (std::hypot(p.x, p.z) > 0.34 && p.y < 0.6);
    };
    double deepest = infinity, densest = 0;
    long through = 0;
    std::vector<Vec<double>> before = solver.positions();
    for (int frame = 0; frame < 100; ++frame) {
        solver.frame();
        const Placement at(jugAt(solver.time(), radius, height), "jug");
        const std::vector<Vec<double>> x = solver.positions();
        for (std::size_t i = 0; i < x.size(); ++i) {
            deepest = std::min({deepest, sideOf(pot.solid, x[i]).distance,
                                sideOf(jug.solid, at.own(x[i])).distance});
            through += isIn(before[i]) && isBeside(x[i]);
        }
        before = x;
        if (frame % 5 == 0)
            densest = std::max(densest,
                               std::ranges::max(densityRatios(pool.liquid, x, solver.time())) - 1);
        REQUIRE(solver.failures() == 0);
    }
    // What is not in it splashed over its rim.
    const long inPot = std::ranges::count_if(before, isIn);
    note("over the rim", static_cast<double>(count - inPot));
    REQUIRE(through == 0);
    REQUIRE(inPot >= count - 4);
    REQUIRE(deepest > 0);
    REQUIRE(report("largest compression", densest, 0.1));
}

// Torricelli's jet through a sharp edge: it narrows to 0.61 of the hole.
TEST_CASE("pour: water leaves a hole as fast as Torricelli has it", "[liquid][long]") {
    const double spacing = 0.02, hole = 4 * spacing, radius = 9 * spacing, depth = 16 * spacing;
    const Collider tank = smooth(Profile({{hole, 0},
                                          {hole + 2 * spacing, -2 * spacing},
                                          {radius + 2 * spacing, -2 * spacing},
                                          {radius + 2 * spacing, 2 * depth},
                                          {radius, 2 * depth},
                                          {radius, 0}}));
    std::vector<Vec<double>> positions;
    for (Vec<double> p : blockOf(18, 16, 18, spacing, 0.05)) {
        p += {-radius, 0, -radius};
        if (std::hypot(p.x, p.z) < radius - 0.5 * spacing) positions.push_back(p);
    }
    const double volume = spacing * spacing * spacing, area = pi * radius * radius;
    Pool pool(std::move(positions), spacing, {tank});
    pool.fall();
    Solver<float> solver(pool.world, perSecond(1500));
    const auto left = [&] {
        const std::vector<Vec<double>> x = solver.positions();
        return volume * static_cast<double>(
                            std::ranges::count_if(x, [](const Vec<double>& p) { return p.y > 0; }));
    };
    double before = 0, ideal = 0, after = 0;
    for (int frame = 0; frame < 45; ++frame) {
        solver.frame();
        if (frame == 14) before = left();
        if (frame < 15) continue;
        after = left();
        ideal += 0.02 * pi * hole * hole * std::sqrt(2 * 9.81 * after / area);
    }
    REQUIRE(solver.failures() == 0);
    const double part = (before - after) / ideal;
    note("level at the end, spacings", after / area / spacing);
    note("part of the ideal flow", part);
    REQUIRE(report("beside 0.61", std::fabs(part / 0.61 - 1), 0.08));
}
