// The rest shape is one thing, where a world starts another, and the start is kept.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/measure/strain.h>
#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

// A square sheet of 8 x 8 cells of 1/8 m, so that coordinates near the origin are exact; its rest
// shape moved by `shift`, its start `stretched` around the middle and uneven by 1 mm: an exact
// plane has no way out of the folds into which it snaps together.
World sheet(const Vec<double>& shift, double stretched, double compliance = 0) {
    World world;
    Random random(1);
    Shape shape = grid({.columns = 9, .rows = 9});
    Points start;
    for (Vec<double>& x : shape.positions) {
        const Vec<double> middle{0.5, 0.5, 0};
        start.push_back(middle + stretched * (x - middle) +
                        Vec<double>{0, 0, random.uniform(-1e-3, 1e-3)});
        x += shift;
    }
    world.add(shape, {.density = 0.2, .start = start});
    world.constrain(linksOf(world, compliance), {.name = "stretch"});
    return world;
}

double worstStrain(const World& world, const Points& x) {
    std::vector<std::array<int, 2>> edges;
    std::vector<double> rest;
    for (int i = 0; i < world.complex.count(1); ++i) {
        edges.push_back(world.complex.edge(i));
        rest.push_back(length(world.rest[edges.back()[1]] - world.rest[edges.back()[0]]));
    }
    const StrainSummary s = summarizeStrain(x, edges, rest);
    return std::max(s.maximum, -s.minimum);
}

const SolverOptions damped{.schedule = {.substeps = 10, .iterations = 2}, .damping = 0.5};

}  // namespace

TEST_CASE("a sheet let go at 150 % returns to its rest lengths", "[statics][rest][SH10]") {
    for (const double compliance : {0.0, 1e-3}) {
        const World world = sheet({}, 1.5, compliance);
        Solver<double> solver(world, damped);
        REQUIRE(worstStrain(world, solver.positions()) == Approx(0.5).epsilon(1e-3));
        advance(solver, 96);
        REQUIRE(report(
            std::string("edge strain at rest, compliance ") + (compliance > 0 ? "1e-3 m/N" : "0"),
            worstStrain(world, solver.positions()), 1e-6));
    }
}

TEST_CASE("where the rest shape stands does not matter", "[statics][rest][SH10][SH3]") {
    const auto run = [&]<class Real>(const Vec<double>& shift, Real) {
        Solver<Real> solver(sheet(shift, 1.5, 1e-4), damped);
        advance(solver, 10);
        return solver.hash();
    };
    for (const Vec<double>& shift : {Vec<double>{16, -4, 2}, Vec<double>{-1024, 0, 0.5}}) {
        REQUIRE(run(shift, 1.0) == run({}, 1.0));
        REQUIRE(run(shift, 1.0f) == run({}, 1.0f));
    }
}

TEST_CASE("rewound, a run is the same again", "[statics][rest][determinism][AR11][SH9]") {
    World world = sheet({}, 1.25, 1e-4);
    world.act<Gravity>(GravityOptions{});
    world.pin({0, 8}, [](const Vec<double>& x, double t) { return x + Vec<double>{t, 0, -t}; });
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        SolverOptions options = damped;
        options.integrator = integrator;
        Solver<float> solver(world, options);
        const auto start = solver.hash();
        advance(solver, 20);
        const auto end = solver.hash();
        REQUIRE(end != start);
        solver.rewind();
        REQUIRE(solver.time() == 0);
        REQUIRE(solver.hash() == start);
        advance(solver, 20);
        REQUIRE(solver.hash() == end);
        REQUIRE(Solver<float>(world, options).hash() == start);
    }
}
