// What crosses after all passes goes back together, by the mean of where it was going.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>

using namespace plait;
using namespace plait::test;

namespace {

// A lattice of triangles that fly every which way, each past several others in a substep; `pinned`
// of them do not. All goes along with `wind` (m/s).
World swarm(int pinned, const Vec<double>& wind) {
    Random random(3);
    World world;
    std::vector<Surface> surfaces;
    constexpr int side = 4;
    for (int n = 0; n < side * side * side; ++n) {
        const Vec<double> at =
            0.1 * Vec<double>{n % side * 1.0, n / side % side * 1.0, n / (side * side) * 1.0};
        const Vec<double> velocity = random.point(40) + wind;
        Points corners;
        for (int i = 0; i < 3; ++i) corners.push_back(at + random.point(0.04));
        const Range range =
            world.add({SimplicialComplex(3, {{}, {{0, 1, 2}}, {}}), corners},
                      {.density = random.uniform(0.5, 2), .velocity = Points(3, velocity)});
        if (n < pinned) world.pin(pointStencils(range));
        surfaces.push_back(
            {.vertices = range, .thickness = 1e-4, .staticFriction = 0, .dynamicFriction = 0});
    }
    meet(world, surfaces, {.order = 1});
    return world;
}

}  // namespace

TEST_CASE("zones: what goes back keeps its momentum, seen from anywhere", "[contacts]") {
    const Vec<double> wind{3, -1, 2};
    const World world = swarm(0, {}), flown = swarm(0, wind);
    Solver<double> solver(world, meeting(1, 1)), flying(flown, meeting(1, 1));
    const Vec<double> before = momentum(world.mass, world.velocity);
    double scale = 0, apart = 0;
    for (std::size_t v = 0; v < world.mass.size(); ++v)
        scale += world.mass[v] * length(world.velocity[v]);
    solver.frame();
    flying.frame();
    CHECK(countsOf(solver, world).heldBack > 10);
    CHECK(solver.failures() == 0);
    CHECK(countIntersections(solver.positions(), trianglesOf(world)) == 0);
    const Vec<double> lost = momentum(world.mass, solver.velocities()) - before;
    CHECK(report("momentum lost, part", length(lost) / scale, 1e-12));
    for (std::size_t v = 0; v < world.mass.size(); ++v)
        apart = std::max(apart, length(flying.velocities()[v] - wind - solver.velocities()[v]));
    CHECK(report("velocities seen from a train, m/s", apart, 1e-9));
}

TEST_CASE("zones: what is pinned holds what crosses it", "[contacts]") {
    const World world = swarm(8, {});
    Solver<double> solver(world, meeting(1, 1));
    solver.frame();
    CHECK(countsOf(solver, world).heldBack > 10);
    CHECK(solver.failures() == 0);
    CHECK(countIntersections(solver.positions(), trianglesOf(world)) == 0);
}
