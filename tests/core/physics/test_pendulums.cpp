// Swinging chains against closed forms, eigenvalues and converged references (validation A2): the
// direct solve and BDF2 at small steps.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <Eigen/Dense>
#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

using Point = Vec<double>;

constexpr double g = 9.81;

// Links of these lengths at these angles (rad) from straight down, hung at the origin.
Points hung(const std::vector<double>& angles, double link) {
    Points at{{0, 0, 0}};
    for (const double a : angles)
        at.push_back(at.back() + link * Point{std::sin(a), -std::cos(a), 0});
    return at;
}

// Times (s) at which what `measure` makes of the positions passes through zero, until `count` of
// them are found. It is all but straight there.
template <class Measure>
std::vector<double> zeros(Solver<double>& solver, std::size_t count, const Measure& measure) {
    std::vector<double> times;
    double before = measure(solver.positions());
    while (times.size() < count) {
        solver.frame();
        const double now = measure(solver.positions());
        if (before * now <= 0 && before != 0)
            times.push_back(solver.time() - solver.substepLength() * now / (now - before));
        before = now;
    }
    return times;
}

// Small swings of a chain of N links and length 1 about hanging: M x'' = -K x, K from the tensions.
struct Modes {
    Eigen::VectorXd period;  // s, longest first
    Eigen::MatrixXd shape;   // columns: x by vertex below the pin, of unit modal mass
    Eigen::VectorXd mass;

    explicit Modes(const std::vector<double>& masses, double link) {
        const auto n = static_cast<Eigen::Index>(masses.size()) - 1;
        mass = Eigen::Map<const Eigen::VectorXd>(masses.data() + 1, n);
        Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double k = g * mass.tail(n - i).sum() / link;
            stiffness(i, i) += k;
            if (i == 0) continue;
            stiffness(i - 1, i - 1) += k;
            stiffness(i, i - 1) -= k;
            stiffness(i - 1, i) -= k;
        }
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(
            stiffness, Eigen::MatrixXd(mass.asDiagonal()));
        period = 2 * pi * solved.eigenvalues().array().rsqrt();
        shape = solved.eigenvectors();
    }
};

// A hanging chain of 1 m, let go in the sum of its first modes, each of 1e-4 m at the tip.
World swinging(int links, int modes, const Modes& m) {
    const double link = 1.0 / links;
    const Eigen::VectorXd x =
        1e-4 * (m.shape.leftCols(modes) *
                m.shape.bottomRows(1).leftCols(modes).transpose().cwiseInverse());
    std::vector<double> angles;
    for (Eigen::Index i = 0; i < links; ++i)
        angles.push_back(std::asin((x(i) - (i > 0 ? x(i - 1) : 0)) / link));
    World world;
    const Range all =
        world.add(chain({.links = links, .to = {0, -1, 0}}), {.start = hung(angles, link)});
    world.pin({all.first});
    world.act<Gravity>(GravityOptions{});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest),
                    {.name = "links", .direct = true});
    return world;
}

// Period (s) of each of the first modes, as simulated.
std::vector<double> simulatedPeriods(const World& world, int modes, const Modes& m, int steps) {
    std::vector<double> periods;
    for (int k = 0; k < modes; ++k) {
        Solver<double> solver(world, stepping(steps, Integrator::bdf2));
        const auto amplitude = [&](const Points& x) {
            double sum = 0;
            for (Eigen::Index i = 0; i < m.mass.size(); ++i)
                sum += m.shape(i, k) * m.mass(i) * x[static_cast<std::size_t>(i) + 1].x;
            return sum;
        };
        const std::vector<double> times = zeros(solver, 3, amplitude);
        periods.push_back(times[2] - times[0]);
    }
    return periods;
}

constexpr double exactModes[] = {1.6683677, 0.7268255, 0.4636306, 0.3402554};  // s

std::vector<double> lumpedMass(int links) {
    std::vector<double> mass(static_cast<std::size_t>(links) + 1, 1.0 / links);
    mass.front() = mass.back() = 0.5 / links;
    return mass;
}

// Two bobs of 1 kg on links of 1 m.
Solver<double> doublePendulum(double upper, double lower, int steps) {
    World world = linkedPoints(hung({upper, lower}, 1), {1, 1, 1}, true);
    world.act<Gravity>(GravityOptions{});
    return {world, stepping(steps, Integrator::bdf2)};
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

std::string named(const char* format, double a, double b = 0) {
    char text[80];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

// One chain against its eigenvalues, its lumped value in the literature and its continuum.
void checkModes(int links, double lumped) {
    const Modes m(lumpedMass(links), 1.0 / links);
    CHECK(report(named("chain of %.0f, lumped T1", links), std::fabs(m.period(0) - lumped), 6e-6));
    const int steps = 1920;
    const World world = swinging(links, 4, m);
    const std::vector<double> found = simulatedPeriods(world, 4, m, steps);
    for (int k = 0; k < 4; ++k) {
        // BDF2 slows an oscillation by (w h)^2 / 3.
        const double t = m.period(k), phase = 2 * pi / (t * steps);
        const double error = found[static_cast<std::size_t>(k)] / t - 1;
        CHECK(report(named("chain of %.0f, T%.0f, error", links, k + 1), std::fabs(error),
                     1.1 * phase * phase / 3 + 1e-6));
        note(named("chain of %.0f, T%.0f, error against the continuum", links, k + 1),
             found[static_cast<std::size_t>(k)] / exactModes[k] - 1);
    }
}

}  // namespace

TEST_CASE("modes of a hanging chain", "[integration]") {
    checkModes(10, 1.67331);
    checkModes(20, 1.66960);
    checkModes(50, 1.66857);
    checkModes(100, 1.66842);
}

TEST_CASE("lumping with half a mass at the tip is of second order", "[integration]") {
    double error = 0;
    for (const int links : {10, 20, 40}) {
        const Modes m(lumpedMass(links), 1.0 / links);
        const double t = simulatedPeriods(swinging(links, 1, m), 1, m, 1920)[0];
        const double before = std::exchange(error, std::fabs(t - exactModes[0]));
        if (before == 0) continue;
        note(named("order of the lumping, %.0f links", links), order(before, error));
        CHECK(std::fabs(order(before, error) - 2) < 0.1);
    }
}

// Of a large pendulum in units of a small one's: 1 / agm(1, cos(angle / 2)).
double largePeriod(double angle) {
    double a = 1, b = std::cos(angle / 2);
    for (int i = 0; i < 6; ++i) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return 1 / a;
}

TEST_CASE("period of a large pendulum", "[integration]") {
    const double t0 = 2 * pi / std::sqrt(g);
    for (const auto& [degrees, table] :
         {std::pair{30.0, 1.0174088}, {90.0, 1.1803406}, {150.0, 1.7622037}}) {
        const double ratio = largePeriod(degrees * pi / 180);
        CHECK(report(named("pendulum, %.0f degrees, T / T0 of theory", degrees),
                     std::fabs(ratio - table), 6e-8));
        double error = 0;
        for (const int steps : {1920, 3840, 7680}) {
            World world = linkedPoints(hung({degrees * pi / 180}, 1), {1, 1}, true);
            world.act<Gravity>(GravityOptions{});
            Solver<double> solver(world, stepping(steps, Integrator::bdf2));
            const auto times = zeros(solver, 3, [](const Points& x) { return x[1].x; });
            const double before = std::exchange(error, (times[2] - times[0]) / t0 / ratio - 1);
            note(named("pendulum, %.0f degrees, %.0f steps/s: error of T / T0", degrees, steps),
                 error);
            if (before != 0) CHECK(order(before, error) > 1.8);
        }
        CHECK(report(named("pendulum, %.0f degrees, T / T0", degrees), std::fabs(error), 3e-7));
    }
}

TEST_CASE("small swings of a double pendulum", "[integration]") {
    const Modes m({1, 1, 1}, 1);
    const double table[] = {2.6210524, 1.0856755};  // s
    for (int k = 0; k < 2; ++k) {
        CHECK(report(named("double pendulum, T%.0f of theory", k + 1),
                     std::fabs(m.period(k) - table[k]), 6e-8));
        const double x1 = 1e-4 * m.shape(0, k), x2 = 1e-4 * m.shape(1, k);
        double error = 0;
        for (const int steps : {480, 960, 1920}) {
            Solver<double> solver = doublePendulum(std::asin(x1), std::asin(x2 - x1), steps);
            const auto times = zeros(solver, 3, [](const Points& x) { return x[2].x; });
            const double before = std::exchange(error, (times[2] - times[0]) / m.period(k) - 1);
            if (before != 0) CHECK(order(before, error) > 1.8);
        }
        CHECK(report(named("double pendulum, T%.0f, 1920 steps/s", k + 1), std::fabs(error), 4e-6));
    }
}

TEST_CASE("large motion of a double pendulum", "[integration]") {
    struct Row {
        double lower;  // degrees; the upper link starts at 90
        Point half, whole;
    };
    // Validation A2: the lower bob after 0.5 and 1 s, from rest.
    constexpr Row table[] = {
        {90, {1.4734656701, -1.2003894352, 0}, {-1.4448188499, -1.3217944614, 0}},
        {180, {1.0027116423, -0.1778828260, 0}, {-0.8900192495, -0.8791101236, 0}}};
    for (const Row& row : table) {
        double error = 0;
        for (const int steps : {3840, 7680, 15360}) {
            Solver<double> solver = doublePendulum(pi / 2, row.lower * pi / 180, steps);
            advance(solver, steps / 2);
            const double half = length(solver.positions()[2] - row.half);
            advance(solver, steps / 2);
            const double whole = length(solver.positions()[2] - row.whole);
            const double before = std::exchange(error, std::max(half, whole));
            const std::string at = named("double pendulum (90, %.0f), %.0f/s", row.lower, steps);
            note(at + ", 0.5 s, m", half);
            note(at + ", 1 s, m", whole);
            if (before != 0) note(at + ", order", order(before, error));
            if (before != 0) CHECK(order(before, error) > 1.8);
        }
        CHECK(report(named("double pendulum (90, %.0f) to 1 s, m", row.lower), error, 2e-6));
    }
}

// Twenty links let go from horizontal, against small steps and the direct solve.
TEST_CASE("five substeps of twenty sweeps beat one of a hundred", "[integration][IN13]") {
    const auto fall = [](Integrator integrator, int substeps, int iterations) {
        World world = linkedPoints(hung(std::vector<double>(20, pi / 2), 0.05),
                                   std::vector<double>(21, 0.05), integrator == Integrator::bdf2);
        world.act<Gravity>(GravityOptions{});
        Solver<double> solver(world,
                              {.integrator = integrator,
                               .schedule = {.substeps = substeps, .iterations = iterations}});
        advance(solver, 12);
        return solver.positions();
    };
    const Points exact = fall(Integrator::bdf2, 400, 1);
    const auto error = [&](int substeps, int iterations) {
        const Points x = fall(Integrator::first, substeps, iterations);
        double sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += dot(x[i] - exact[i], x[i] - exact[i]);
        return std::sqrt(sum / double(x.size()));
    };
    const double once = error(1, 100), several = error(5, 20);
    note("chain after 0.5 s, 1 substep of 100 sweeps: rms error, m", once);
    note("chain after 0.5 s, 5 substeps of 20 sweeps: rms error, m", several);
    CHECK(several < once);
}
