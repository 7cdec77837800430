// A heavy rod that is clamped and sags, against the exact discrete chain of the same hinge law, so
// that nothing is left but the solver's own error (validation A2).
#include "demos/study/references/heavy_rod.h"
#include "tests/catch.h"
#include "tests/core/rods/rod_worlds.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/forces/gravity.h>
#include <plait/rods/bend_vector.h>
#include <plait/rods/chain_set.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

// A rod of 1 m and 1 kg, in any unit of length, clamped in its first link.
struct HeavyRod {
    double gamma;  // w L^3 / B, weight against stiffness
    int links;
    int substeps;       // in 1/60 s
    double length = 1;  // units in a metre
    double turn = 0;    // rad, of everything
    bool reversed = false, asAngle = false;
    double seconds = 8;

    double link() const { return length / (links - 0.5); }
    double g() const { return 9.81 * length; }
    double weight() const { return g() / length; }  // of a unit of length
    double stiffness() const { return weight() * length * length * length / gamma; }

    Vec<double> placed(const Vec<double>& p) const {
        const double c = std::cos(turn), s = std::sin(turn);
        const Vec<double> q{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
        return {c * q.x + s * q.z, q.y, c * q.z - s * q.x};
    }
};

struct Tip {
    double reach, drop, aside;  // of the length
    double speed;               // m/s, of the fastest vertex
};

template <class Rows>
void turnRound(Rows& rows, int arity) {
    const auto count = static_cast<std::size_t>(arity);
    for (std::size_t i = 0, j = rows.ids.size() - count; i < j; i += count, j -= count)
        for (std::size_t a = 0; a < count; ++a) std::swap(rows.ids[i + a], rows.ids[j + a]);
    for (std::size_t i = 0; i < rows.ids.size(); i += count)
        std::reverse(rows.ids.begin() + static_cast<long>(i),
                     rows.ids.begin() + static_cast<long>(i + count));
    std::ranges::reverse(rows.rows);
}

template <class Real>
Tip simulate(const HeavyRod& rod) {
    World world;
    const double l = rod.link();
    const Range all = world.add(chain({.links = rod.links,
                                       .from = rod.placed({-l / 2, 0, 0}),
                                       .to = rod.placed({rod.length, 0, 0})}),
                                {.density = 1 / rod.length});
    world.pin({all.first, all.first + 1});
    world.act<Gravity>(GravityOptions{.acceleration = rod.placed({0, -rod.g(), 0})});
    Chains chains;
    chains.addCurve(pointStencils(all));
    auto links = restRows<Stretch>(edgeStencils(world.complex, all), world.rest);
    Rows<BendVector> bends;
    bends.ids = jointStencils(world.complex, all);
    bends.rows.assign(bends.ids.size() / 3, {l / rod.stiffness()});
    if (rod.reversed) {
        turnRound(links, 2);
        turnRound(bends, 3);
    }
    chains.add(links);
    if (rod.asAngle)
        chains.add(curveBendRows(world.complex, all, world.rest, rod.stiffness()));
    else
        chains.add(bends);
    chains.constrain(world, {.name = "rod"});
    SolverOptions options{
        .sweeps = Sweeps::oneWay,
        .schedule = {.substeps = rod.substeps, .frameRate = {60, 1}, .iterations = 1}};
    options.damping = 1 - std::exp(-4.0 / 24);
    Solver<Real> solver(world, options);
    double speed = 0;
    for (int frame = 0; frame < 60 * rod.seconds; ++frame) {
        solver.frame();
        speed = std::max(rod.asAngle ? speed : 0, fastest(solver));
    }
    const Vec<double> tip = solver.positions().back();
    const auto along = [&](const Vec<double>& axis) {
        return dot(tip, rod.placed(axis)) / rod.length;
    };
    return {along({1, 0, 0}), -along({0, 1, 0}), std::fabs(along({0, 0, 1})), speed};
}

// Of the length: how far the tip is from where it belongs.
double off(const Tip& tip, const HeavyRod& rod) {
    const RodTip truth = heavyRodTip(rod.gamma, rod.links);
    return std::hypot(tip.reach - truth.reach, tip.drop - truth.drop);
}

}  // namespace

TEST_CASE("elastica: a heavy rod sags as its discrete chain does", "[rods][DC1][SH8][DC9]") {
    for (const double gamma : {0.1, 10.0, 1000.0})
        for (const int links : {8, 64})
            for (const int substeps : {2, 10}) {
                const HeavyRod rod{.gamma = gamma, .links = links, .substeps = substeps};
                const Tip tip = simulate<float>(rod);
                const std::string name = "gamma " + std::to_string(gamma) + ", " +
                                         std::to_string(links) + " links, " +
                                         std::to_string(substeps) + " substeps";
                CHECK(report(name + ", tip off", off(tip, rod), substeps < 10 ? 3e-3 : 5e-4));
                CHECK(report(name + ", speed, m/s", tip.speed, 1e-5));
            }
}

TEST_CASE("elastica: any load, mesh and number of substeps", "[rods][long]") {
    for (const double gamma : {0.1, 1.0, 10.0, 100.0, 1000.0})
        for (const int substeps : {2, 10, 50, 400}) {
            double worst = 0, speed = 0;
            for (const int links : {8, 16, 32, 64, 128, 256, 512}) {
                if (substeps == 400 && links > 64 && gamma != 10) continue;
                const HeavyRod rod{.gamma = gamma, .links = links, .substeps = substeps};
                const Tip tip = simulate<float>(rod);
                worst = std::max(worst, off(tip, rod));
                speed = std::max(speed, tip.speed);
            }
            const std::string name = "gamma " + std::to_string(gamma) + ", 8 to 512 links, " +
                                     std::to_string(substeps) + " substeps";
            CHECK(report(name + ", tip off", worst, substeps < 10 ? 3e-3 : 5e-4));
            CHECK(report(name + ", speed, m/s", speed, 1e-5));
        }
}

// Against theta'' = -gamma (1 - s) cos theta, by an independent solver (validation A3).
TEST_CASE("elastica: 64 links clamped in the middle of one are the continuum", "[rods]") {
    constexpr struct {
        double gamma, drop, reach;
    } table[] = {{0.1, .012498, .999911}, {1, .123471, .991246},   {5, .495905, .846657},
                 {10, .700200, .656354},  {100, .937524, .159223}, {1000, .981141, .045986}};
    for (const auto& truth : table) {
        const HeavyRod rod{.gamma = truth.gamma, .links = 64, .substeps = 10};
        const RodTip mesh = heavyRodTip(rod.gamma, rod.links);
        const Tip tip = simulate<float>(rod);
        const std::string name = "gamma " + std::to_string(truth.gamma);
        const double slope = truth.drop / truth.reach;
        note(name + ", drop, error of the mesh", mesh.drop / truth.drop - 1);
        note(name + ", drop, error of the solver", tip.drop / mesh.drop - 1);
        CHECK(report(name + ", drop off", std::fabs(tip.drop / truth.drop - 1), 2e-3));
        CHECK(report(name + ", H/W off", std::fabs(tip.drop / tip.reach / slope - 1), 1.5e-2));
        const RodTip held = heavyRodTip(rod.gamma, rod.links, 1);
        const double whole = held.drop / held.reach / slope - 1;
        note(name + ", H/W off by a whole hinge at the root", whole);
        CHECK(whole > 0.03);
    }
}

TEST_CASE("elastica: segments of 1 : 10 in any order droop as equal ones do", "[rods]") {
    constexpr int links = 64;
    constexpr double gamma = 10;
    const Wire wire{.along = 4e-3};
    const RodTip equal = heavyRodTip(gamma, links);
    for (const unsigned seed : {1U, 2U, 3U}) {
        Random random(seed);
        std::vector<double> lengths, loads(links - 1);
        for (int e = 0; e < links; ++e) lengths.push_back(std::pow(10, random.uniform(0, 1)));
        double whole = -lengths[0] / 2;
        for (const double l : lengths) whole += l;
        for (double& l : lengths) l /= whole;
        Shape line = chain({.links = links});
        line.positions[0] = {-lengths[0] / 2, 0, 0};
        for (int e = 0; e < links; ++e)
            line.positions[e + 1] = line.positions[e] + Vec<double>{lengths[e], 0, 0};

        World world;
        const Rod rod =
            addRod(world, line, {.wire = wire, .model = RodModel::straight}, {.name = "rod"});
        clampStart(world, rod);
        const double g = gamma * wire.bending() / (wire.density * wire.area());
        world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
        Solver<float> solver(world, stepping(25, 4));
        for (int frame = 0; frame < 24 * 8; ++frame) solver.frame();
        const Vec<double> tip = solver.positions().back();

        double load = 0;
        for (int e = links - 1; e > 0; --e) loads[e - 1] = load += g * world.mass[e + 1];
        const std::vector<double> angles = hangingAngles(lengths, wire.bending(), loads);
        RodTip truth{lengths[0] / 2, 0};
        for (int e = 1; e < links; ++e) {
            truth.reach += lengths[e] * std::cos(angles[e - 1]);
            truth.drop += lengths[e] * std::sin(angles[e - 1]);
        }
        CHECK(
            report("tip off its chain", std::hypot(tip.x - truth.reach, tip.y + truth.drop), 5e-4));
        CHECK(report("drop off that of equal ones", std::fabs(truth.drop / equal.drop - 1), 1e-2));
        CHECK(report("speed, m/s", fastest(solver), 1e-5));
    }
}

TEST_CASE("elastica: turned, reversed, in mm and km it is the same", "[rods]") {
    const HeavyRod plain{.gamma = 10, .links = 32, .substeps = 10};
    HeavyRod turned = plain, reversed = plain, small = plain, large = plain;
    turned.turn = 0.7;
    reversed.reversed = true;
    small.length = 1e3;
    large.length = 1e-3;
    for (const auto& [name, rod] : {std::pair{"as it is", plain},
                                    {"turned", turned},
                                    {"rows reversed", reversed},
                                    {"in mm", small},
                                    {"in km", large}}) {
        const Tip tip = simulate<float>(rod);
        CHECK(report(std::string(name) + ", tip off", off(tip, rod), 5e-4));
        CHECK(report(std::string(name) + ", aside", tip.aside, 1e-6));
    }
}

// A cone where the rod is straight: solved at once with all others, it never rests.
TEST_CASE("elastica: bending as an angle is seen to fly", "[rods]") {
    const Tip tip = simulate<float>(
        {.gamma = 10, .links = 64, .substeps = 10, .turn = 0.7, .asAngle = true, .seconds = 2});
    note("fastest, m/s", tip.speed);
    CHECK(tip.speed > 100);
}

// With tensions that act where links were, it whips at 20 m/s.
TEST_CASE("elastica: a soft taut rod hangs still", "[rods]") {
    const HeavyRod rod{.gamma = 1e5, .links = 256, .substeps = 10};
    const Tip tip = simulate<float>(rod);
    CHECK(report("speed, m/s", tip.speed, 1e-5));
    CHECK(report("tip off", off(tip, rod), 5e-4));
}
