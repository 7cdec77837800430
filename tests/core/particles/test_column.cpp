// Water at rest in a tank: how far it is compressed, where its level is, what the floor carries.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/particles/liquid_set.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, height = 1;  // m/s^2, m

struct Column {
    int across, layers, perSecond;
    double spacing() const { return height / layers; }
    double width() const { return across * spacing(); }
    Pool pool(std::vector<Vec<double>> positions) const {
        Pool pool(std::move(positions), spacing(), openTank(width(), width()));
        pool.fall(g);
        return pool;
    }
};

// Poured as a shaken lattice and stilled for two seconds.
Pool stilled(const Column& column) {
    const Pool poured =
        column.pool(blockOf(column.across, column.layers, column.across, column.spacing(), 0.1));
    SolverOptions options = perSecond(column.perSecond);
    options.damping = 0.3;
    Solver<float> solver(poured.world, options);
    for (int frame = 0; frame < 100; ++frame) solver.frame();
    return column.pool(solver.positions());
}

// Upward force of walls on the liquid in the last substep, over its weight.
double carried(const Solver<float>& solver, const Pool& pool) {
    const auto& set = dynamic_cast<const LiquidSet<float>&>(solver.set(0));
    double sum = 0, weight = 0;
    for (std::size_t s = 0; s < set.vertices().size(); ++s)
        sum += double(set.multipliers()[s]) * double(set.wall()[s].v.y);
    for (const double mass : pool.world.mass) weight += mass * g;
    return sum / (solver.substepLength() * solver.substepLength()) / weight;
}

// By another kernel (Wendland C2) of four spacings, against the mean that it has in a continuum;
// walls are mirrors. Of what is that far below the surface, one in `every`.
double meanByAnother(const Column& column, const std::vector<Vec<double>>& x, std::size_t every) {
    const double radius = 4 * column.spacing(), w = column.width();
    double top = 0, sum = 0;
    for (const Vec<double>& p : x) top = std::max(top, p.y);
    int count = 0;
    for (std::size_t i = 0; i < x.size(); i += every) {
        if (x[i].y > top - 1.2 * radius) continue;
        ++count;
        for (const Vec<double>& p : x)
            for (const double px : {p.x, -p.x, 2 * w - p.x})
                for (const double py : {p.y, -p.y})
                    for (const double pz : {p.z, -p.z, 2 * w - p.z}) {
                        const double q = length(Vec<double>{px, py, pz} - x[i]) / radius;
                        if (q < 1) sum += (1 - q) * (1 - q) * (1 - q) * (1 - q) * (1 + 4 * q);
                    }
    }
    const double integral = 2 * pi / 21 * 64;  // of the kernel, in cubes of spacing
    return sum / count / integral;
}

struct Rest {
    double largest = 0, mean = 0;  // compression, of frames from `from` on
    double floor = 0;              // what it carries, of the weight
    double centre = 0, slant = 0;  // height of the centre; left's over right's
    double speed = 0;              // rms at the end, of sqrt(g H)
    std::vector<Vec<double>> x;
};

Rest rest(const Column& column, int frames, int from) {
    const Pool pool = stilled(column);
    Solver<float> solver(pool.world, perSecond(column.perSecond));
    Rest rest;
    double left = 0, right = 0;
    const int counted = frames - from;
    for (int frame = 0; frame < frames; ++frame) {
        solver.frame();
        if (frame < from) continue;
        rest.x = solver.positions();
        const std::vector<double> ratios = densityRatios(pool.liquid, rest.x);
        const auto n = static_cast<double>(ratios.size());
        for (const double ratio : ratios) {
            rest.largest = std::max(rest.largest, ratio - 1);
            rest.mean += std::max(ratio - 1, 0.0) / n / counted;
        }
        for (const Vec<double>& p : rest.x) {
            rest.centre += p.y / n / counted;
            (p.x < column.width() / 2 ? left : right) += p.y;
        }
        rest.floor += carried(solver, pool) / counted;
    }
    rest.slant = left / right;
    for (const Vec<double>& v : solver.velocities())
        rest.speed += dot(v, v) / (g * height) / static_cast<double>(rest.x.size());
    rest.speed = std::sqrt(rest.speed);
    return rest;
}

void check(const Column& column, const Rest& rest, std::size_t every) {
    const Pool pool = column.pool(rest.x);
    const double rule = restCompression(pool.liquid, height, g, 1.0 / column.perSecond);
    note("largest compression", rest.largest);
    REQUIRE(report("of it, off restCompression", std::fabs(rest.largest / rule - 1), 0.15));
    REQUIRE(report("mean of it, off 0.45 of restCompression",
                   std::fabs(rest.mean / rule / 0.45 - 1), 0.1));
    REQUIRE(report("its level", std::fabs(rest.centre / (height / 2) - 1), 0.01));
    REQUIRE(report("what the floor carries", std::fabs(rest.floor - 1), 5e-3));
    REQUIRE(report("left against right", std::fabs(rest.slant - 1), 0.01));
    REQUIRE(report("density by another kernel, without what it is compressed",
                   std::fabs(meanByAnother(column, rest.x, every) - 1 - rest.mean), 5e-3));
    note("rms velocity, of sqrt(g H)", rest.speed);
}

}  // namespace

TEST_CASE("liquid: a column at rest is compressed as foretold and keeps its level",
          "[liquid][figures][DC16][FL1]") {
    const Column column{.across = 8, .layers = 24, .perSecond = 1400};
    check(column, rest(column, 150, 100), 1);
}

// That it dies out is what a relaxation of 0.25 is for.
TEST_CASE("liquid: a column of 48 layers stands for a minute", "[liquid][long][DC16][FL1]") {
    const Column column{.across = 8, .layers = 48, .perSecond = 2400};
    const Rest soon = rest(column, 400, 350), late = rest(column, 3000, 2900);
    check(column, late, 3);
    REQUIRE(late.largest < 0.01);
    REQUIRE(report("its level, ten seconds from now and a minute",
                   std::fabs(late.centre / soon.centre - 1), 2e-3));
    REQUIRE(report("rms velocity, of sqrt(g H)", late.speed, 2e-3));
}
