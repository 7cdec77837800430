// A compliance is a stiffness that depends on nothing else: not on substeps, sweeps or the length
// of a step.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/numbers/elementary.h>
#include <plait/solver.h>

#include <numbers>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81;

struct Case {
    int links = 20;
    double compliance = 0;  // m/N
    int rate = 60;          // frames a second
    int substeps = 1;
    int evaluations = 1;  // of the links in a substep
    Method method = Method::xpbd;
};

// Extension of a chain of unit masses at rest over the exact one, minus 1. At rest is what moves by
// `settled` of the extension in the time of the slowest mode.
double error(const Case& c, double settled = 1e-5) {
    World world = plumbLine({.links = c.links});
    world.constrain(linksOf(world, c.compliance), {.name = "stretch"});
    const double exact = c.compliance * g * c.links * (c.links + 1) / 2;
    // About critical for the slowest mode, which crosses the chain four times in a period.
    const double omega = std::numbers::pi / (2 * c.links * std::sqrt(c.compliance));
    const SolverOptions options{.method = c.method,
                                .schedule = {.substeps = c.substeps,
                                             .frameRate = {.frames = c.rate},
                                             .iterations = c.evaluations},
                                .damping = std::min(0.999, 1 - exponential(-2 * omega / 24))};
    const double restSpeed = settled * exact * omega;
    Solver<double> solver(world, options);
    advance(solver, 10);
    for (int frame = 0; frame < 50000 && topSpeed(solver) > restSpeed; ++frame) solver.frame();
    REQUIRE(topSpeed(solver) <= restSpeed);
    return (-solver.positions().back().y - c.links) / exact - 1;
}

// k h^2 / m = 1 for unit masses.
double unitCompliance(double h) { return h * h; }

// Worse of two: the same spring whatever the substeps, k h^2 / m = 1 for the frame; and a stiffer
// one, with k h^2 / m = 1 for the substep.
double chainError(int substeps, int evaluations) {
    const double frame = 1.0 / 60;
    Case c{.compliance = unitCompliance(frame), .substeps = substeps, .evaluations = evaluations};
    const double same = std::fabs(error(c));
    c.compliance = unitCompliance(frame / substeps);
    return std::max(same, std::fabs(error(c)));
}

}  // namespace

TEST_CASE("a soft link stretches by load times compliance", "[statics][compliance][DC1][DC12]") {
    double worst = 0;
    for (const int evaluations : {1, 10, 50})
        for (const int substeps : {1, 2, 5, 10})
            for (const int rate : {24, 60, 240})
                for (const double stiffness : {0.01, 1.0, 1e3}) {  // k h^2 / m
                    const double h = 1.0 / (rate * substeps);
                    const Case c{1, h * h / stiffness, rate, substeps, evaluations};
                    worst = std::max(worst, std::fabs(error(c, 1e-8)));
                }
    REQUIRE(report("one link, evaluations 1 to 50, substeps 1 to 10, 108 cases", worst, 1e-6));
}

TEST_CASE("a soft chain stretches alike for any sweeps and substeps",
          "[statics][compliance][DC12]") {
    for (const auto& [substeps, evaluations] : {std::pair{1, 20}, {10, 20}, {1, 100}, {1, 500}})
        REQUIRE(report("chain of 20, kh2/m = 1, " + std::to_string(substeps) + " substeps of " +
                           std::to_string(evaluations) + " evaluations",
                       chainError(substeps, evaluations), 0.01));
    for (const int evaluations : {1, 2, 5})
        note("its error in " + std::to_string(evaluations) + " evaluations, 1 substep",
             error({.compliance = unitCompliance(1.0 / 60), .evaluations = evaluations}));
}

TEST_CASE("a soft chain, all substeps from 1 to 10", "[statics][compliance][long][DC12]") {
    for (const int evaluations : {20, 100, 500}) {
        double worst = 0;
        for (int substeps = 1; substeps <= 10; ++substeps)
            worst = std::max(worst, chainError(substeps, evaluations));
        REQUIRE(report("chain of 20, kh2/m = 1, 1 to 10 substeps of " +
                           std::to_string(evaluations) + " evaluations",
                       worst, 0.01));
    }
}

// The sweeps that a stiff chain needs: about 0.933 (N + 1/2)^2 a decimal digit (A1), 392 here.
TEST_CASE("a stiff chain needs many sweeps", "[statics][compliance]") {
    for (const double stiffness : {1e2, 1e4, 1e6}) {
        Case c{.compliance = unitCompliance(1.0 / 60) / stiffness};
        char name[64];
        std::snprintf(name, sizeof name, "kh2/m = %.0e, error in ", stiffness);
        for (const int evaluations : {20, 100, 500}) {
            c.evaluations = evaluations;
            note(name + std::to_string(evaluations) + " evaluations", error(c));
        }
        c.evaluations = 1;
        while (c.evaluations < 10000 && std::fabs(error(c)) > 0.01) c.evaluations *= 2;
        REQUIRE(report(name + std::to_string(c.evaluations) + " evaluations, which is enough",
                       std::fabs(error(c)), 0.01));
    }
}

TEST_CASE("nucleus does not know compliance", "[statics][compliance][DC12]") {
    Case c{.compliance = unitCompliance(1.0 / 60), .method = Method::nucleus};
    for (const int evaluations : {20, 100, 500})
        for (const int substeps : {1, 10}) {
            c.evaluations = evaluations;
            c.substeps = substeps;
            const double wrong = error(c);
            note("nucleus, kh2/m = 1, error in " + std::to_string(substeps) + " substeps of " +
                     std::to_string(evaluations),
                 wrong);
            REQUIRE(wrong < -0.9);
        }
}

// Stiffness as Nucleus has it: evaluations in 1/24 s (M 2.2).
TEST_CASE("nucleus stretches less with more importance", "[statics][compliance][DC7]") {
    double last = 1e30;
    for (const int importance : {1, 2, 5, 10, 20, 50, 100, 200}) {
        World world = plumbLine({.links = 20, .length = 0.05});
        world.constrain(linksOf(world), {.name = "stretch", .importance = importance});
        const SolverOptions options{
            .method = Method::nucleus, .schedule = {.substeps = 4}, .damping = 0.3};
        Solver<double> solver(world, options);
        advance(solver, 400);
        const double strain = -solver.positions().back().y - 1;
        note("strain of a chain of 20, importance " + std::to_string(importance), strain);
        REQUIRE(strain < last);
        last = strain;
    }
}

// The period of a bob on a soft link, let go at the rest length: 2 pi sqrt(m alpha) in small steps,
// and at any step the period of implicit Euler, which one soft link is: 2 pi h / atan(omega h)
// (A0).
TEST_CASE("a soft link swings at the frequency of a spring", "[statics][compliance][DC5]") {
    for (const double compliance : {1e-2, 1e-3, 1e-4}) {
        const double mass = 0.5, omega = 1 / std::sqrt(mass * compliance);
        const double h = 2 * std::numbers::pi / (omega * 1000);
        World world = plumbLine({.mass = mass});
        world.constrain(linksOf(world, compliance), {.name = "stretch"});
        SolverOptions options{.schedule = {.substeps = 1, .iterations = 1}};
        options.timeScale = 24 * h;
        Solver<double> solver(world, options);
        // Times at which the bob passes its place of rest on its way down, between the steps.
        std::vector<double> passes;
        const double rest = -1 - mass * g * compliance;
        double before = -1;
        for (int step = 0; step < 5500; ++step) {
            solver.frame();
            const double y = solver.positions()[1].y;
            if (before > rest && y <= rest)
                passes.push_back(solver.time() - h * (rest - y) / (before - y));
            before = y;
        }
        REQUIRE(passes.size() == 6);
        const double period = (passes.back() - passes.front()) / 5;
        const double discrete = 2 * std::numbers::pi * h / std::atan(omega * h);
        char name[32];
        std::snprintf(name, sizeof name, "%.0e m/N", compliance);
        REQUIRE(report(std::string("spring of ") + name + ", period against sqrt(k/m)",
                       std::fabs(period * omega / (2 * std::numbers::pi) - 1), 1e-4));
        REQUIRE(report(std::string("spring of ") + name + ", period against the scheme's own",
                       std::fabs(period / discrete - 1), 1e-7));
    }
}
