// Newton's method against closed forms, formulas of its integrators and independent references
// (validation A0 to A3): it is the reference of the charts, so nothing of it is taken on trust.
#include "newton_options.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// A kilogram on a link of 1 N/m that stays in line: C is linear, so x'' = -x about 10 m.
World springInLine() {
    World world = linkedPoints({{0, 0, 0}, {10, 0, 0}}, {1, 1});
    world.sets.clear();
    world.constrain(linksOf(world, 1), {.name = "spring"});
    world.start[1].x = 11;
    return world;
}

// x + i v of the unit spring after n steps, by what the scheme is.
std::complex<double> springFormula(Integrator integrator, double h, int n) {
    const std::complex<double> ih(0, h);
    std::complex<double> z = 1, last = 0;
    for (int k = 0; k < n; ++k) {
        const std::complex<double> now = z;
        if (integrator == Integrator::midpoint)
            z = z * (1.0 - ih / 2.0) / (1.0 + ih / 2.0);
        else if (integrator == Integrator::first || k == 0)
            z = z / (1.0 + ih);
        else
            z = (4.0 * z - last) / (3.0 + 2.0 * ih);
        last = now;
    }
    return z;
}

World falling(int links, double mass) {
    const double link = links > 2 ? 1.0 / links : 1;
    Points at;
    for (int i = 0; i <= links; ++i) at.push_back({i * link, 0, 0});
    World world = linkedPoints(at, std::vector<double>(at.size(), mass));
    world.act<Gravity>(GravityOptions{});
    return world;
}

// Where a chain of equal rigid links and masses is that was let go from horizontal: its equations
// of motion in the plane with exact multipliers, by the classical Runge-Kutta method.
Points fallen(int links, double seconds, int steps) {
    const int n = links;
    const double link = n > 2 ? 1.0 / n : 1, h = seconds / steps;
    using Vector = Eigen::VectorXd;
    Vector x(2 * n), v = Vector::Zero(2 * n);
    for (int i = 0; i < n; ++i) x.segment(2 * i, 2) << (i + 1) * link, 0;
    const auto accelerate = [&](const Vector& at, const Vector& speed) {
        Eigen::MatrixXd j = Eigen::MatrixXd::Zero(n, 2 * n);
        Vector free(2 * n), right(n);
        for (int i = 0; i < n; ++i) {
            free.segment(2 * i, 2) << 0, -g;
            const bool first = i == 0;
            const Eigen::Vector2d above = first ? Eigen::Vector2d(0, 0) : at.segment<2>(2 * i - 2);
            const Eigen::Vector2d above1 =
                first ? Eigen::Vector2d(0, 0) : speed.segment<2>(2 * i - 2);
            const Eigen::Vector2d d = at.segment<2>(2 * i) - above;
            const Eigen::Vector2d d1 = speed.segment<2>(2 * i) - above1;
            j.block(i, 2 * i, 1, 2) = d.transpose();
            if (!first) j.block(i, 2 * i - 2, 1, 2) = -d.transpose();
            right(i) = -d1.squaredNorm();
        }
        const Vector pull = (j * j.transpose()).ldlt().solve(right - j * free);
        return Vector(free + j.transpose() * pull);
    };
    for (int k = 0; k < steps; ++k) {
        const Vector v1 = v, a1 = accelerate(x, v1);
        const Vector v2 = v + h / 2 * a1, a2 = accelerate(x + h / 2 * v1, v2);
        const Vector v3 = v + h / 2 * a2, a3 = accelerate(x + h / 2 * v2, v3);
        const Vector v4 = v + h * a3, a4 = accelerate(x + h * v3, v4);
        x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    Points end{{0, 0, 0}};
    for (int i = 0; i < n; ++i) end.push_back({x(2 * i), x(2 * i + 1), 0});
    return end;
}

double rms(const Points& a, const Points& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
    return std::sqrt(sum / double(a.size()));
}

void checkOrder(const std::string& what, Integrator integrator, double coarse, double fine) {
    const double order = std::log2(coarse / fine);
    note(what + ", " + nameOf(integrator) + ": order", order);
    if (integrator == Integrator::first)
        CHECK(std::fabs(order - 1) <= 0.1);
    else
        CHECK(order >= 1.8);
}

// Errors of the chain after `seconds`, at these and twice these steps a second.
void checkFall(int links, double seconds, int steps, const Points& exact) {
    for (const Integrator integrator : all) {
        double before = 0;
        for (const int now : {steps, 2 * steps}) {
            Solver<double> solver(falling(links, 1), newton(now, integrator));
            advance(solver, static_cast<int>(std::lround(seconds * now)));
            const double error = rms(solver.positions(), exact);
            const std::string what = "fall of " + std::to_string(links) + " links";
            note(what + ", " + nameOf(integrator) + ", " + std::to_string(now) + "/s: rms, m",
                 error);
            if (before > 0) checkOrder(what, integrator, before, error);
            before = error;
        }
    }
}

}  // namespace

TEST_CASE("newton: the unit spring is its integrators' formula", "[newton]") {
    for (const Integrator integrator : all)
        for (const int n : {20, 50, 100, 200}) {
            // A period in n steps: time runs at 2 pi / n s a step.
            SolverOptions options = newton(1, integrator);
            const double h = 2 * M_PI / n;
            options.timeScale = h;
            Solver<double> solver(springInLine(), options);
            advance(solver, n);
            const std::complex<double> z(solver.positions()[1].x - 10, solver.velocities()[1].x);
            const std::complex<double> exact = springFormula(integrator, h, n);
            CHECK(report("unit spring, " + nameOf(integrator) + ", " + std::to_string(n) + " steps",
                         std::abs(z - exact), 2e-12));
        }
    // Validation A0, |z| after a period and the phase of the trapezoid, which midpoint is here.
    for (const auto& [n, size, lag] :
         {std::tuple{20, 0.390144, 0.05093}, {50, 0.675907, 0.00825}, {200, 0.906062, 0.00052}}) {
        const double h = 2 * M_PI / n;
        CHECK(std::fabs(std::abs(springFormula(Integrator::first, h, n)) - size) < 5e-7);
        CHECK(std::fabs(std::arg(springFormula(Integrator::midpoint, h, n)) - lag) < 5e-6);
    }
}

TEST_CASE("newton: midpoint keeps the energy of a spring", "[newton]") {
    SolverOptions options = newton(1, Integrator::midpoint);
    options.timeScale = 0.5;
    Solver<double> solver(springInLine(), options);
    double worst = 0;
    for (int k = 0; k < 1000; ++k) {
        solver.frame();
        const double x = solver.positions()[1].x - 10, v = solver.velocities()[1].x;
        worst = std::max(worst, std::fabs(x * x + v * v - 1));
    }
    CHECK(report("unit spring, midpoint, h 0.5, 1000 steps: energy", worst, 1e-12));
}

TEST_CASE("newton: falling chains of rigid links converge at their order", "[newton][figures]") {
    const Points reference = fallen(20, 0.25, 2000);
    note("fall of 20 links, reference, self-difference", rms(reference, fallen(20, 0.25, 1000)));
    checkFall(1, 1, 960, fallen(1, 1, 4000));
    checkFall(20, 0.25, 960, reference);
}

TEST_CASE("newton: the double pendulum of the table", "[newton]") {
    struct Row {
        double lower;  // rad from straight down
        Point half, whole;
    };
    // Validation A2: the lower bob after 0.5 and 1 s, from rest; the upper link starts at 90
    // degrees.
    constexpr Row table[] = {
        {pi / 2, {1.4734656701, -1.2003894352, 0}, {-1.4448188499, -1.3217944614, 0}},
        {pi, {1.0027116423, -0.1778828260, 0}, {-0.8900192495, -0.8791101236, 0}}};
    for (const Row& row : table)
        for (const Integrator integrator : all) {
            double before = 0, error = 0;
            for (const int steps : {960, 1920}) {
                World world = linkedPoints(
                    {{0, 0, 0}, {1, 0, 0}, {1 + std::sin(row.lower), -std::cos(row.lower), 0}},
                    {1, 1, 1});
                world.act<Gravity>(GravityOptions{});
                Solver<double> solver(world, newton(steps, integrator));
                advance(solver, steps / 2);
                const double half = length(solver.positions()[2] - row.half);
                advance(solver, steps / 2);
                before = error;
                error = std::max(half, length(solver.positions()[2] - row.whole));
            }
            note("double pendulum, " + nameOf(integrator) + ", 1920/s: worst, m", error);
            checkOrder("double pendulum", integrator, before, error);
        }
}

TEST_CASE("newton: a single link is what exact projection makes of it", "[newton]") {
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2})
        for (const double compliance : {0.0, 1e-4}) {
            World world = falling(1, 1);
            world.sets.clear();
            world.constrain(linksOf(world, compliance), {.name = "link"});
            SolverOptions swept = stepping(240, integrator);
            swept.schedule.iterations = 20;
            Solver<double> solver(world, newton(240, integrator)), xpbd(world, swept);
            advance(solver, 240), advance(xpbd, 240);
            CHECK(report("one link, " + nameOf(integrator) + ", against xpbd, m",
                         length(solver.positions()[1] - xpbd.positions()[1]), 2e-12));
        }
}

TEST_CASE("newton: what it lacks is refused", "[newton]") {
    CHECK_THROWS_AS(Solver<float>(falling(1, 1), newton(240, Integrator::first)),
                    std::invalid_argument);
    CHECK_THROWS_AS(Solver<double>(falling(1, 1), stepping(240, Integrator::midpoint)),
                    std::invalid_argument);
    World held = loosePoints({{0, 0, 0}});
    held.constrain(restRows<Attach>({0}, held.rest), {.name = "nail"});
    CHECK_THROWS_AS(Solver<double>(held, newton(240, Integrator::first)), std::invalid_argument);
}
