// Restitution: bounces against the laws of impact and of falling.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/energy.h>

#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, radius = 0.05;

Surface bouncy(Range vertices, double restitution) {
    Surface surface;
    surface.vertices = vertices;
    surface.thickness = radius;
    surface.staticFriction = surface.dynamicFriction = 0;
    surface.restitution = restitution;
    return surface;
}

// A ball let go 1 m above where it touches the floor.
struct Drop {
    std::vector<double> heights;  // m, after each bounce
    double rest = 0;              // s, when it was last above 1 mm
    double path = 0;              // m, up and down
    long bounces = 0;
};

Drop drop(double restitution, double seconds, Integrator integrator = Integrator::first) {
    World world;
    const Range floor = addSlope(world, 0), ball = addPoint(world, {0.3, 1 + 2 * radius, 0});
    world.act<Gravity>(GravityOptions{});
    meet(world, {bouncy(floor, restitution), bouncy(ball, restitution)});
    SolverOptions options = stepping(1200, integrator);
    Solver<float> solver(world, options);
    Drop found;
    double last = 1, top = 0;
    for (int i = 1; i <= 1200 * seconds; ++i) {
        solver.frame();
        const double y = solver.state().position(ball.first).y - 2 * radius;
        const long bounces = countsOf(solver, world).bounces;
        if (bounces > found.bounces && found.bounces > 0) found.heights.push_back(top);
        if (bounces > found.bounces) top = 0;
        found.bounces = bounces;
        found.path += std::fabs(y - last);
        if (y > 1e-3) found.rest = i / 1200.0;
        top = std::max(top, y);
        last = y;
    }
    return found;
}

}  // namespace

// What rests comes to approach by 2 g h, and that must not bounce; where nothing pulls, nothing
// does so, and the slowest bounces. At 240 steps a second 2 g h is 0.08 m/s on earth.
TEST_CASE("impacts: how slow is too slow to bounce is told by the world's gravity", "[impacts]") {
    for (const double pull : {0.0, g}) {
        World world;
        const Range floor = addSlope(world, 0),
                    ball = addPoint(world, {0.3, 2 * radius + 1e-3, 0}, 1, {0, -0.05, 0});
        world.act<Gravity>(GravityOptions{.acceleration = {0, -pull, 0}, .ignore = {ball}});
        meet(world, {bouncy(floor, 0.5), bouncy(ball, 0.5)});
        Solver<double> solver(world, stepping(240));
        for (int i = 0; i < 20; ++i) solver.frame();
        const double speed = solver.velocities()[ball.first].y;
        if (pull == 0)
            CHECK(report("0.05 m/s without gravity, e", std::fabs(speed / 0.025 - 1), 1e-9));
        else
            CHECK(std::fabs(speed) < 1e-9);
    }
}

// Total time t0 (1 + e) / (1 - e), path h (1 + e^2) / (1 - e^2) (validation A10); both without what
// is below 1 mm, or too slow to bounce. The height of the third bounce at e = 0.3 is 0.7 mm.
TEST_CASE("impacts: a ball bounces as high and as long as it should, and rests", "[impacts]") {
    const double fall = std::sqrt(2 / g);
    for (const double e : {0.3, 0.5, 0.7, 0.8, 0.9}) {
        const Drop ball = drop(e, 1.1 * fall * (1 + e) / (1 - e));
        const std::string what = "e " + std::to_string(e);
        CHECK(report(what + ", time", std::fabs(ball.rest / (fall * (1 + e) / (1 - e)) - 1), 0.05));
        CHECK(
            report(what + ", path", std::fabs(ball.path / ((1 + e * e) / (1 - e * e)) - 1), 0.05));
        double height = 1, worst = 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(3, ball.heights.size()); ++i) {
            height *= e * e;
            worst = std::max(worst, std::fabs(ball.heights[i] / height - 1));
        }
        CHECK(report(what + ", heights of the first three", worst, 2e-3));
    }
}

// S 7: stepped from event to event it would never get past 8.6 s.
TEST_CASE("impacts: ever faster bounces end", "[impacts][long][IN26]") {
    for (const double e : {0.9, 0.99}) {
        const Drop ball = drop(e, 100);
        note("bounces in 100 s", static_cast<double>(ball.bounces));
        CHECK(ball.bounces < 1000);
    }
}

TEST_CASE("impacts: an elastic ball keeps its height", "[impacts]") {
    const Drop ball = drop(1, 20);
    REQUIRE(ball.heights.size() > 15);
    double worst = 0;
    for (const double height : ball.heights) worst = std::max(worst, std::fabs(height - 1));
    CHECK(report("height, m", worst, 1e-4));
}

TEST_CASE("impacts: BDF2 bounces alike", "[impacts]") {
    const Drop ball = drop(0.8, 3, Integrator::bdf2);
    REQUIRE(ball.heights.size() >= 2);
    CHECK(report("first bounce", std::fabs(ball.heights[0] / 0.64 - 1), 0.02));
    CHECK(report("second bounce", std::fabs(ball.heights[1] / 0.4096 - 1), 0.02));
}

// ((m1 - e m2) v1 + m2 (1 + e) v2) / (m1 + m2)
TEST_CASE("impacts: on a line", "[impacts][CC12][CC27]") {
    double worst = 0;
    for (const double e : {0.0, 0.25, 0.5, 1.0})
        for (const double m : {0.01, 0.5, 1.0, 2.0, 100.0}) {
            World world;
            const Range a = addPoint(world, {-0.3, 0, 0}, 1, {2, 0, 0});
            const Range b = addPoint(world, {0.3, 0, 0}, m, {-1, 0, 0});
            meet(world, {bouncy(a, e), bouncy(b, e)});
            Solver<float> solver(world, meeting(10));
            advance(solver, 6);
            const Points v = solver.velocities();
            const double left = ((1 - e * m) * 2 - m * (1 + e)) / (1 + m);
            const double right = ((m - e) * -1 + (1 + e) * 2) / (1 + m);
            worst = std::max({worst, std::fabs(v[0].x - left), std::fabs(v[1].x - right)});
        }
    CHECK(report("velocity, m/s", worst, 1e-5));
}

TEST_CASE("impacts: of two that bounce differently the mean counts", "[impacts][strangers]") {
    for (const auto& [left, right] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {0.9, 0.3}}) {
        World world;
        const Range a = addPoint(world, {-0.3, 0, 0}, 1, {1, 0, 0});
        const Range b = addPoint(world, {0.3, 0, 0}, 1, {-1, 0, 0});
        meet(world, {bouncy(a, left), bouncy(b, right)});
        Solver<double> solver(world, meeting(10));
        advance(solver, 12);
        const double apart = solver.velocities()[1].x - solver.velocities()[0].x;
        CHECK(report("speed apart, m/s", std::fabs(apart - (left + right)), 1e-9));
    }
}

// n in, n out: what energy is in the wrong balls.
TEST_CASE("impacts: Newton's cradle", "[impacts]") {
    for (int n = 1; n < 5; ++n) {
        World world;
        std::vector<Surface> balls;
        for (int i = 0; i < 5; ++i) {
            const double x = 2 * radius * i - (i < n ? 0.3 : 0.0);
            balls.push_back(bouncy(addPoint(world, {x, 0, 0}, 1, {i < n ? 1.0 : 0.0, 0, 0}), 1));
        }
        meet(world, balls);
        Solver<float> solver(world, meeting(10));
        advance(solver, 24);
        double wrong = 0;
        const Points v = solver.velocities();
        for (int i = 0; i < 5; ++i)
            if (i < 5 - n) wrong += dot(v[i], v[i]);
        CHECK(report(std::to_string(n) + " balls in, energy in the wrong ones", wrong / n, 1e-6));
        for (int i = 5 - n; i < 5; ++i) CHECK(std::fabs(v[i].x - 1) < 1e-4);
    }
}

namespace {

// The same on a line, stepped from event to event.
void stepByEvents(std::array<double, 3>& x, std::array<double, 3>& v,
                  const std::array<double, 3>& mass, double e, std::vector<int>& order) {
    for (double left = 1; order.size() < 50;) {
        int pair = -1;
        double soonest = left;
        for (int i = 0; i < 2; ++i) {
            const double closing = v[i] - v[i + 1], gap = x[i + 1] - x[i] - 2 * radius;
            const double t = std::max(gap, 0.0) / closing;
            if (closing <= 1e-12 || t >= soonest) continue;
            soonest = t;
            pair = i;
        }
        for (int i = 0; i < 3; ++i) x[i] += soonest * v[i];
        left -= soonest;
        if (pair < 0) return;
        order.push_back(pair);
        const double push =
            (1 + e) * (v[pair] - v[pair + 1]) / (1 / mass[pair] + 1 / mass[pair + 1]);
        v[pair] -= push / mass[pair];
        v[pair + 1] += push / mass[pair + 1];
    }
}

}  // namespace

// S figure 20.
TEST_CASE("impacts: three particles meet in their order within a step", "[impacts][CC13][FX34]") {
    Random random(20);
    int most = 0;
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const double e = random.uniform(0.7, 1);
        std::array<double, 3> x{0, random.uniform(0.11, 0.3), 0}, v{}, mass{};
        x[2] = x[1] + random.uniform(0.11, 0.3);
        for (int i = 0; i < 3; ++i) {
            v[i] = random.uniform(-0.2, 0.2) + 0.5 * (1 - i);
            mass[i] = random.uniform(0.1, 3);
        }
        std::vector<double> inverse;
        std::vector<Path> paths;
        for (int i = 0; i < 3; ++i) {
            inverse.push_back(1 / mass[i]);
            paths.push_back({{x[i], 0, 0}, {x[i] + v[i], 0, 0}});
        }
        std::vector<Bounce> bounces;
        for (const auto& [a, b] : {std::pair{1, 2}, {0, 2}, {0, 1}})
            bounces.push_back({{{a, b, b, b}, 1, 1}, 2 * radius, e, 0});
        std::vector<Path> just = paths, fewer = paths;
        const int count = bounce(bounces, inverse, paths, 1e-12, 50).count;
        // What would go on is told, and what just ends is not.
        CHECK_FALSE(bounce(bounces, inverse, just, 1e-12, count).cut);
        if (count > 0) CHECK(bounce(bounces, inverse, fewer, 1e-12, count - 1).cut);
        std::vector<int> order;
        stepByEvents(x, v, mass, e, order);
        REQUIRE(count == static_cast<int>(order.size()));
        most = std::max(most, count);
        for (int i = 0; i < 3; ++i)
            worst = std::max({worst, std::fabs(paths[i].end.x - x[i]),
                              std::fabs(paths[i].end.x - paths[i].start.x - v[i])});
    }
    CHECK(most >= 4);
    CHECK(most < 50);
    CHECK(report("place and velocity, m", worst, 1e-9));
}

// [D24]
TEST_CASE("impacts: balls between walls keep their energy, or come to rest", "[impacts]") {
    for (const double e : {1.0, 0.5}) {
        World world;
        std::vector<Surface> all;
        const double start[5]{0, 0.21, 0.45, 0.78, 1}, speed[5]{0, 1.3, -0.7, -1.9, 0};
        for (int i = 0; i < 5; ++i)
            all.push_back(bouncy(addPoint(world, {start[i], 0, 0}, 1 + i, {speed[i], 0, 0}), e));
        world.pin({0, 4});
        meet(world, all);
        Solver<float> solver(world, meeting(10));
        const double before = kineticEnergy(world.mass, solver.velocities());
        advance(solver, 240);
        const double kept = kineticEnergy(world.mass, solver.velocities()) / before;
        CHECK(countsOf(solver, world).bounces > 8);
        if (e == 1) CHECK(report("energy after 10 s", std::fabs(kept - 1), 1e-4));
        if (e < 1) CHECK(report("energy left of e = 0.5", kept, 2e-3));
        const Points x = solver.positions();
        for (int i = 0; i < 4; ++i) CHECK(x[i + 1].x - x[i].x > 2 * radius - 1e-4);
    }
}
