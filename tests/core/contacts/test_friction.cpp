// Friction, stickiness and layers of matter that meets matter, against the laws of Coulomb.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/solids/collider.h>
#include <plait/measure/energy.h>

#include <numbers>
#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

// A Surface of vertices that are given later.
Surface rough(double standing, double sliding) {
    Surface surface;
    surface.thickness = 0.001;
    surface.staticFriction = standing;
    surface.dynamicFriction = sliding;
    return surface;
}

constexpr double g = 9.81, degree = std::numbers::pi / 180, skin = 0.001;

struct Incline {
    double mu = 0.5;
    double angle = 0;
    bool cube = true;  // else a point
    int passes = 64;   // with 16, a cube is not solved well enough to stay
};

// How far something slides down in each of the frames (m).
std::vector<double> slide(const Incline& p, int frames) {
    World world;
    const Range slope = addSlope(world, p.angle);
    const Vec<double> along{std::cos(p.angle), -std::sin(p.angle), 0}, up{-along.y, along.x, 0};
    const Range body = p.cube ? addCube(world, p.angle, 2 * skin) : addPoint(world, 2 * skin * up);
    world.act<Gravity>(GravityOptions{});
    Surface lower = rough(p.mu, p.mu), upper = lower;
    lower.vertices = slope;
    upper.vertices = body;
    meet(world, {lower, upper}, {.order = 5});
    Solver<float> solver(world, meeting(20, p.passes));
    const Vec<double> start = meanOf(solver.positions(), body);
    std::vector<double> course;
    for (int frame = 0; frame < frames; ++frame) {
        solver.frame();
        course.push_back(dot(meanOf(solver.positions(), body) - start, along));
    }
    return course;
}

double acceleration(double mu, double angle) {
    return g * (std::sin(angle) - mu * std::cos(angle));
}

// A point of 1 kg that lies on the level and starts at 4 m/s: what it loses in 0.25 s, over g t.
double measuredFriction(const Surface& floor, const Surface& matter) {
    World world;
    Surface lower = floor, upper = matter;
    lower.vertices = addSlope(world, 0);
    upper.vertices = addPoint(world, {0, 2 * skin, 0}, 1, {4, 0, 0});
    world.act<Gravity>(GravityOptions{});
    meet(world, {lower, upper});
    Solver<float> solver(world, meeting(20));
    advance(solver, 6);
    return (4 - solver.velocities().back().x) / (g * 0.25);
}

}  // namespace

// Steps of first order go n (n + 1) / 2 a h^2, as they do in the air.
TEST_CASE("friction: an incline holds a degree below its angle, and not a degree above",
          "[contacts][friction][FR5][FR6]") {
    for (const double mu : {0.3, 0.5})
        for (const bool cube : {false, true}) {
            const double limit = std::atan(mu);
            const std::string what = (cube ? "cube" : "point") + (", mu " + std::to_string(mu));
            const double creep = slide({mu, limit - degree, cube}, 24).back();
            CHECK(report(what + ", creep in 1 s, m", std::fabs(creep), 1e-5));
            for (const double off : {1.0, 5.0}) {
                const double angle = limit + off * degree, a = acceleration(mu, angle);
                const std::vector<double> x = slide({mu, angle, cube}, 24);
                const double n = 24 * 20, distance = 0.5 * a * (1 + 1 / n);
                CHECK(report(what + ", distance", std::fabs(x.back() / distance - 1), 0.01));
                const double speed = 24 * (x[23] - x[22]), mean = a * (1 - 0.5 / 24 + 0.5 / n);
                CHECK(report(what + ", speed at the end", std::fabs(speed / mean - 1), 0.01));
            }
        }
}

TEST_CASE("friction: below the threshold a cube stays for a minute, above it goes",
          "[contacts][friction][long][FR5]") {
    for (const double mu : {0.3, 0.5}) {
        const double creep = slide({mu, std::atan(0.95 * mu), true}, 60 * 24).back();
        CHECK(report("creep in 60 s, m", std::fabs(creep), 1e-3));
        const double angle = std::atan(1.05 * mu);
        const double x = slide({mu, angle, true}, 24).back();
        CHECK(report("acceleration", std::fabs(2 * x / acceleration(mu, angle) - 1), 0.1));
    }
}

// v^2 / 2 mu g on the way, which steps of first order shorten by v h / 2.
TEST_CASE("friction: what slides comes to rest where it should", "[contacts][friction][FR6]") {
    World world;
    const Range floor = addSlope(world, 0), point = addPoint(world, {0, 2 * skin, 0}, 1, {2, 0, 0});
    world.act<Gravity>(GravityOptions{});
    meet(world,
         {{.vertices = floor, .thickness = skin, .staticFriction = 0.4, .dynamicFriction = 0.4},
          {.vertices = point, .thickness = skin, .staticFriction = 0.4, .dynamicFriction = 0.4}});
    Solver<float> solver(world, meeting(40));
    advance(solver, 24);
    CHECK(report("distance", std::fabs(solver.positions().back().x / 0.509684 - 1), 0.01));
    CHECK(topSpeed(solver) < 1e-5);
}

// M 5.5.
TEST_CASE("friction: of a pair the mean, at most 1", "[contacts][friction][FR1][FR6]") {
    for (const auto& [a, b, pair] : {std::tuple{0.0, 1.0, 0.5},
                                     {0.0, 2.0, 1.0},
                                     {0.2, 0.6, 0.4},
                                     {3.0, 3.0, 1.0},
                                     {0.0, 0.0, 0.0}}) {
        const double mu = measuredFriction(rough(a, a), rough(b, b));
        CHECK(report("of " + std::to_string(a) + " and " + std::to_string(b), std::fabs(mu - pair),
                     0.01));
    }
    // What slides feels the dynamic one, however rough it is at rest.
    const Surface both = rough(0.9, 0.3);
    CHECK(report("static 0.9, dynamic 0.3", std::fabs(measuredFriction(both, both) - 0.3), 0.01));
}

TEST_CASE("friction: below zero it adds energy, and is warned of", "[contacts][friction][FR2]") {
    const Surface slick = rough(-0.2, -0.2);
    CHECK(report("of -0.2", std::fabs(measuredFriction(slick, slick) + 0.2), 0.01));
    World world;
    Surface surface = slick;
    surface.vertices = addPoint(world, {});
    meet(world, {surface}, {.name = "skin"});
    REQUIRE(world.warnings.size() == 2);
    CHECK(world.warnings[0].find("skin.staticFriction") != std::string::npos);
    CHECK(world.warnings[1].find("skin.dynamicFriction") != std::string::npos);
}

// A point below a ceiling that holds 2 N.
TEST_CASE("stickiness: holds its force, and tears above", "[contacts][friction][FR4]") {
    for (const auto& [mass, holds] : {std::pair{0.19, true}, {0.22, false}}) {
        World world;
        Surface ceiling, drop;
        ceiling.stickiness = 1;
        drop.stickiness = 3;
        ceiling.vertices = addSlope(world, 0);
        drop.vertices =
            addPoint(world, {0.3, -2 * skin, 0}, mass);  // not on the diagonal: one contact
        world.act<Gravity>(GravityOptions{});
        meet(world, {ceiling, drop});
        Solver<float> solver(world, meeting(20));
        advance(solver, 24);
        const double fallen = -2 * skin - solver.positions().back().y;
        if (holds) CHECK(report("sagged, m", std::fabs(fallen), 1e-4));
        if (!holds) CHECK(fallen > 4);
    }
}

// A point of 1 kg slides on a floor, or below a ceiling, that holds 30 N. Friction goes by what
// presses, which below a ceiling is nothing, and by all that sticks, however little of it is used.
TEST_CASE("stickiness: friction goes by what presses and by what sticks, and mixes neither",
          "[contacts][friction][strangers]") {
    constexpr double mu = 0.2, hold = 30;
    for (const bool solid : {false, true})
        for (const double side : {1.0, -1.0}) {
            World world;
            Surface matter = rough(mu, mu);
            matter.stickiness = hold;
            Surface wall = matter;
            if (!solid) wall.vertices = addSlope(world, 0);
            matter.vertices =
                addPoint(world, {0.3, side * (solid ? skin : 2 * skin), 0}, 1, {4, 0, 0});
            world.act<Gravity>(GravityOptions{});
            if (solid)
                collide(world,
                        {{.solid = Solid::plane(),
                          .frame = {.across = {side, 0, 0}, .up = {0, side, 0}},
                          .staticFriction = mu,
                          .dynamicFriction = mu,
                          .stickiness = hold}},
                        {matter});
            else
                meet(world, {wall, matter});
            Solver<double> solver(world, meeting(20));
            advance(solver, 6);
            const double lost = (4 - solver.velocities().back().x) / 0.25;  // m/s^2
            const double expected = mu * (side > 0 ? g + hold : hold);
            CHECK(report(
                std::string(solid ? "collider" : "surface") + (side > 0 ? ", floor" : ", ceiling"),
                std::fabs(lost / expected - 1), 0.01));
        }
}

// Two alike that meet head on, at rest afterwards unless one of them yields less.
TEST_CASE("layers: the lower one yields less, by the shock, whatever the difference",
          "[contacts][friction][LY2][LY3]") {
    for (const auto& [a, b, shock, ratio] : {std::tuple{0, 0, 2.0, 1.0},
                                             {0, 1, 2.0, 2.0},
                                             {0, 5, 2.0, 2.0},
                                             {1, 0, 2.0, 0.5},
                                             {0, 1, 1.0, 1.0},
                                             {-3, 1, 10.0, 10.0}}) {
        World world;
        Surface left, right;
        left.layer = a;
        right.layer = b;
        left.vertices = addPoint(world, {-0.1, 0, 0}, 1, {1, 0, 0});
        right.vertices = addPoint(world, {0.1, 0, 0}, 1, {-1, 0, 0});
        meet(world, {left, right}, {.layerShock = shock});
        Solver<double> solver(world, meeting(10));
        advance(solver, 12);
        const Points v = solver.velocities();
        CHECK(report("ratio of layers " + std::to_string(a) + " and " + std::to_string(b),
                     std::fabs((1 + v[1].x) / (1 - v[0].x) / ratio - 1), 1e-6));
        CHECK(std::fabs(v[0].x - v[1].x) < 1e-9);
    }
}

// However light what it carries, and however fast that comes.
TEST_CASE("friction: a lower layer is not moved by a higher one where the shock is great",
          "[contacts][friction][LY1]") {
    for (const int higher : {1, 4}) {
        World world;
        Surface lower, upper;
        upper.layer = higher;
        lower.vertices = addPoint(world, {0, 0, 0}, 1e-3);
        upper.vertices = addPoint(world, {0.1, 0, 0}, 1, {-1, 0, 0});
        meet(world, {lower, upper}, {.layerShock = 1e12});
        Solver<double> solver(world, meeting(10));
        advance(solver, 12);
        CHECK(report("speed that the lower one got, m/s", length(solver.velocities()[0]), 1e-8));
        CHECK(report("and the higher one kept, m/s", std::fabs(solver.velocities()[1].x), 1e-8));
    }
}

// Of Vellum: one factor for what meets its own surface, one for what meets others.
TEST_CASE("friction: factors take it away among its own, or from others",
          "[contacts][friction][FR7]") {
    const auto measured = [](bool own, double self, double other) {
        World world;
        const Range lower = addSlope(world, 0);
        const Range upper = addPoint(world, {0, 2 * skin, 0}, 1, {4, 0, 0});
        world.act<Gravity>(GravityOptions{});
        std::vector<Surface> surfaces(own ? 1 : 2, rough(0.4, 0.4));
        surfaces[0].vertices = own ? Range{lower.first, upper.last} : lower;
        if (!own) surfaces[1].vertices = upper;
        meet(world, surfaces, {.selfFriction = self, .otherFriction = other});
        Solver<float> solver(world, meeting(20));
        advance(solver, 6);
        CHECK(solver.positions().back().y == Approx(2 * skin).margin(1e-5));
        return (4 - solver.velocities().back().x) / (g * 0.25);
    };
    for (const bool own : {true, false})
        for (const double part : {0.0, 0.5, 1.0, 2.0}) {
            CHECK(report("friction of its class, off",
                         std::fabs(measured(own, own ? part : 1, own ? 1 : part) - 0.4 * part),
                         0.01));
            CHECK(report("friction of the other class, off",
                         std::fabs(measured(own, own ? 1 : part, own ? part : 1) - 0.4), 0.01));
        }
}
