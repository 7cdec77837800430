// Time integration against its own discrete formulas and the laws of numerical damping of
// position-based methods (validation A0, A1). BDF2 without a past starts with a substep of first
// order.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/measure/energy.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

using Point = Vec<double>;

constexpr double g = 9.81;

template <class Real>
constexpr const char* precision = std::is_same_v<Real, float> ? ", float" : ", double";

enum class Start { firstOrder, firstOrderStep, exactPast };

// Position after n substeps of a fall from rest, by what the scheme is. BDF2 is exact for a
// parabola; the error that its first step leaves satisfies e'' = (4 e' - e) / 3.
double fallen(Start start, double h, int n) {
    if (start == Start::firstOrder) return -g * h * h * n * (n + 1) / 2;
    const double parabola = -g * h * h * n * n / 2;
    return start == Start::exactPast ? parabola
                                     : parabola - 0.75 * g * h * h * (1 - std::pow(3.0, -n));
}

// Largest relative error over one second, at every frame and of several points; there are enough of
// them for every thread to have some.
template <class Real>
double fallError(Start start, int steps, int substeps, int threads) {
    const int count = threads > 1 ? 3100 : 100, frames = steps / substeps;
    World world = loosePoints(Points(count));
    for (int i = 0; i < count; ++i) world.start[i] = {0.01 * i, 0.001 * i, -3};
    world.act<Gravity>(GravityOptions{});
    SolverOptions options{.schedule = {.substeps = substeps, .frameRate = {frames, 1}},
                          .threads = threads};
    if (start != Start::firstOrder) options.integrator = Integrator::bdf2;
    Solver<Real> solver(world, options);
    const double h = solver.substepLength();
    if (start == Start::exactPast) {
        Points past = world.start;
        for (Point& p : past) p.y -= g * h * h / 2;
        solver.setPast(past, Points(count, {0, g * h, 0}));
    }
    double worst = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        solver.frame();
        const double exact = fallen(start, h, frame * substeps);
        const Points x = solver.positions();
        for (int i = 0; i < count; i += 7) {
            const Point error = x[i] - world.start[i] - Point{0, exact, 0};
            worst = std::max(worst, length(error) / std::fabs(exact));
        }
    }
    return worst;
}

struct Rotor {
    double speed;  // |v|, by what it was
    double angle;  // of the last substep, by what it should be
};

// A point on a rigid link of 1 m around a pin, phi rad a substep, for n of them. Its velocities at
// the start are tangents, or what the rule of BDF2 makes of a circle.
template <class Real>
Rotor rotate(double phi, int n, Start start, bool tangents = true) {
    const int steps = 240;
    const auto at = [&](int k) { return Point{std::cos(k * phi), std::sin(k * phi), 0}; };
    const auto velocity = [&](int k) -> Point {
        if (tangents) return steps * phi * Point{-at(k).y, at(k).x, 0};
        return 0.5 * steps * (3.0 * at(k) - 4.0 * at(k - 1) + at(k - 2));
    };
    World world = linkedPoints({{0, 0, 0}, at(0)}, {1, 1});
    world.velocity[1] = velocity(0);
    Solver<Real> solver(
        world, stepping(steps, start == Start::firstOrder ? Integrator::first : Integrator::bdf2));
    if (start == Start::exactPast)
        solver.setPast(Points{{0, 0, 0}, at(-1)}, Points{{0, 0, 0}, velocity(-1)});
    advance(solver, n - 1);
    const Point x1 = solver.positions()[1];
    solver.frame();
    const Point x = solver.positions()[1];
    return {length(solver.velocities()[1]) / (steps * phi),
            std::atan2(cross(x1, x).z, dot(x1, x)) / phi};
}

struct RotorRow {
    double phi;
    int n;
    double first, bdf2;
};

// Validation A1, the simulated columns. That of BDF2 has velocities by its own rule, and counts the
// angle of a substep; with tangents at the start the speed is what agrees.
constexpr RotorRow rotorTable[] = {{0.01, 1000, 0.912917, 0.999995},
                                   {0.01, 10000, 0.577360, 0.999950},
                                   {0.05, 400, 0.577585, 0.998769},
                                   {0.1, 628, 0.271623, 0.971863},
                                   {0.2, 100, 0.333853, 0.940506}};

std::string label(const RotorRow& row, const std::string& what) {
    char text[80];
    std::snprintf(text, sizeof text, "rotor, phi %.2f, n %5d, %s", row.phi, row.n, what.c_str());
    return text;
}

// A bob of 1 kg on a rigid link of 1 m, let go at `angle` (rad) from straight down.
World pendulum(double angle) {
    World world = linkedPoints({{0, 0, 0}, {std::sin(angle), -std::cos(angle), 0}}, {1, 1});
    world.act<Gravity>(GravityOptions{});
    return world;
}

constexpr double right = pi / 2;

// Energy after 10 s of a pendulum let go at 90 degrees, in units of m g L; 0 at the start.
double energyLost(int steps, Integrator integrator) {
    Solver<double> solver(pendulum(right), stepping(steps, integrator));
    advance(solver, 10 * steps);
    const std::array<double, 2> mass{0, 1};
    return (kineticEnergy(mass, solver.velocities()) +
            gravitationalEnergy(mass, solver.positions(), {0, -g, 0})) /
           g;
}

// Of a pendulum of 1 m let go at `angle`, by the classical Runge-Kutta method.
Point pendulumReference(double angle, double t) {
    const int n = 20000;
    const double h = t / n;
    double a = angle, w = 0;
    for (int i = 0; i < n; ++i) {
        const auto pull = [](double x) { return -g * std::sin(x); };
        const double w1 = w, k1 = pull(a);
        const double w2 = w + h / 2 * k1, k2 = pull(a + h / 2 * w1);
        const double w3 = w + h / 2 * k2, k3 = pull(a + h / 2 * w2);
        const double w4 = w + h * k3, k4 = pull(a + h * w3);
        a += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
        w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return {std::sin(a), -std::cos(a), 0};
}

// Orders of convergence of a pendulum's position after 1 s, from 120 to 1920 steps a second.
std::vector<double> orders(Start start) {
    const double angle = 1, steps0 = 120;
    const Point exact = pendulumReference(angle, 1);
    std::vector<double> found;
    double before = 0;
    for (int steps = int(steps0); steps <= 1920; steps *= 2) {
        Solver<double> solver(
            pendulum(angle),
            stepping(steps, start == Start::firstOrder ? Integrator::first : Integrator::bdf2));
        if (start == Start::exactPast) {  // at rest: what it will be is what it was
            const double h = 1.0 / steps;
            const Point past = pendulumReference(angle, h);
            const double speed =
                std::sqrt(2 * g * (std::cos(std::atan2(past.x, -past.y)) - std::cos(angle)));
            solver.setPast(Points{{0, 0, 0}, past},
                           Points{{0, 0, 0}, speed * Point{-past.y, past.x, 0}});
        }
        advance(solver, steps);
        const double error = length(solver.positions()[1] - exact);
        if (before > 0) found.push_back(std::log2(before / error));
        before = error;
    }
    return found;
}

}  // namespace

TEMPLATE_TEST_CASE("free fall follows the scheme's own formula",
                   "[integration][threads][IN1][AW10]", double, float) {
    const double bound = std::is_same_v<TestType, float> ? 1e-6 : 1e-12;
    const std::string in = precision<TestType>;
    for (const auto& [start, name] : {std::pair{Start::firstOrder, "first order"},
                                      {Start::firstOrderStep, "BDF2 after a first-order step"},
                                      {Start::exactPast, "BDF2 from the exact past"}}) {
        double worst = 0;
        for (const int substeps : {1, 3, 10})
            for (const int threads : {1, 2, 3})
                worst = std::max(worst, fallError<TestType>(start, 60, substeps, threads));
        CHECK(report("free fall, " + (name + in), worst, bound));
        note("free fall, 2,400 substeps/s, " + (name + in),
             fallError<TestType>(start, 2400, 240, 1));
    }
}

TEST_CASE("a rotor slows as the law of first order says", "[integration]") {
    for (const RotorRow& row : rotorTable) {
        const double full = rotate<double>(row.phi, row.n, Start::firstOrder).speed;
        const double single = rotate<float>(row.phi, row.n, Start::firstOrder).speed;
        CHECK(report(label(row, "first order, double"), std::fabs(full / row.first - 1), 5e-5));
        CHECK(report(label(row, "first order, float"), std::fabs(single / row.first - 1), 2e-4));
    }
}

TEST_CASE("BDF2 hardly slows a rotor", "[integration]") {
    for (const RotorRow& row : rotorTable) {
        const double table = rotate<double>(row.phi, row.n, Start::exactPast, false).angle;
        const double full = rotate<double>(row.phi, row.n, Start::exactPast).speed;
        const double single = rotate<float>(row.phi, row.n, Start::exactPast).speed;
        CHECK(report(label(row, "BDF2, double"), std::fabs(table - row.bdf2), 6e-7));
        if (row.phi <= 0.05)
            CHECK(report(label(row, "BDF2 from tangents, double"), std::fabs(full / row.bdf2 - 1),
                         1e-3));
        note(label(row, "BDF2 from tangents, float: error"), single / full - 1);
    }
    const double past = rotate<double>(0.1, 628, Start::exactPast).speed;
    const double step = rotate<double>(0.1, 628, Start::firstOrderStep).speed;
    CHECK(report("rotor, phi 0.1, n 628, from the exact past, against 0.9721",
                 std::fabs(past - 0.9721), 5e-5));
    CHECK(report("rotor, phi 0.1, n 628, from a first-order step, against 0.9616",
                 std::fabs(step - 0.9616), 5e-5));
}

TEST_CASE("a pendulum loses the energy that the table says", "[integration][IN16]") {
    struct Row {
        int steps;
        double first, firstDigit, bdf2, bdf2Digit;
    };
    // Validation A1, with what the last printed digit is worth.
    constexpr Row table[] = {
        {24, -0.992, 1e-3, -0.236, 1e-3},    {60, -0.896, 1e-3, -0.0260, 1e-4},
        {120, -0.723, 1e-3, -0.00457, 1e-5}, {240, -0.511, 1e-3, -8.8e-4, 1e-5},
        {480, -0.320, 1e-3, -1.8e-4, 1e-5},  {960, -0.181, 1e-3, -4.2e-5, 1e-6},
        {1920, -0.0960, 1e-4, -9.9e-6, 1e-7}};
    for (const Row& row : table) {
        const std::string at = "pendulum, " + std::to_string(row.steps) + " steps/s, ";
        const double first = energyLost(row.steps, Integrator::first);
        const double bdf2 = energyLost(row.steps, Integrator::bdf2);
        CHECK(report(at + "first order, of mgL", std::fabs(first - row.first), row.firstDigit / 2));
        CHECK(report(at + "BDF2, of mgL", std::fabs(bdf2 - row.bdf2), row.bdf2Digit / 2));
    }
}

// The linear pendulum is x'' = -w^2 x, for which the scheme is implicit Euler: x + i v / w shrinks
// by 1 / sqrt(1 + w^2 h^2) a step, so by exp(-w^2 h t / 2) while w h is small.
TEST_CASE("small swings decay as implicit Euler's", "[integration]") {
    const double w = std::sqrt(g), angle = 1e-4, period = 2 * pi / w;
    for (const auto& [steps, law] : {std::pair{60, 0.849}, std::pair{240, 0.960}}) {
        Solver<double> solver(pendulum(angle), stepping(steps));
        const int n = 4 * steps;
        advance(solver, n);
        const double size = std::hypot(solver.positions()[1].x, solver.velocities()[1].x / w);
        const double h = solver.substepLength(), exact = std::pow(1 + g * h * h, -0.5 * n);
        const double inPeriod = std::pow(size / std::sin(angle), period / (n * h));
        const std::string at = "small swings, " + std::to_string(steps) + " steps/s, ";
        CHECK(report(at + "against implicit Euler", std::fabs(size / std::sin(angle) / exact - 1),
                     1e-7));
        CHECK(report(at + "in a period, against the law", std::fabs(inPeriod - law), 5e-4));
    }
}

TEST_CASE("orders of convergence", "[integration][IN15][IN16]") {
    for (const double order : orders(Start::firstOrder)) {
        note("pendulum at 1 s, first order: order", order);
        CHECK(std::fabs(order - 1) <= 0.1);
    }
    for (const Start start : {Start::firstOrderStep, Start::exactPast})
        for (const double order : orders(start)) {
            note(start == Start::exactPast
                     ? "pendulum at 1 s, BDF2 from the exact past: order"
                     : "pendulum at 1 s, BDF2 after a first-order step: order",
                 order);
            CHECK(order >= 1.8);
        }
}
