// What is inside a closed surface is moved out of it (M 4.4).
#include "closed_meshes.h"
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/contacts/trouble/push_out_set.h>
#include <plait/measure/surfaces/penetration.h>

using namespace plait;
using namespace plait::test;

namespace {

template <class Real>
const PushOutCounts& pushesOf(const Solver<Real>& solver, const World& world) {
    const int last = static_cast<int>(world.sets.size()) - 1;
    return static_cast<const PushOutSet<Real>&>(solver.set(last)).counts();
}

Range addPoints(World& world, const Points& at) {
    return world.add({SimplicialComplex(static_cast<int>(at.size())), at});
}

int insideOf(const World& world, Range mesh, Range points, const Points& x) {
    return static_cast<int>(
        findInside(std::span(x).subspan(points.first, points.size()), x, trianglesIn(world, mesh))
            .size());
}

// The height (m) of a point over the middle of a face of a cube, after each substep.
std::vector<double> heights(double start, const PushOutOptions& options, bool falls, int substeps) {
    World world;
    const Range box = pinned(world, world.add(cube(1)));
    const Range point = addPoint(world, {0.1, 0.5 + start, 0.2});
    if (falls) world.act<Gravity>(GravityOptions{});
    pushOut(world, box, {point}, options);
    Solver<double> solver(world, stepping(240));
    std::vector<double> found;
    for (int i = 0; i < substeps; ++i) {
        solver.frame();
        found.push_back(solver.positions()[point.first].y - 0.5);
    }
    return found;
}

}  // namespace

// The exact test knows nothing of normals. Points near faces, edges and corners, on both sides.
TEST_CASE("push-out: a closed surface empties in a step, and nothing else is moved",
          "[contacts][push][FH1]") {
    for (const bool round : {false, true}) {
        World world;
        const Shape shape = round ? sphere({.subdivisions = 1, .radius = 0.6}) : cube(1);
        const Range mesh = pinned(world, world.add(shape));
        Random random(5);
        Points at;
        for (int i = 0; i < 600; ++i) at.push_back(random.point(0.8));
        for (int i = 0; i < 300; ++i)
            at.push_back(shape.positions[i % mesh.size()] + random.point(0.02));
        const Range points = addPoints(world, at);
        pushOut(world, mesh, {points}, {.radius = 1, .thickness = 1e-4});
        Solver<double> solver(world, stepping(240));
        const int before = insideOf(world, mesh, points, world.start);
        REQUIRE(before > 100);
        solver.frame();
        const Points x = solver.positions();
        CHECK(insideOf(world, mesh, points, x) == 0);
        int moved = 0;
        for (int v = points.first; v < points.last; ++v) moved += x[v] != world.start[v];
        note("points inside", before);
        CHECK(moved >= before);
        CHECK(moved <= before + 5);  // nearer than 0.1 mm
        CHECK(pushesOf(solver, world).pushed == moved);
        solver.frame();
        CHECK(report("then it rests, m/s", topSpeed(solver), 1e-9));
    }
}

// What is left of the way is 1 - strength of it in each step.
TEST_CASE("push-out: a part of the way in each step", "[contacts][push][FH1]") {
    for (const double strength : {0.1, 0.5, 1.0}) {
        const auto found =
            heights(-0.2, {.strength = strength, .radius = 0.5, .thickness = 0.01}, false, 20);
        double left = 0.21, worst = 0;
        for (const double height : found) {
            left *= 1 - strength;
            worst = std::max(worst, std::fabs(0.01 - height - left));
        }
        CHECK(report("strength " + std::to_string(strength) + ", m", worst, 1e-12));
    }
}

// The egg in a pan: 0.21 m below, by 1.5 times that to 0.105 m above, from where it falls.
TEST_CASE("push-out: above 1 it throws up what falls back", "[contacts][push][FH1]") {
    const auto course = [](double strength) {
        std::vector<double> found =
            heights(-0.2, {.strength = strength, .radius = 0.5, .thickness = 0.01}, true, 120);
        for (double& height : found) height -= 0.01;  // above where it touches
        return found;
    };
    const auto gentle = course(1), rough = course(1.5);
    double off = 0;
    for (const double height : gentle) off = std::max(off, std::fabs(height));
    CHECK(report("of 1, off where it touches, m", off, 1e-12));
    // It falls, and where it is below, half of that above, at rest.
    const double g = 9.81, h = 1.0 / 240;
    double y = -0.21, v = 0, worst = 0;
    int throws = 0;
    for (const double height : rough) {
        y += h * (v -= g * h);
        if (y < 0) y *= -0.5, v = 0, ++throws;
        worst = std::max(worst, std::fabs(height - y));
    }
    note("of 1.5, first throw, m", rough[0]);
    note("throws in half a second", throws);
    CHECK(rough[0] > 0.1);
    CHECK(throws > 10);
    CHECK(report("of 1.5, against theory, m", worst, 1e-12));
}

TEST_CASE("push-out: reaches down as far as its radius, and costs by it", "[contacts][push][FH2]") {
    CHECK(heights(-0.1, {.radius = 0.11}, false, 1)[0] == Approx(0).margin(1e-12));
    CHECK(heights(-0.1, {.radius = 0.09}, false, 1)[0] == Approx(-0.1));
    const auto pairs = [](double radius) {
        World world;
        const Range mesh = pinned(world, world.add(sphere({.subdivisions = 3, .radius = 0.5})));
        Random random(6);
        Points at;
        for (int i = 0; i < 200; ++i) at.push_back(random.point(0.7));
        const Range points = addPoints(world, at);
        pushOut(world, mesh, {points}, {.radius = radius});
        Solver<double> solver(world, stepping(240));
        solver.frame();
        return static_cast<double>(pushesOf(solver, world).pairs);
    };
    const double narrow = pairs(0.05), wide = pairs(0.4);
    note("pairs of 5 cm", narrow);
    note("pairs of 40 cm", wide);
    CHECK(wide > 10 * narrow);
}

namespace {

// How many vertices of a ball of cloth wholly inside a cube are inside after a second.
int left(bool pushes, bool contacts, bool trapped) {
    World world;
    const Range box = pinned(world, world.add(cube(1)));
    const Range ball =
        world.add(sphere({.subdivisions = 1, .radius = 0.1}, {.origin = {0.05, 0.3, -0.02}}),
                  {.density = 0.2});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, ball), world.rest),
                    {.name = "links"});
    if (contacts)
        meet(world,
             {{.vertices = box, .thickness = 0.005, .self = Self::none},
              {.vertices = ball, .thickness = 0.005}},
             {.order = 1, .trapped = trapped});
    if (pushes) pushOut(world, box, {ball}, {.strength = 0.2, .radius = 0.5, .thickness = 0.01});
    Solver<float> solver(world, meeting(8));
    advance(solver, 24);
    return insideOf(world, box, ball, solver.positions());
}

}  // namespace

TEST_CASE("push-out: frees a ball that is wholly inside; to leave out what is trapped does not",
          "[contacts][push]") {
    CHECK(left(true, false, false) == 0);
    CHECK(left(true, true, true) == 0);
    CHECK(left(false, true, true) == 42);
    note("with contacts that leave nothing out, of 42", left(true, true, false));
}

TEST_CASE("push-out: what has no inside is refused", "[contacts][push]") {
    World world;
    const Range sheet = world.add(grid({}));
    const Range point = addPoint(world, {});
    CHECK_THROWS_AS(pushOut(world, sheet, {point}), std::invalid_argument);
    const Range box = world.add(cube(1));
    CHECK_THROWS_AS(pushOut(world, box, {point}, {.strength = -1}), std::invalid_argument);
    CHECK_THROWS_AS(pushOut(world, box, {point}, {.radius = NAN}), std::invalid_argument);
    CHECK_THROWS_AS(pushOut(world, box, {{0, 100}}), std::invalid_argument);
    pushOut(world, box, {point});
}
