// Matter that meets colliders, against the laws of Coulomb, of impact and of falling.
#include "collider_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, degree = pi / 180;

// How far a point slides down in each of the frames (m), on a plane or along a long box.
std::vector<double> slide(const Solid& solid, double mu, double angle, int frames) {
    World world;
    const Frame frame = turnedAbout({0, 0, 1}, -angle);
    const Vec<double> along = frame.across;
    const double top = solid.half.y;
    const Range point = addPoint(world, (top + skin) * frame.up);
    world.act<Gravity>(GravityOptions{});
    Collider slope = hard(solid, mu);
    slope.frame = frame;
    collide(world, {slope}, {rough(point, mu)});
    Solver<float> solver(world, meeting(20));
    std::vector<double> course;
    const Vec<double> start = solver.positions()[0];
    for (int i = 0; i < frames; ++i) {
        solver.frame();
        course.push_back(dot(solver.positions()[0] - start, along));
    }
    return course;
}

}  // namespace

// Steps of first order go n (n + 1) / 2 a h^2, as they do in the air.
TEST_CASE("colliders: an incline holds a degree below its angle, and not a degree above",
          "[colliders][FR5]") {
    for (const double mu : {0.3, 0.5})
        for (const bool box : {false, true}) {
            const Solid solid = box ? Solid::box(20, 0.2, 1) : Solid::plane();
            const double limit = std::atan(mu);
            const std::string what = (box ? "box" : "plane") + (", mu " + std::to_string(mu));
            const double creep = slide(solid, mu, limit - degree, 24).back();
            CHECK(report(what + ", creep in 1 s, m", std::fabs(creep), 1e-6));
            for (const double off : {1.0, 5.0}) {
                const double angle = limit + off * degree;
                const double a = g * (std::sin(angle) - mu * std::cos(angle)), n = 24 * 20;
                const double x = slide(solid, mu, angle, 24).back();
                CHECK(report(what + ", acceleration", std::fabs(x / (0.5 * a * (1 + 1 / n)) - 1),
                             0.01));
            }
        }
}

// v^2 / 2 mu g, and the mean friction of a pair, at most 1.
TEST_CASE("colliders: what slides comes to rest where it should", "[colliders][CC22]") {
    for (const auto& [a, b, pair] : {std::tuple{0.4, 0.4, 0.4}, {0.0, 1.0, 0.5}, {0.5, 9.0, 1.0}}) {
        World world;
        const Range point = addPoint(world, {0, skin, 0}, 1, {2, 0, 0});
        world.act<Gravity>(GravityOptions{});
        collide(world, {hard(Solid::plane(), a)}, {rough(point, b)});
        Solver<float> solver(world, meeting(100));
        advance(solver, 24);
        const double distance = 4 / (2 * pair * g);
        CHECK(report("distance, mu " + std::to_string(pair),
                     std::fabs(solver.positions()[0].x / distance - 1), 0.01));
        CHECK(topSpeed(solver) < 1e-6);
        CHECK(report("height over its thickness", std::fabs(solver.positions()[0].y / skin - 1),
                     1e-3));
    }
}

TEST_CASE("colliders: sliding friction, friction below zero, and stickiness",
          "[colliders][FR6][FR2][FR4]") {
    const auto lost = [](double standing, double sliding) {
        World world;
        const Range point = addPoint(world, {0, skin, 0}, 1, {4, 0, 0});
        world.act<Gravity>(GravityOptions{});
        Collider floor = hard(Solid::plane(), standing);
        floor.dynamicFriction = sliding;
        Surface surface = rough(point, standing);
        surface.dynamicFriction = sliding;
        collide(world, {floor}, {surface});
        if (sliding < 0) CHECK(world.warnings.size() == 4);
        Solver<float> solver(world, meeting(20));
        advance(solver, 6);
        return (4 - solver.velocities()[0].x) / (g * 0.25);
    };
    CHECK(report("static 0.9, dynamic 0.3", std::fabs(lost(0.9, 0.3) - 0.3), 1e-3));
    CHECK(report("of -0.2", std::fabs(lost(-0.2, -0.2) + 0.2), 1e-3));
    for (const auto& [mass, holds] : {std::pair{0.19, true}, {0.22, false}}) {
        World world;
        const Range point = addPoint(world, {0, -skin, 0}, mass);
        world.act<Gravity>(GravityOptions{});
        Collider ceiling = hard(Solid::plane(), 0);
        ceiling.frame = turnedAbout({0, 0, 1}, pi);
        ceiling.stickiness = 3;
        Surface drop = rough(point, 0);
        drop.stickiness = 1;
        collide(world, {ceiling}, {drop});
        Solver<float> solver(world, meeting(20));
        advance(solver, 24);
        const double fallen = -skin - solver.positions()[0].y;
        if (holds) CHECK(report("sagged, m", std::fabs(fallen), 1e-6));
        if (!holds) CHECK(fallen > 4);
    }
}

namespace {

struct Drop {
    std::vector<double> heights;  // m, after each bounce
    double rest = 0;              // s, when it was last above 1 mm
    double path = 0;              // m, up and down
};

// A point let go 1 m above where it touches what is below it, tilted by nothing.
Drop drop(const Solid& solid, double e, double seconds, Integrator integrator) {
    World world;
    const double ground = solid.half.y + solid.radius + 0.05;
    const Range ball = addPoint(world, {0, 1 + ground, 0});
    world.act<Gravity>(GravityOptions{});
    Surface surface = rough(ball, 0, e);
    surface.radii = {0.05};
    collide(world, {hard(solid, 0, e)}, {surface});
    Solver<float> solver(world, stepping(1200, integrator));
    Drop found;
    double last = 1, top = 0;
    bool falling = true;
    for (int i = 1; i <= 1200 * seconds; ++i) {
        solver.frame();
        const double y = solver.state().position(0).y - ground;
        found.path += std::fabs(y - last);
        if (y > 1e-3) found.rest = i / 1200.0;
        const bool falls = solver.velocities()[0].y < 0;
        if (falling && !falls) top = 0;
        top = std::max(top, y);
        if (falls && !falling) found.heights.push_back(top);
        falling = falls;
        last = y;
    }
    return found;
}

}  // namespace

// Total time t0 (1 + e) / (1 - e), path h (1 + e^2) / (1 - e^2) (validation A10).
TEST_CASE("colliders: a ball bounces as high and as long as it should, and rests", "[colliders]") {
    const double fall = std::sqrt(2 / g);
    const std::vector<Solid> grounds{Solid::plane(), Solid::box(1, 0.02, 1), Solid::sphere(0.3)};
    for (const double e : {0.3, 0.5, 0.7, 0.8, 0.9}) {
        const Solid& solid = grounds[e < 0.6 ? 1 : e < 0.85 ? 0 : 2];
        const Drop ball = drop(solid, e, 1.1 * fall * (1 + e) / (1 - e), Integrator::first);
        const std::string what = "e " + std::to_string(e);
        CHECK(report(what + ", time", std::fabs(ball.rest / (fall * (1 + e) / (1 - e)) - 1), 0.05));
        CHECK(
            report(what + ", path", std::fabs(ball.path / ((1 + e * e) / (1 - e * e)) - 1), 0.05));
        double height = 1, worst = 0;
        REQUIRE(ball.heights.size() >= 2);
        for (std::size_t i = 0; i < 2; ++i) {
            height *= e * e;
            worst = std::max(worst, std::fabs(ball.heights[i] / height - 1));
        }
        CHECK(report(what + ", heights of the first two", worst, 5e-3));
    }
    const Drop elastic = drop(Solid::plane(), 1, 20, Integrator::first);
    double worst = 0;
    REQUIRE(elastic.heights.size() > 15);
    for (const double height : elastic.heights) worst = std::max(worst, std::fabs(height - 1));
    CHECK(report("elastic, height in 20 s, m", worst, 1e-3));
    const Drop second = drop(Solid::plane(), 0.8, 3, Integrator::bdf2);
    CHECK(report("BDF2, first bounce", std::fabs(second.heights[0] / 0.64 - 1), 0.02));
}

// (0.9, 0.3) bounce at 0.6 and rub at what is the mean of 0.1 and 0.5, whoever has which.
TEST_CASE("colliders: of what bounces the mean of the two counts", "[colliders][strangers]") {
    for (const auto& [ours, theirs] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {0.9, 0.3}, {0.3, 0.9}}) {
        World world;
        const Range point = addPoint(world, {0, 0.1, 0}, 1, {2, -1, 0});
        collide(world, {hard(Solid::plane(), 0.1, theirs)}, {rough(point, 0.5, ours)});
        Solver<double> solver(world, meeting(10));
        advance(solver, 6);
        const Vec<double> v = solver.velocities()[0];
        const double e = 0.5 * (ours + theirs);
        CHECK(report("speed away, m/s", std::fabs(v.y - e), 1e-9));
        CHECK(report("speed along, m/s", std::fabs(v.x - (2 - 0.3 * (1 + e))), 1e-9));
    }
}

// mu g = omega^2 r: what turns with a table stays on it up to there.
TEST_CASE("colliders: a turntable carries what it can hold", "[colliders]") {
    constexpr double mu = 0.3, r = 0.5, radius = 0.05;
    for (const auto& [part, stays] : {std::pair{0.97, true}, {1.03, false}}) {
        const double omega = std::sqrt(part * mu * g / r);
        World world;
        const Range ball = addPoint(world, {r, radius, 0}, 1, {0, 0, -omega * r});
        world.act<Gravity>(GravityOptions{});
        Collider table = hard(Solid::box(4, 0.1, 4), mu);
        table.motion = [omega](double t) {
            return turnedAbout({0, 1, 0}, omega * t, {0, -0.05, 0});
        };
        Surface surface = rough(ball, mu);
        surface.thickness = radius;
        collide(world, {table}, {surface});
        Solver<float> solver(world, meeting(40));
        advance(solver, 72);
        const Vec<double> p = solver.positions()[0];
        const Placement now(table.motion(3), "table");
        const double slipped = length(now.own(p) - Vec<double>{r, 0.05 + radius, 0});
        if (stays) CHECK(report("slipped in 3 s, m", slipped, 1e-4));
        if (!stays) CHECK(slipped > 0.2);
    }
}

// A belt drags what lies on it by mu g until it has the belt's speed.
TEST_CASE("colliders: what moves along drags by friction", "[colliders]") {
    World world;
    const Range point = addPoint(world, {0, 0.1 + skin, 0});
    world.act<Gravity>(GravityOptions{});
    Collider belt = hard(Solid::box(20, 0.2, 1), 0.3);
    belt.motion = [](double t) { return Frame{.origin = {2 * t, 0, 0}}; };
    collide(world, {belt}, {rough(point, 0.3)});
    Solver<float> solver(world, meeting(20));
    advance(solver, 12);
    CHECK(report("speed after 0.5 s", std::fabs(solver.velocities()[0].x / (0.15 * g) - 1), 1e-3));
    advance(solver, 12);
    CHECK(report("speed after 1 s, m/s", std::fabs(solver.velocities()[0].x - 2), 1e-5));
}

// (1 + e) V, on a flat side, on a round one, and where a bar turns.
TEST_CASE("colliders: a moving collider launches a point", "[colliders][CC14]") {
    for (const double e : {0.0, 0.5, 1.0})
        for (const int substeps : {1, 10})
            for (const auto& [name, solid] : solids) {
                World world;
                const Range point = addPoint(world, {0.7, 0, 0});
                Collider bat = hard(solid, 0, e);
                bat.motion = [](double t) { return Frame{.origin = {3 * t, 0, 0}}; };
                collide(world, {bat}, {rough(point, 0, e)});
                Solver<float> solver(world, meeting(substeps));
                advance(solver, 12);
                const Vec<double> v = solver.velocities()[0];
                CHECK(report(name + ", e " + std::to_string(e),
                             length(v - Vec<double>{3 * (1 + e), 0, 0}), 1e-4));
            }
    // A bar of 1 m turns at 6 rad/s about its middle and meets a point 0.4 m out: that has the
    // speed of the bar where they are, and twice that if it bounces.
    for (const double e : {0.0, 1.0}) {
        World world;
        const Range point = addPoint(world, {0.4, 0, 0});
        Collider bar = hard(Solid::box(1, 0.02, 0.1), 0, e);
        bar.motion = [](double t) { return turnedAbout({0, 0, 1}, 6 * t - 0.3); };
        collide(world, {bar}, {rough(point, 0, e)});
        Solver<float> solver(world, stepping(2400));
        while (topSpeed(solver) == 0 && solver.time() < 1) advance(solver, 1);
        advance(solver, 1);
        const Placement now(bar.motion(solver.time()), "bar");
        const double speed = dot(solver.velocities()[0], now.y);
        const double expected = 6 * (1 + e) * now.own(solver.positions()[0]).x;
        CHECK(report("bar, e " + std::to_string(e), std::fabs(speed / expected - 1), 0.01));
    }
}
