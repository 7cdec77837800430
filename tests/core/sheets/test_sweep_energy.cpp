// What the direction of sweeps (design section 5) does to whole runs: the growth that the linear
// theory of test_sweeps.cpp foretells, and sheets of rigid links that hang by two corners.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/sheet.h"

#include <plait/measure/energy.h>
#include <plait/measure/surfaces/intersections.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

struct Run {
    int columns = 52, rows = 35;
    int substeps = 20;  // in 1/60 s
    int frames = 60;
    Sweeps direction = Sweeps::palindrome;
    int evaluations = 1;  // in a substep; a palindrome sweeps twice
    Integrator integrator = Integrator::bdf2;
};

struct Outcome {
    double energy = -1e30;  // J, the highest at the end of any frame, kinetic and of position; the
                            // start has 0
    double worstStrain = 0;
    int crossings = 0;  // of edges and triangles, at the end
};

// A sheet 1 m wide of 0.2 kg/m^2, flat and at rest, let go from two corners.
Outcome hang(const Run& run) {
    World world;
    world.add(grid({.columns = run.columns,
                    .rows = run.rows,
                    .height = double(run.rows - 1) / (run.columns - 1)},
                   {.across = {1, 0, 0}, .up = {0, 0, 1}}),
              {.density = 0.2});
    world.pin({0, run.columns - 1});
    world.act<Gravity>(GravityOptions{});
    const Rows<Stretch> links = sheetLinks(world, run.columns, run.rows);
    world.constrain(links, {.name = "stretch"});
    SolverOptions options{.integrator = run.integrator, .sweeps = run.direction};
    options.schedule = {
        .substeps = run.substeps, .frameRate = {60, 1}, .iterations = run.evaluations};

    Outcome outcome;
    Solver<double> solver(world, options);
    for (int frame = 0; frame < run.frames; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        outcome.energy =
            std::max(outcome.energy, kineticEnergy(world.mass, solver.velocities()) +
                                         gravitationalEnergy(world.mass, x, {0, -9.81, 0}));
        for (const double e : strainsOf(links, x))
            outcome.worstStrain = std::max(outcome.worstStrain, e);
    }
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < world.complex.count(2); ++i) triangles.push_back(world.complex.triangle(i));
    outcome.crossings = countIntersections(solver.positions(), triangles);

    const bool both = run.direction == Sweeps::palindrome;
    std::printf(
        "    %3d x %d, %4d substeps of %d %-12s E %+10.2e J  strain %6.2f %%  crossings %5d\n",
        run.columns, run.rows, run.substeps, run.evaluations, both ? "palindromes" : "one-way",
        outcome.energy, 100 * outcome.worstStrain, outcome.crossings);
    return outcome;
}

// How much a small motion of a sheet grows in a substep, by its speed between two substeps.
double growthBetween(int from, int to, int n, Sweeps direction, Integrator integrator) {
    World world = bentSheet(n, 0.2);
    Random random(3);
    for (std::size_t v = 0; v < world.velocity.size(); ++v)
        if (!world.pinned[v]) world.velocity[v] = random.point(1e-9);
    SolverOptions options = stepping(1000, integrator);
    options.sweeps = direction;
    Solver<double> solver(world, options);
    const auto speed = [&] { return std::sqrt(kineticEnergy(world.mass, solver.velocities())); };
    advance(solver, from);
    const double before = speed();
    advance(solver, to - from);
    return std::pow(speed() / before, 1.0 / (to - from));
}

}  // namespace

TEST_CASE("small motions grow in the solver as linear theory says", "[sweeps]") {
    struct Growth {
        const char* what;
        int n, from, to;
        Sweeps direction;
        Integrator integrator;
        double expected;  // of test_sweeps.cpp
    };
    for (const Growth& g :
         {Growth{"one-way, first order", 10, 1200, 2800, Sweeps::oneWay, Integrator::first, 1.0073},
          Growth{"one-way, BDF2", 6, 500, 1500, Sweeps::oneWay, Integrator::bdf2, 1.0104},
          Growth{"alternating", 8, 30, 80, Sweeps::alternating, Integrator::first, 1.2605}})
        REQUIRE(report(std::string(g.what) + ", growth a substep, relative error of its excess",
                       std::fabs((growthBetween(g.from, g.to, g.n, g.direction, g.integrator) - 1) /
                                     (g.expected - 1) -
                                 1),
                       0.1));
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2})
        REQUIRE(growthBetween(0, 3000, 10, Sweeps::palindrome, integrator) < 1);
}

TEST_CASE("with palindromes a hanging sheet gains no energy, one-way it does", "[sweeps]") {
    Run run{.columns = 16, .rows = 16, .substeps = 750, .frames = 20};
    run.integrator = Integrator::first;
    REQUIRE(hang(run).energy <= 0);
    run.direction = Sweeps::oneWay;
    REQUIRE(hang(run).energy > 0.01);
}

TEST_CASE("a hanging sheet of 32 x 32, 1,500 substeps a frame", "[sweeps][long]") {
    Run run{.columns = 32, .rows = 32, .substeps = 1500, .frames = 120};
    run.integrator = Integrator::first;
    REQUIRE(hang(run).energy <= 0);
    run.direction = Sweeps::oneWay;
    REQUIRE(hang(run).energy > 0.1);
}

// Where BDF2 is stable on sheets of rigid links: with palindromes, any number of them in any number
// of substeps, converged or not. A palindrome's eigenvalues are in [0, 1], and there BDF2 is stable
// whatever they are (test_sweeps.cpp). One-way sweeps have complex ones, and BDF2 damps slow
// motions by the fourth power of their angle a substep where first order damps by the square: it
// has next to nothing to set against them. More one-way sweeps a substep crumple less and still
// gain energy.
TEST_CASE("BDF2 crumples a sheet one-way and not with palindromes", "[sweeps]") {
    const Outcome oneWay = hang({.direction = Sweeps::oneWay});
    const Outcome palindrome = hang({.direction = Sweeps::palindrome});
    REQUIRE(oneWay.energy > 0.1);
    REQUIRE(oneWay.crossings > 1000);
    REQUIRE(palindrome.energy <= 0);
    REQUIRE(palindrome.crossings < 100);
}

TEST_CASE("BDF2 is stable with palindromes, few or many, converged or not", "[sweeps][long]") {
    for (const int substeps : {5, 20, 50, 200})
        for (const int evaluations : {1, 2, 4}) {
            const Run run{.substeps = substeps, .frames = 120, .evaluations = evaluations};
            const Outcome outcome = hang(run);
            REQUIRE(outcome.energy <= 0);
            REQUIRE(outcome.crossings < 400);
        }
    for (const int evaluations : {1, 2, 4}) {
        const Run run{.substeps = 100,
                      .frames = 120,
                      .direction = Sweeps::oneWay,
                      .evaluations = evaluations};
        REQUIRE(hang(run).energy > 0.1);
    }
}
