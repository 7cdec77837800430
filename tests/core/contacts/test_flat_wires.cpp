// Flat wires meet as ellipses.
#include "tests/catch.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/report.h"

#include <plait/rods/rod.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double halfThick = 0.3e-3, halfWide = 1.2e-3;
constexpr Wire wire{.along = 2 * halfWide, .across = 2 * halfThick};

// Along x, its directors that way, beginning at `from`.
Rod addWire(World& world, const Vec<double>& from, const Vec<double>& toward) {
    const Shape shape = chain({.links = 4, .from = from, .to = from + Vec<double>{0.02, 0, 0}});
    return addRod(world, shape, {.wire = wire, .toward = {toward}}, {.name = "wire"});
}

Surface skinOf(const Rod& rod, double friction) {
    return {.vertices = rod.points,
            .thickness = halfThick,
            .directors = rod.directors,
            .halfWidth = halfWide,
            .staticFriction = friction,
            .dynamicFriction = friction};
}

void pin(World& world, const Rod& rod) {
    std::vector<int> all;
    for (int v = rod.points.first; v < rod.points.last; ++v) all.push_back(v);
    for (int v = rod.directors.first; v < rod.directors.last; ++v) all.push_back(v);
    world.pin(all);
}

// Where the middle vertex of `rod` has come to rest.
Vec<double> restOf(World& world, const Rod& rod) {
    world.act<Gravity>(GravityOptions{});
    SolverOptions options{.sweeps = Sweeps::oneWay, .schedule = {.substeps = 48}};
    options.damping = 0.2;
    Solver<double> solver(world, options);
    for (int frame = 0; frame < 12; ++frame) solver.frame();
    CHECK(solver.failures() == 0);
    return solver.positions()[rod.points.first + 2];
}

}  // namespace

// As far apart as two ellipses side by side, wherever across the one the other lies: what is round
// would be on the floor beyond the thickness.
TEST_CASE("contacts: a flat wire lies on another as an ellipse on an ellipse", "[contacts][rods]") {
    for (const double part : {0.0, 0.4, 0.7}) {
        World world;
        const Rod below = addWire(world, {}, {0, 0, 1});
        const double aside = part * 2 * halfWide;
        const Rod above = addWire(world, {0.001, 0.8e-3, aside}, {0, 0, 1});
        pin(world, below);
        meet(world, {skinOf(below, 1), skinOf(above, 1)});
        const Vec<double> at = restOf(world, above);
        const double y = at.y / (2 * halfThick), z = at.z / (2 * halfWide);
        CHECK(report("off the ellipse", std::fabs(std::hypot(y, z) - 1), 0.01));
        CHECK(report("slid, m", std::fabs(at.z - aside), 0.15e-3));
    }
}

TEST_CASE("contacts: a flat wire lies low and stands high", "[contacts][rods]") {
    for (const bool stands : {false, true}) {
        World world;
        const Rod rod =
            addWire(world, {0, 1.5e-3, 0}, stands ? Vec<double>{0, 1, 0} : Vec<double>{0, 0, 1});
        const Range floor = addSlope(world, 0, 0.2);
        meet(world, {skinOf(rod, 1), {.vertices = floor, .thickness = 0, .self = Self::none}});
        const double high = stands ? halfWide : halfThick;
        CHECK(report("off its height, m", std::fabs(restOf(world, rod).y - high), 0.01 * high));
    }
}

TEST_CASE("contacts: sections that cannot be are refused", "[contacts][rods]") {
    World world;
    const Rod rod = addWire(world, {}, {0, 0, 1});
    Surface skin = skinOf(rod, 0);
    skin.halfWidth = 0.5 * halfThick;
    CHECK_THROWS_WITH(meet(world, {skin}), Catch::Contains("at least as wide as thick"));
    skin = skinOf(rod, 0);
    skin.restitution = 0.5;
    CHECK_THROWS_WITH(meet(world, {skin}), Catch::Contains("does not bounce"));
    skin = skinOf(rod, 0);
    skin.directors.last -= 1;
    CHECK_THROWS_WITH(meet(world, {skin}), Catch::Contains("a director an edge"));
}
