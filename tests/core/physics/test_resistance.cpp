// What cloth resists besides stretch: compression, bending, and a rest length that shrinks
#include "cantilever.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/measure/strain.h>
#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81;

// A mass of 1 kg at a height of 1 m on legs from the floor, pinned there. Returns its height at
// rest.
double heightOnLegs(const Points& feet, double compression, double extension = 0) {
    World world;
    Simplices edges;
    Shape shape{{}, feet};
    const int apex = static_cast<int>(feet.size());
    shape.positions.push_back({0, 1, 0});
    std::vector<int> pinned;
    for (int foot = 0; foot < apex; ++foot) {
        edges.edges.push_back({foot, apex});
        pinned.push_back(foot);
    }
    shape.complex = SimplicialComplex(apex + 1, edges);
    world.add(shape);
    world.mass.assign(world.mass.size(), 1);
    world.pin(pinned);
    world.act<Gravity>(GravityOptions{});
    Rows<Stretch> legs = linksOf(world, extension);
    for (Stretch::Row<double>& row : legs.rows) row.compression = compression;
    world.constrain(legs, {.name = "legs"});
    Solver<double> solver(world, {.schedule = {.substeps = 40, .iterations = 2}, .damping = 0.5});
    advance(solver, 150);
    REQUIRE(topSpeed(solver) < 1e-6);
    return solver.positions().back().y;
}

}  // namespace

TEST_CASE("a strut holds or buckles by its compression resistance alone",
          "[statics][resistance][DC8]") {
    const Points strut{{0, 0, 0}};
    REQUIRE(report("rigid strut, m", std::fabs(heightOnLegs(strut, 0) - 1), 1e-6));
    REQUIRE(report("slack strut hangs, m", std::fabs(heightOnLegs(strut, slack) + 1), 1e-3));
    // Its compliance in extension has no part in it, nor the other way round.
    for (const double compression : {1e-4, 1e-3, 1e-2})
        REQUIRE(report(
            "strut gives way by load times compliance",
            std::fabs((1 - heightOnLegs(strut, compression, 5e-3)) / (g * compression) - 1), 1e-6));
    REQUIRE(report("slack strut, soft in extension, m",
                   std::fabs(heightOnLegs(strut, slack, 1e-3) + 1 + g * 1e-3), 1e-6));

    // A tripod, which stands by itself.
    const Points feet{{0.6, 0, 0}, {-0.3, 0, 0.5}, {-0.3, 0, -0.5}};
    REQUIRE(report("rigid tripod, m", std::fabs(heightOnLegs(feet, 0) - 1), 1e-4));
    const double slackHeight = heightOnLegs(feet, slack);
    REQUIRE(report("slack tripod hangs, m", std::fabs(slackHeight + 1), 1e-3));
    double last = 1;
    for (const double compression : {1e-4, 1e-3, 1e-2}) {
        const double height = heightOnLegs(feet, compression);
        REQUIRE(height < last);
        last = height;
    }
}

TEST_CASE("a shrinking rest length takes the edges along, gently if gradual",
          "[statics][resistance][DC11]") {
    const double scale = 0.6;
    const auto shrink = [&](double seconds) {
        World world;
        world.add(grid({.columns = 7, .rows = 7}), {.density = 0.2});
        Rows<Stretch> rows = linksOf(world, 1e-4);
        rows.animate = [rest = rows.rows, scale, seconds](double t,
                                                          std::span<Stretch::Row<double>> row) {
            const double part = t < seconds ? t / seconds : 1;
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i].rest = rest[i].rest * (1 + (scale - 1) * part);
        };
        world.constrain(rows, {.name = "stretch"});
        Solver<double> solver(world,
                              {.schedule = {.substeps = 20, .iterations = 2}, .damping = 0.5});
        double peak = 0;
        for (int frame = 0; frame < 96; ++frame) {
            solver.frame();
            peak = std::max(peak, topSpeed(solver));
        }
        std::vector<std::array<int, 2>> edges;
        std::vector<double> target;
        for (int i = 0; i < world.complex.count(1); ++i) {
            edges.push_back(world.complex.edge(i));
            target.push_back(scale *
                             length(world.rest[edges.back()[1]] - world.rest[edges.back()[0]]));
        }
        const StrainSummary s = summarizeStrain(solver.positions(), edges, target);
        REQUIRE(report("edges at scale times rest, after " + std::to_string(seconds) + " s",
                       std::max(s.maximum, -s.minimum), 1e-6));
        return peak;
    };
    const double snapped = shrink(1e-6), ramped = shrink(2);
    note("peak speed, snapped, m/s", snapped);
    note("peak speed, ramped, m/s", ramped);
    REQUIRE(ramped < 0.2 * snapped);
}

namespace {

// H / W by Gamma = w L^3 / B (validation A3).
constexpr std::pair<double, double> elastica[] = {{1, 0.124562},  {2, 0.246673},  {5, 0.585721},
                                                  {10, 1.066802}, {20, 1.863930}, {50, 3.705561}};

void checkCantilever(int links, const ScheduleOptions& schedule, double bound) {
    double last = 0;
    for (const auto& [gamma, exact] : elastica) {
        const Droop d = cantilever(gamma, links, schedule);
        REQUIRE(d.rests);
        char name[80];
        std::snprintf(name, sizeof name, "cantilever of %d links, Gamma %g, H/W %.5f", links, gamma,
                      d.drop / d.reach);
        REQUIRE(report(name, std::fabs(d.drop / d.reach / exact - 1), bound));
        REQUIRE(d.drop > last);
        last = d.drop;
    }
}

}  // namespace

TEST_CASE("a cantilever droops less the stiffer it is", "[statics][resistance][DC9]") {
    checkCantilever(16, {.substeps = 200, .iterations = 1}, 0.02);
    const Droop d = cantilever(10, 32, {.substeps = 600, .iterations = 1});
    REQUIRE(d.rests);
    REQUIRE(report("cantilever of 32 links, Gamma 10", std::fabs(d.drop / d.reach / 1.066802 - 1),
                   0.002));
}

TEST_CASE("a cantilever of 32 links against the elastica", "[statics][resistance][long][DC9]") {
    checkCantilever(32, {.substeps = 1600, .iterations = 1}, 0.005);
}
