// Where sweeps fail a free balloon: the pressure has no torque and every link is central, and it
// spins, in double. Each correction acts along a link where that is at the time, and no longer
// where its ends stop; under stress that is a torque.
#include "gas_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

struct Spun {
    double rate, drift, pressure;  // rad/s, m, part of what its springs bear
};

// Jolt's balloon: 1 m, 0.1 kg, springs of 1000 N/m, gas for a stretch of `lambda` let in during the
// first second; after two.
Spun spun(double lambda, double outside, int substeps) {
    constexpr double k = 1000;
    World world;
    const Range ball = addBall(world, 1, 3);
    for (double& m : world.mass) m = 0.1 / static_cast<double>(world.mass.size());
    addSprings(world, ball, k);
    const Enclosure enclosure = enclose(world, {ball});
    const double inside = volume(enclosure, world.rest);
    // The mesh's own gauge pressure there, by virtual work.
    double work = 0;
    for (int e = 0; e < world.complex.count(1); ++e) {
        const auto [a, b] = world.complex.edge(e);
        const double l = length(world.rest[a] - world.rest[b]);
        work += k * (lambda - 1) * l * l;
    }
    const double gauge = work / (3 * inside * lambda * lambda);
    const double full = (outside + gauge) * lambda * lambda * lambda;
    holdGas(world, enclosure,
            [=](double t) {
                const double part = std::min(t, 1.0);
                return Gas{.amount = (outside + (full - outside) * part) * inside,
                           .outside = outside};
            },
            {.name = "air", .order = 1, .importance = 1});
    Solver<double> solver(
        world, {.schedule = {.substeps = substeps, .frameRate = {60, 1}, .iterations = 1}});
    for (int frame = 0; frame < 120; ++frame) solver.frame();
    const auto x = solver.positions(), v = solver.velocities();
    Vec<double> centre{}, momentum{};
    double inertia = 0;
    for (const Vec<double>& at : x) centre += 1 / static_cast<double>(x.size()) * at;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec<double> r = x[i] - centre;
        momentum += world.mass[i] * cross(r, v[i]);
        inertia += world.mass[i] * 2 / 3 * dot(r, r);
    }
    return {length(momentum) / inertia, length(centre), pressureOf(solver, 1) / gauge};
}

}  // namespace

TEST_CASE("gas: swept balloons under stress spin, those without do not", "[gas][long][AW15]") {
    for (const double outside : {0.0, 101325.0})
        for (const int substeps : {20, 50, 100}) {
            const Spun ball = spun(1.2, outside, substeps);
            const std::string where =
                (outside > 0 ? "air, " : "a vacuum, ") + std::to_string(substeps) + " substeps";
            note("spin of a swept balloon in " + where + ", rad/s", ball.rate);
            note("its pressure, of what its springs bear", ball.pressure);
            REQUIRE(ball.rate > 1);
            REQUIRE(report("its drift, m", ball.drift, 1e-11));
        }
    const Spun limp = spun(1, 101325, 20);
    REQUIRE(report("spin without stress, rad/s", limp.rate, 1e-9));
}
