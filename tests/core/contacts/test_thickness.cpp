// What thickness and the kind of what meets are worth.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/solids/collider.h>

#include <string>

using namespace plait;
using namespace plait::test;

// Looked for where a substep ends, a bullet is seen only if it stands within both skins then: a
// thicker sheet needs fewer substeps. On its way it is seen in one.
TEST_CASE("thickness: where paths are not asked for, it saves substeps", "[contacts][CC11]") {
    constexpr double speed = 30;
    const auto caught = [](double thickness, int substeps, Detection detection) {
        for (int i = 0; i < 16; ++i) {  // wherever in a substep it comes
            World world;
            const Range sheet = addSlope(world, 0, 2);
            const double step = speed / 24 / substeps;
            const Range bullet =
                addPoint(world, {0.3, 0.7 + i * step / 16, 0.2}, 1, {0, -speed, 0});
            meet(
                world,
                {{.vertices = sheet, .thickness = thickness}, {.vertices = bullet, .thickness = 0}},
                {.detection = detection});
            Solver<double> solver(world, meeting(substeps, 2));
            advance(solver, 4);
            if (solver.positions()[bullet.first].y < 0) return false;
        }
        return true;
    };
    const auto least = [&](double thickness) {
        int substeps = 1;
        while (!caught(thickness, substeps, Detection::end)) ++substeps;
        return substeps;
    };
    int last = 1 << 20;
    for (const double thickness : {0.02, 0.05, 0.1, 0.2}) {
        const int substeps = least(thickness);
        note("thickness " + std::to_string(thickness) + " m, substeps", substeps);
        CHECK(substeps < last);
        // The skin on the side it comes from, all of it.
        CHECK(substeps <= std::ceil(speed / 24 / thickness) + 1);
        CHECK(substeps >= std::floor(speed / 24 / (2 * thickness)));
        CHECK(caught(thickness, 1, Detection::path));
        last = substeps;
    }
}

// With neither stretch nor bending, and met as points, cloth is its particles, to the bit.
TEST_CASE("thickness: cloth without links that meets as points is particles", "[contacts][AR9]") {
    const auto fall = [](bool cloth) {
        World world;
        Shape shape =
            grid({.columns = 7, .rows = 7}, {.origin = {0, 0.4, 0}, .up = {0, 0.6, -0.8}});
        const double mass = 0.3;
        if (!cloth) shape.complex = SimplicialComplex(49);
        const Range all = world.add(shape);
        world.mass.assign(49, mass);
        for (int v = 0; v < 49; ++v)
            world.velocity[static_cast<std::size_t>(v)] = {v % 3 - 1.0, -0.5, (v % 5 - 2) * 0.4};
        world.act<Gravity>(GravityOptions{});
        Surface surface{.vertices = all, .thickness = 0.04};
        if (cloth) surface.self = Self::vertex;
        meet(world, {surface}, {.margin = 0.02});
        collide(world, {Collider{.solid = Solid::plane()}}, {surface}, {.name = "floor"});
        Solver<float> solver(world, meeting(10));
        advance(solver, 24);
        REQUIRE(static_cast<const ContactSet<float>&>(solver.set(0)).counts().contacts > 0);
        return std::pair{solver.positions(), solver.velocities()};
    };
    const auto particles = fall(false), cloth = fall(true);
    for (std::size_t v = 0; v < 49; ++v) {
        CHECK(particles.first[v] == cloth.first[v]);
        CHECK(particles.second[v] == cloth.second[v]);
    }
}

// M 5.5: friction of 1 may still slide, and does so less with substeps.
TEST_CASE("thickness: what rests by friction creeps, the less the more substeps",
          "[contacts][friction][FR3]") {
    const double angle = std::atan(0.95);
    const auto creep = [angle](int substeps) {
        World world;
        const Range slope = addSlope(world, angle), cube = addCube(world, angle, 0.002);
        world.act<Gravity>(GravityOptions{});
        Surface lower{
            .vertices = slope, .thickness = 0.001, .staticFriction = 1, .dynamicFriction = 1};
        Surface upper = lower;
        upper.vertices = cube;
        meet(world, {lower, upper}, {.order = 5});
        Solver<float> solver(world, meeting(substeps, 8));
        advance(solver, 6);  // it settles
        const Vec<double> along{std::cos(angle), -std::sin(angle), 0};
        const double start = dot(meanOf(solver.positions(), cube), along);
        advance(solver, 24);
        return dot(meanOf(solver.positions(), cube), along) - start;
    };
    double last = 1e9;
    for (const int substeps : {2, 8, 32, 128}) {
        const double way = std::fabs(creep(substeps));
        note(std::to_string(substeps) + " substeps, creep in a second, m", way);
        CHECK(way < last);
        last = way;
    }
    CHECK(last < 1e-3);
}
