// A heavy rod that is clamped and sags, against the exact discrete chain of the same hinge law, so
// that nothing is left but the solver's own error (validation A2).
#include "demos/study/references/heavy_rod.h"
#include "tests/catch.h"
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

// A rod of 1 m and 1 kg, in any unit of length, clamped in the middle of its first link.
struct Rod {
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
Tip simulate(const Rod& rod) {
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
    double fastest = 0;
    for (int frame = 0; frame < 60 * rod.seconds; ++frame) {
        solver.frame();
        if (!rod.asAngle) fastest = 0;
        for (const Vec<double>& v : solver.velocities()) fastest = std::max(fastest, length(v));
    }
    const Vec<double> tip = solver.positions().back();
    const auto along = [&](const Vec<double>& axis) {
        return dot(tip, rod.placed(axis)) / rod.length;
    };
    return {along({1, 0, 0}), -along({0, 1, 0}), std::fabs(along({0, 0, 1})), fastest};
}

// Of the length: how far the tip is from where it belongs.
double off(const Tip& tip, const Rod& rod) {
    const RodTip truth = heavyRodTip(rod.gamma, rod.links);
    return std::hypot(tip.reach - truth.reach, tip.drop - truth.drop);
}

}  // namespace

// [DC1][DC3]
TEST_CASE("elastica: a heavy rod sags as its discrete chain does", "[rods]") {
    for (const double gamma : {0.1, 10.0, 1000.0})
        for (const int links : {8, 64})
            for (const int substeps : {2, 10}) {
                const Rod rod{.gamma = gamma, .links = links, .substeps = substeps};
                const Tip tip = simulate<float>(rod);
                const std::string name = "gamma " + std::to_string(gamma) + ", " +
                                         std::to_string(links) + " links, " +
                                         std::to_string(substeps) + " substeps";
                CHECK(report(name + ", tip off", off(tip, rod), substeps < 10 ? 3e-3 : 5e-4));
                CHECK(report(name + ", speed, m/s", tip.speed, 1e-5));
            }
}

// [DC3]
TEST_CASE("elastica: turned, reversed, in mm and km it is the same", "[rods]") {
    const Rod plain{.gamma = 10, .links = 32, .substeps = 10};
    Rod turned = plain, reversed = plain, small = plain, large = plain;
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
    const Rod rod{.gamma = 1e5, .links = 256, .substeps = 10};
    const Tip tip = simulate<float>(rod);
    CHECK(report("speed, m/s", tip.speed, 1e-5));
    CHECK(report("tip off", off(tip, rod), 5e-4));
}
