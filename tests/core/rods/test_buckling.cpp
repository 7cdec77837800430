// When rods leave the plane that they start in: what only bending and twist together decide.
#include "tests/catch.h"
#include "tests/core/rods/rod_worlds.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/forces/field.h>
#include <plait/forces/gravity.h>

#include <cmath>
#include <complex>
#include <functional>
#include <limits>

using namespace plait;
using namespace plait::test;

namespace {

// The load at which growth(load) changes its sign, between two in which it does, within 0.1 %.
double criticalOf(double low, double high, const std::function<double(double)>& growth) {
    while (high / low > 1.001) {
        const double load = std::sqrt(low * high);
        (growth(load) > 0 ? high : low) = load;
    }
    return std::sqrt(low * high);
}

// How fast size() grows (1/s) from one stretch of time to the next.
template <class Size>
double growthOf(Solver<double>& solver, int wait, int frames, const Size& size) {
    const auto largest = [&](int count) {
        double most = 0;
        for (int frame = 0; frame < count; ++frame) {
            solver.frame();
            most = std::max(most, size(solver.positions()));
        }
        return most;
    };
    largest(wait);
    const double early = largest(frames), late = largest(frames);
    return std::log(late / early) / (frames / 24.0);
}

constexpr Wire strip{.along = 0.06, .across = 1e-3};
const double stripLoad = 12.8538 * std::sqrt(strip.twisting() / strip.bending());

// How fast what a kick leaves aside grows in a rod that is clamped at one end, under `load` =
// w L^3 / B, B its weak stiffness: a strip that stands on edge, or one of points only.
double sidewaysUnder(double load, RodModel model = RodModel::framed) {
    RodOptions options{.wire = {.along = 4e-3}, .model = model};
    if (model == RodModel::framed) options = {.wire = strip, .toward = {{0, 1, 0}}};
    World world;
    const Rod rod = addRod(world, clampedLine(32), options, {.name = "strip"});
    clampStart(world, rod);
    const Wire& wire = options.wire;
    const double g = load * wire.bending() / (wire.density * wire.area());
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    for (int v = rod.points.first + 2; v < rod.points.last; ++v)
        world.velocity[v].z = 1e-3 * world.rest[v].x;
    Solver<double> solver(world, stepping(model == RodModel::framed ? 10 : 40, 6));
    return growthOf(solver, 24 * 8, 24 * 8, [&](const std::vector<Vec<double>>& x) {
        return std::fabs(x[rod.points.last - 1].z);
    });
}

}  // namespace

// Prandtl, Michell 1899: w L^3 / B = 12.85 sqrt(C / B), where the strong side is stiff enough.
TEST_CASE("buckling: a strip on edge leaves its plane under its weight", "[rods]") {
    for (const double part : {0.97, 1.03}) {
        const double growth = sidewaysUnder(part * stripLoad);
        note("growth at " + std::to_string(part) + " of the load, 1/s", growth);
        const double excess = growth * (part - 1);
        CHECK(excess > 0);
    }
    const double blind = sidewaysUnder(1.5 * stripLoad, RodModel::straight);
    note("of points only, at 1.5 of the load, 1/s", blind);
    CHECK(blind < 0);
}

TEST_CASE("buckling: the load of a strip on edge", "[rods][long]") {
    const double load = criticalOf(0.9 * stripLoad, 1.1 * stripLoad,
                                   [](double under) { return sidewaysUnder(under); });
    CHECK(report("load off 12.85 sqrt(C / B)", std::fabs(load / stripLoad - 1), 0.03));
}

namespace {

constexpr Wire round{.youngs = 2e9, .along = 4e-3};

// How fast a wave of two crests in a ring of 1 m grows that would be straight, and is twisted by
// `twist` (rad) in all. Early: it ends as a ring of two turns less, through itself.
double waveUnder(double twist, int links) {
    Simplices edges;
    Shape ring;
    for (int v = 0; v < links; ++v) {
        const double at = 2 * pi * v / links, radius = 0.5 / (links * std::sin(pi / links));
        ring.positions.push_back({radius * std::cos(at), radius * std::sin(at), 0});
        edges.edges.push_back({v, (v + 1) % links});
    }
    ring.complex = SimplicialComplex(links, edges);
    World world;
    const Rod rod =
        addRod(world, ring, {.wire = round, .natural = {{0, 0, -twist}}, .toward = {{0, 0, 1}}},
               {.name = "ring"});
    const auto crests = [](int v, int of) { return std::polar(1.0, 4 * pi * v / of); };
    for (int v = 0; v < links; ++v)
        world.velocity[rod.points.first + v].z = 1e-10 * crests(v, links).real();
    Solver<double> solver(world, stepping(20, 6));
    return growthOf(solver, 8, 16, [&](const std::vector<Vec<double>>& x) {
        std::complex<double> sum = 0;
        for (int v = 0; v < links; ++v) sum += x[rod.points.first + v].z * crests(v, links);
        return std::abs(sum);
    });
}

const double ringTwist = 2 * pi * std::sqrt(3.0) * round.bending() / round.twisting();

}  // namespace

// Michell 1889, Zajac 1962: 2 pi sqrt(3) B / C.
TEST_CASE("buckling: a ring leaves its plane when it is twisted", "[rods]") {
    for (const double part : {0.97, 1.03}) {
        const double growth = waveUnder(part * ringTwist, 48);
        note("growth at " + std::to_string(part) + " of the twist, 1/s", growth);
        const double excess = growth * (part - 1);
        CHECK(excess > 0);
    }
}

TEST_CASE("buckling: the twist of a ring", "[rods][long]") {
    for (const int links : {24, 48, 96}) {
        const double twist = criticalOf(0.94 * ringTwist, 1.06 * ringTwist,
                                        [=](double under) { return waveUnder(under, links); });
        CHECK(report(std::to_string(links) + " links, twist off 2 pi sqrt(3) B / C",
                     std::fabs(twist / ringTwist - 1), 0.03));
    }
}
