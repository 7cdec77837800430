// Chebyshev's mixing of columns: its bound, and what it must leave alone.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/measure/momentum.h>
#include <plait/sheets/inextensible.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

// Links along a line, so that sweeps are linear, a little off their lengths.
constexpr int links = 12;

SolverOptions columns(int count, double chebyshev) {
    SolverOptions options;
    options.schedule = {.substeps = 1, .iterations = count};
    options.chebyshev = chebyshev;
    return options;
}

// How far each vertex is off after one substep from there.
std::vector<double> swept(const std::vector<double>& off, const SolverOptions& options) {
    Points at;
    for (int v = 0; v <= links; ++v) at.push_back({double(v), 0, 0});
    World world = linkedPoints(at, std::vector<double>(links + 1, 1.0));
    for (int v = 0; v <= links; ++v) world.start[v].x += off[v];
    Solver<double> solver(world, options);
    solver.frame();
    std::vector<double> left;
    const Points x = solver.positions();
    for (int v = 0; v <= links; ++v) left.push_back(x[v].x - v);
    return left;
}

double sizeOf(const std::vector<double>& off) {
    double sum = 0;
    for (const double o : off) sum += o * o;
    return std::sqrt(sum);
}

std::vector<double> scaled(std::vector<double> off, double factor) {
    for (double& o : off) o *= factor;
    return off;
}

}  // namespace

TEST_CASE("chebyshev: as fast as its polynomial", "[chebyshev]") {
    // The slowest mode of a palindrome, by the power method, and its eigenvalue.
    std::vector<double> slowest(links + 1, 0.01), rough(links + 1);
    slowest[0] = 0;
    double rho = 0;
    for (int i = 0; i < 400; ++i) {
        const std::vector<double> next = swept(slowest, columns(1, 0));
        rho = sizeOf(next) / sizeOf(slowest);
        slowest = scaled(next, 0.01 / sizeOf(next));
    }
    note("largest eigenvalue of a palindrome", rho);
    for (int v = 1; v <= links; ++v) rough[v] = 0.01 * std::sin(5.0 * v * v);
    for (const int count : {3, 5, 10, 20}) {
        const std::string name = std::to_string(count) + " columns";
        // T_k(s(1)), and T_k(s(rho)) = 1.
        const double rate = 1 / std::cosh(count * std::acosh((2 - rho) / rho));
        const double mode = sizeOf(swept(slowest, columns(count, rho))) / sizeOf(slowest);
        CHECK(report(name + ": slowest mode, off the bound by", std::fabs(mode / rate - 1), 1e-6));
        const double plain = sizeOf(swept(slowest, columns(count, 0))) / sizeOf(slowest);
        CHECK(report(name + ": without, off rho^k by", std::fabs(plain / std::pow(rho, count) - 1),
                     1e-6));
        CHECK(report(name + ": all modes, of the bound",
                     sizeOf(swept(rough, columns(count, rho))) / sizeOf(rough) / rate, 1));
    }
}

TEST_CASE("chebyshev: a falling sheet at half the work", "[chebyshev]") {
    constexpr int n = 24;
    const auto strainOf = [](int iterations, double chebyshev) {
        World world;
        const Range sheet =
            world.add(grid({.columns = n, .rows = n}, {.across = {1, 0, 0}, .up = {0, 0, 1}}),
                      {.density = 0.2});
        world.pin({0, n - 1});
        world.act<Gravity>(GravityOptions{});
        holdSheet(world, sheet, {.mending = 0});
        SolverOptions options = columns(iterations, chebyshev);
        options.schedule.frameRate = {60, 1};
        options.schedule.substeps = 16;
        Solver<float> solver(world, options);
        double mean = 0;
        for (int frame = 1; frame <= 90; ++frame) {
            solver.frame();
            double most = 0;
            for (const double e : strainsOf(linksOf(world), solver.positions()))
                most = std::max(most, e);
            if (frame > 45) mean += most / 45;
        }
        return mean;
    };
    note("largest strain, mean of frames, 5 columns", strainOf(5, 0));
    note("10 columns", strainOf(10, 0));
    CHECK(report("5 columns mixed", strainOf(5, 0.8), 0.85 * strainOf(5, 0)));
}

TEST_CASE("chebyshev: momentum, pins, bits", "[chebyshev][conservation][determinism]") {
    Points at;
    for (int v = 0; v <= links; ++v) at.push_back({double(v), 0.1 * (v % 3), 0});
    World world = linkedPoints(at, std::vector<double>(links + 1, 1.0));
    world.pins.clear();
    world.pinned[0] = 0;
    for (int v = 0; v <= links; ++v) world.velocity[v] = {0, std::sin(2.0 * v), std::cos(3.0 * v)};
    const Vec<double> before = momentum(world.mass, world.velocity);
    Solver<double> free(world, columns(6, 0.8));
    for (int frame = 0; frame < 24; ++frame) free.frame();
    CHECK(report("momentum lost, of the whole",
                 length(momentum(world.mass, free.velocities()) - before) / length(before), 1e-12));
    world.pin({0});
    std::uint64_t hash = 0;
    for (const int threads : {1, 3}) {
        SolverOptions options = columns(6, 0.8);
        options.threads = threads;
        Solver<float> solver(world, options);
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        CHECK(solver.positions()[0] == at[0]);
        if (hash == 0) hash = solver.hash();
        CHECK(solver.hash() == hash);
    }
}

TEST_CASE("chebyshev: refuses what it would spoil", "[chebyshev]") {
    World world = linkedPoints({{0, 0, 0}, {1, 0, 0}}, {1, 1});
    const auto refused = [&](const SolverOptions& options) {
        CHECK_THROWS_AS(Solver<double>(world, options), std::invalid_argument);
    };
    for (const double rho : {-0.1, 1.0, std::nan("")}) refused(columns(3, rho));
    refused(columns(2, 0.5));
    SolverOptions options = columns(3, 0.5);
    options.sweeps = Sweeps::oneWay;
    refused(options);
    options = columns(3, 0.5);
    options.method = Method::nucleus;
    refused(options);
    Solver<double>(world, columns(3, 0.5)).frame();
    world.constrain(linksOf(world, 1e-3), {.name = "soft"});
    refused(columns(3, 0.5));
}
