// What a vertex weighs in a contact: its mass, or as much as any other (M 5.2).
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double ballMass = 0.5, sheetMass = 1, speed = 1;  // kg, kg, m/s

struct Split {
    double ball, sheet;  // m/s, after they met
    double part;         // of the sheet, that the vertex that is hit stands for
    double legacy;       // m/s, of both, if each counts as heavy as its point mass
};

// A ball that meets a sheet of 1 m^2 edge on, in its plane and in the middle of a side, so that
// what can be drawn out and not bent moves as one; without restitution both go on together.
Split hit(int side, ContactMass mass, double pointMass = 1) {
    World world;
    const Range sheet = world.add(grid({.columns = side, .rows = side}), {.density = sheetMass});
    const Range ball = addPoint(world, {0.5, -0.01, 0}, ballMass, {0, speed, 0});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest),
                    {.name = "links"});
    const auto surface = [](Range vertices, double each) {
        Surface of;
        of.vertices = vertices;
        of.staticFriction = of.dynamicFriction = 0;
        of.pointMass = each;
        return of;
    };
    meet(world, {surface(sheet, pointMass), surface(ball, ballMass)}, {.mass = mass, .order = 1});
    SolverOptions options = meeting(6, 1000);
    Solver<double> solver(world, options);
    advance(solver, 2);
    const Points v = solver.velocities();
    Split split{v[ball.first].y, 0, world.mass[side / 2] / sheetMass, 0};
    for (int i = sheet.first; i < sheet.last; ++i)
        split.sheet += world.mass[i] / sheetMass * v[i].y;
    // The links pass on the momentum of the one vertex, with the masses that they have.
    const double seems = pointMass / split.part;
    split.legacy = speed * ballMass / (ballMass + seems);
    return split;
}

}  // namespace

TEST_CASE("contact mass: a finer sheet of the same weight is as heavy", "[contacts][CC26][UN12]") {
    const double together = speed * ballMass / (ballMass + sheetMass);
    for (const int side : {3, 5, 7}) {
        const Split split = hit(side, ContactMass::physical);
        const std::string of = std::to_string(side) + " vertices a side, ";
        CHECK(report(of + "the ball, m/s", std::fabs(split.ball - together), 1e-3));
        CHECK(report(of + "the sheet, m/s", std::fabs(split.sheet - together), 1e-3));
    }
}

TEST_CASE("contact mass: with point masses a finer sheet seems heavier", "[contacts][CC26]") {
    double last = speed;
    for (const int side : {3, 5, 7}) {
        const Split split = hit(side, ContactMass::legacy);
        const std::string of = std::to_string(side) + " vertices a side, ";
        note(of + "speed of both, m/s", split.legacy);
        CHECK(report(of + "the ball, m/s", std::fabs(split.ball - split.legacy), 1e-3));
        CHECK(report(of + "the sheet, m/s", std::fabs(split.sheet - split.legacy), 1e-3));
        CHECK(split.ball < 0.6 * last);
        last = split.ball;
    }
    // As M advises: the mass is adjusted to the area that a vertex covers.
    for (const int side : {3, 7}) {
        const Split split = hit(side, ContactMass::legacy, hit(side, ContactMass::legacy).part);
        const double together = speed * ballMass / (ballMass + sheetMass);
        CHECK(report("adjusted, m/s", std::fabs(split.ball - together), 1e-3));
    }
    World world;
    Surface light;
    light.vertices = addPoint(world, {});
    light.pointMass = 0;
    CHECK_THROWS_AS(meet(world, {light}), std::invalid_argument);
}
