// What is pinned is let go within a run.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/contacts/surface.h>
#include <plait/rods/rod.h>

using namespace plait;
using namespace plait::test;

namespace {

const Vec<double> speed{0.5, 0, 1};

// A chain that a pin pulls along, and that is let go after half a second.
World pulled(double time = 0.5) {
    World world;
    const Rod rod = addRod(world, chain({.links = 8}), {}, {.name = "rod"});
    const std::vector<int> held{rod.points.first, rod.points.first + 1, rod.directors.first};
    world.pin(held, [](const Vec<double>& x, double t) { return x + t * speed; });
    world.letGo(held, time);
    meet(world, {{.vertices = rod.points, .thickness = 0.001}}, {.order = 1});
    return world;
}

SolverOptions stepping(Integrator integrator) {
    SolverOptions options;
    options.integrator = integrator;
    options.schedule = {.substeps = 7, .iterations = 1, .collisionPasses = 1};
    return options;
}

}  // namespace

TEST_CASE("release: what is let go flies on as it went", "[step]") {
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        World world;
        const Range point = world.add({SimplicialComplex(1), {Vec<double>{}}});
        world.pin({point.first}, [](const Vec<double>& x, double t) { return x + t * speed; });
        world.letGo({point.first}, 0.5);
        Solver<double> solver(world, stepping(integrator));
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        CHECK(report("off its straight way, m", length(solver.positions()[0] - speed), 1e-12));
        CHECK(report("speed, m/s", length(solver.velocities()[0] - speed), 1e-12));
    }
}

TEST_CASE("release: momentum stays from then on, and not before", "[step][rods]") {
    const World world = pulled();
    Solver<double> solver(world, stepping(Integrator::first));
    const auto momentum = [&] {
        Vec<double> sum{};
        for (std::size_t v = 0; v < world.mass.size(); ++v)
            sum += world.mass[v] * solver.velocities()[v];
        return sum;
    };
    for (int frame = 0; frame < 12; ++frame) solver.frame();
    const Vec<double> before = momentum();
    for (int frame = 0; frame < 12; ++frame) solver.frame();
    CHECK(report("momentum lost, part", length(momentum() - before) / length(before), 1e-9));
}

TEST_CASE("release: resumed and rewound to the same bits, before it and after", "[step]") {
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        Solver<float> solver(pulled(), stepping(integrator));
        std::vector<std::uint64_t> hashes;
        for (int frame = 0; frame < 16; ++frame) {
            Solver<float> fresh(pulled(), stepping(integrator));
            fresh.restore(solver.state(), solver.evaluations());
            solver.frame();
            fresh.frame();
            hashes.push_back(solver.hash());
            CHECK(fresh.hash() == hashes.back());
        }
        solver.rewind();
        for (const std::uint64_t hash : hashes) {
            solver.frame();
            CHECK(solver.hash() == hash);
        }
        Solver<float> held(pulled(10), stepping(integrator));
        for (int frame = 0; frame < 16; ++frame) held.frame();
        CHECK(held.hash() != hashes.back());
    }
}

TEST_CASE("release: only what is pinned can be let go", "[step]") {
    World world;
    world.add(chain({.links = 2}));
    world.pin({0});
    CHECK_NOTHROW(world.letGo({0}, 1));
    CHECK_THROWS_WITH(world.letGo({1}, 1), Catch::Contains("vertex 1 is not pinned"));
    CHECK_THROWS_WITH(world.letGo({7}, 1), Catch::Contains("vertex 7"));
    CHECK_THROWS_WITH(world.letGo({0}, std::nan("")), Catch::Contains("no time"));
}
