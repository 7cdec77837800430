// Springs by explicit, symplectic and implicit Euler: what Stam 2009, section 4.2, says of the unit
// spring, in closed form (validation A0).
#include "spring.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

double radius(const Phase& z) { return std::hypot(z.x, z.v); }

// Largest distance, over the radius, from a spiral that grows by `growth` a step.
double spiralError(Method method, double h, double growth, int steps) {
    Solver<double> solver(unitSpring(), steppingBy(h, method));
    double worst = 0;
    for (int n = 1; n <= steps; ++n) {
        solver.frame();
        const Phase z = phaseOf(solver);
        const double r = std::pow(growth, n), angle = -n * std::atan(h);
        worst =
            std::max(worst, std::hypot(z.x - r * std::cos(angle), z.v - r * std::sin(angle)) / r);
    }
    return worst;
}

// H~ = (x^2 + v^2 - h x v) / 2, which velocity-first symplectic Euler conserves.
double modifiedEnergy(const Phase& z, double h) {
    return (z.x * z.x + z.v * z.v - h * z.x * z.v) / 2;
}

bool explodes(double h) {
    Solver<double> solver(unitSpring(), steppingBy(h, Method::symplectic, 500));
    try {
        advance(solver, 40);
    } catch (const Diverged&) {
        return true;
    }
    return radius(phaseOf(solver)) > 1e5;
}

}  // namespace

TEST_CASE("explicit: the spring spirals out by sqrt(1 + h^2) in every step",
          "[springs][IN2][FX35]") {
    double worst = 0;
    for (const double h : {0.01, 0.1, 0.5, 1.0, 3.0})
        worst = std::max(worst, spiralError(Method::explicitEuler, h, std::sqrt(1 + h * h), 100));
    CHECK(report("explicit spiral, 100 steps, relative", worst, 1e-12));
}

TEST_CASE("implicit: the spring spirals in by sqrt(1 + h^2) in every step",
          "[springs][IN3][FX35]") {
    double worst = 0;  // at h = 1 the second step ends at 0, where an attachment has no gradient
    for (const double h : {0.01, 0.1, 0.5, 2.0})
        worst = std::max(worst, spiralError(Method::implicit, h, 1 / std::sqrt(1 + h * h), 40));
    CHECK(report("implicit spiral, 40 steps, relative", worst, 1e-12));
    // Positions are differences of what is a thousand times as large.
    worst = spiralError(Method::implicit, 1e3, 1 / std::sqrt(1 + 1e6), 3);
    CHECK(report("the same with h = 1000, 3 steps", worst, 1e-9));
}

// 1 kg half way between two pins, on springs of 1 N/m that are too long or too short by 0.5 m, and
// beside the line by so little that its motion across is linear: x'' = -x, or x'' = x.
static Phase across(double rest, double h, int steps) {
    World world = loosePoints({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
    world.pin({0, 2});
    world.start[1].y = 1e-6;
    world.constrain(Rows<Stretch>{{0, 1, 1, 2}, {{rest, 1, 1}, {rest, 1, 1}}, {}, {}},
                    {.name = "springs"});
    Solver<double> solver(world, steppingBy(h, Method::implicit));
    advance(solver, steps);
    return {1e6 * solver.positions()[1].y, 1e6 * solver.velocities()[1].y};
}

TEST_CASE("implicit: tension holds across, implicitly; pressure pushes out, explicitly",
          "[springs]") {
    constexpr double h = 0.3;
    constexpr int n = 20;
    const Phase held = across(0.5, h, n);
    const double r = std::pow(1 + h * h, -n / 2.0), angle = -n * std::atan(h);
    CHECK(report("decay across taut springs",
                 std::hypot(held.x - r * std::cos(angle), held.v - r * std::sin(angle)) / r, 1e-9));
    const Phase pushed = across(1.5, h, 1);
    CHECK(
        report("push of pressed springs", std::hypot(pushed.x - (1 + h * h), pushed.v - h), 1e-9));
}

TEST_CASE("symplectic: the modified energy is constant, and bounds the plain one",
          "[springs][IN4][FX35]") {
    for (const double h : {0.5, 1.0, std::sqrt(2.0), 1.9}) {
        Solver<double> solver(unitSpring(), steppingBy(h, Method::symplectic));
        double worst = 0, least = 1, most = 0;
        for (int n = 0; n < 20000; ++n) {
            solver.frame();
            const Phase z = phaseOf(solver);
            worst = std::max(worst, std::fabs(modifiedEnergy(z, h) - 0.5));
            const double energy = (z.x * z.x + z.v * z.v) / 2;
            least = std::min(least, energy);
            most = std::max(most, energy);
        }
        INFO("h = " << h);
        CHECK(report("modified energy, 20,000 steps of " + std::to_string(h), worst, 1e-13));
        CHECK(least >= 0.5 / (1 + h / 2) - 1e-12);
        CHECK(most <= 0.5 / (1 - h / 2) + 1e-12);
        if (h == 0.5) {  // they fill the band between the two ellipses
            CHECK(least == Approx(0.4).epsilon(1e-6));
            CHECK(most == Approx(2.0 / 3).epsilon(1e-6));
        }
    }
}

// A step is linear: its columns from three states, none of them at rest in the middle.
TEST_CASE("symplectic: a step keeps areas, and a million of them the orbit", "[springs][IN4]") {
    const auto step = [](double h, double x, double v) {
        World world = unitSpring();
        world.start[0].x = x;
        world.velocity[0].x = v;
        Solver<double> solver(world, steppingBy(h, Method::symplectic));
        solver.frame();
        return phaseOf(solver);
    };
    for (const double h : {0.01, 0.5, 1.0, 1.9, 3.0}) {
        const Phase one = step(h, 1, 0), both = step(h, 1, 1);
        const double determinant = one.x * (both.v - one.v) - (both.x - one.x) * one.v;
        CHECK(report("determinant less 1, h = " + std::to_string(h), std::fabs(determinant - 1),
                     1e-15 * std::max(1.0, h * h)));
    }
    constexpr double h = 1.9;
    Solver<double> solver(unitSpring(), steppingBy(h, Method::symplectic, 100));
    double most = 0;
    for (int frame = 0; frame < 10000; ++frame) {
        solver.frame();
        const Phase z = phaseOf(solver);
        most = std::max(most, (z.x * z.x + z.v * z.v) / 2);
    }
    CHECK(report("energy over a million steps, of the most it may be", most * (1 - h / 2) / 0.5,
                 1 + 1e-9));
}

TEST_CASE("symplectic: it explodes above h = 2 and not below", "[springs][IN6]") {
    double calm = 1.9, wild = 2.1;
    REQUIRE(!explodes(calm));
    REQUIRE(explodes(wild));
    while (wild - calm > 2e-7) {
        const double h = (calm + wild) / 2;
        (explodes(h) ? wild : calm) = h;
    }
    CHECK(report("stability boundary of the unit spring, from 2", std::fabs(calm - 2), 1e-6));
}

TEST_CASE("symplectic: beyond the boundary it grows as the eigenvalue says", "[springs]") {
    constexpr double h = 2.001, b = h * h / 2 - 1;
    Solver<double> solver(unitSpring(), steppingBy(h, Method::symplectic));
    advance(solver, 200);
    const double before = radius(phaseOf(solver));
    solver.frame();
    const double growth = radius(phaseOf(solver)) / before;
    CHECK(
        report("growth in a step of 2.001", std::fabs(growth - (b + std::sqrt(b * b - 1))), 1e-9));
    CHECK(growth == Approx(1.06529).epsilon(1e-5));
}
