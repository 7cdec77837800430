// Two liquids in one: who comes to lie below, how far the lighter gives way, and whose viscosity
// slows whom.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/particles/viscosity.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double spacing = 0.01;

// A tank of layers of 8 by 8, the lower half of mass `below`, the upper of mass `above`, kg.
Pool layered(int layers, double below, double above) {
    Pool pool(blockOf(8, layers, 8, spacing, 0.1), spacing, openTank(8 * spacing, 8 * spacing));
    for (std::size_t v = 0; v < pool.world.mass.size(); ++v)
        pool.world.mass[v] = pool.world.start[v].y < layers * spacing / 2 ? below : above;
    pool.fall();
    return pool;
}

double heightOf(const Pool& pool, const std::vector<Vec<double>>& at, double mass) {
    double sum = 0, n = 0;
    for (std::size_t v = 0; v < at.size(); ++v)
        if (pool.world.mass[v] == mass) sum += at[v].y, ++n;
    return sum / n;
}

// %, of the lower half, when sound has gone to and fro and nothing has begun to rise.
double compressionBelow(double below, double above, int substeps) {
    const Pool pool = layered(12, below, above);
    Solver<float> solver(pool.world, perSecond(substeps));
    for (int frame = 0; frame < 5; ++frame) solver.frame();
    const auto ratios = densityRatios(pool.liquid, solver.positions());
    double most = 0;
    for (std::size_t v = 0; v < ratios.size(); ++v)
        if (pool.world.mass[v] == below) most = std::max(most, ratios[v] - 1);
    return 100 * most;
}

}  // namespace

TEST_CASE("phases: the heavier comes to lie below", "[liquid][phases][FL8]") {
    const Pool pool = layered(16, 2e-4, 1e-3);
    Solver<float> solver(pool.world, perSecond(1000));
    CHECK(heightOf(pool, solver.positions(), 1e-3) > heightOf(pool, solver.positions(), 2e-4));
    for (int frame = 0; frame < 100; ++frame) solver.frame();
    const double heavy = heightOf(pool, solver.positions(), 1e-3),
                 light = heightOf(pool, solver.positions(), 2e-4);
    note("after 2 s: middle of the heavier, spacings", heavy / spacing);
    note("of the lighter", light / spacing);
    // Apart, they would be at 4 and 12.
    CHECK(heavy < 5.5 * spacing);
    CHECK(light > 10.5 * spacing);
}

TEST_CASE("phases: a lighter one below is compressed by the ratio, less with more substeps",
          "[liquid][phases][FL8][long]") {
    const double alike = compressionBelow(1e-3, 1e-3, 1000);
    const double ten = compressionBelow(1e-4, 1e-3, 1000);
    const double more = compressionBelow(1e-4, 1e-3, 3200);
    note("of one mass, %", alike);
    note("ten times lighter below, %", ten);
    note("with root 10 times the substeps, %", more);
    CHECK(ten > 3 * alike);
    CHECK(more < ten / 3);
}

TEST_CASE("phases: one's viscosity does not slow the other", "[liquid][phases][viscosity][FL8]") {
    // Side by side, not near each other, in one liquid: a thick and a thin block, both sheared.
    std::vector<Vec<double>> at = blockOf(6, 6, 6, spacing, 0.1);
    const std::size_t half = at.size();
    for (std::size_t v = 0; v < half; ++v) at.push_back(at[v] + Vec<double>{0, 20 * spacing, 0});
    Pool pool(std::move(at), spacing);
    ViscosityOptions options{.viscosity = 1, .factors = std::vector<double>(2 * half, 0)};
    std::fill_n(options.factors.begin(), half, 1.0);
    actViscosity(pool.world, pool.liquid, options);
    for (std::size_t v = 0; v < 2 * half; ++v)
        pool.world.velocity[v] = {std::fmod(pool.world.start[v].y, 20 * spacing) * 10, 0, 0};
    Solver<double> solver(pool.world, perSecond(1000));
    solver.frame();
    const auto v = solver.velocities();
    double thick = 0, thin = 0;
    for (std::size_t i = 0; i < 2 * half; ++i) {
        const double change = length(v[i] - pool.world.velocity[i]);
        (i < half ? thick : thin) = std::max(i < half ? thick : thin, change);
    }
    CHECK(thick > 0.01);
    CHECK(thin < 1e-12);
}
