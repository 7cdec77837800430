// How fast constraint by constraint (dual, XPBD) and vertex by vertex (primal, block descent)
// converge on a chain along which everything is linear: validation B, "Primal vs dual".
#include "spring.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

struct Case {
    double stiffness = 1;  // K = k h^2 / m
    double tipMass = 1;    // over that of the others
    double contrast = 1;   // stiffness of the lower half over that of the upper
    double dual, primal;   // sweeps in which the error falls to a tenth; 0: not asked
};

constexpr int links = 20;

double stiffnessOf(const Case& c, int link) {
    return c.stiffness * (link < links / 2 ? 1 : c.contrast);
}

// Along x, and moving along it: nothing turns.
World straightChain(const Case& c) {
    World world;
    const double end = links;
    world.add(chain({.links = links, .to = {end, 0, 0}}));
    world.mass.assign(links + 1, 1);
    world.mass[links] = c.tipMass;
    world.pin({0});
    for (int i = 1; i <= links; ++i)
        world.velocity[i] = {0.1 * std::sin(M_PI * i / (2 * links + 1)), 0, 0};
    Rows<Stretch> rows = linksOf(world);
    for (int i = 0; i < links; ++i)
        rows.rows[i].compliance = rows.rows[i].compression = 1 / stiffnessOf(c, i);
    world.constrain(rows, {.name = "links"});
    return world;
}

// Implicit Euler with h = 1, (M + K L) u = M v, by elimination from the tip upwards.
std::vector<double> implicitEuler(const Case& c, const World& world) {
    std::vector<double> diagonal(links + 1), right(links + 1), x(links + 1, 0);
    for (int i = links; i > 0; --i) {
        const double above = stiffnessOf(c, i - 1), below = i < links ? stiffnessOf(c, i) : 0;
        const double part = i < links ? below / diagonal[i + 1] : 0;
        diagonal[i] = world.mass[i] + above + below - part * below;
        right[i] = world.mass[i] * world.velocity[i].x + (i < links ? part * right[i + 1] : 0);
    }
    double u = 0;
    for (int i = 1; i <= links; ++i) {
        u = (right[i] + stiffnessOf(c, i - 1) * u) / diagonal[i];
        x[i] = i + u;
    }
    return x;
}

double sweepsPerDigit(const Case& c, Method method, double expected) {
    const World world = straightChain(c);
    const std::vector<double> exact = implicitEuler(c, world);
    const auto errorAfter = [&](int sweeps) {
        SolverOptions options = steppingBy(1, method);
        options.sweeps = Sweeps::oneWay;
        options.schedule.iterations = sweeps;
        Solver<double> solver(world, options);
        solver.frame();
        double worst = 0;
        for (int i = 1; i <= links; ++i)
            worst = std::max(worst, std::fabs(solver.positions()[i].x - exact[i]));
        return worst;
    };
    // Where the slowest mode alone is left, and above rounding.
    const bool fast = expected < 10;
    const int from = static_cast<int>((fast ? 6 : 2) * expected);
    const int to = static_cast<int>((fast ? 10 : 4) * expected);
    return (to - from) / std::log10(errorAfter(from) / errorAfter(to));
}

void check(const std::vector<Case>& cases) {
    for (const Case& c : cases)
        for (const Method method : {Method::xpbd, Method::block}) {
            const double expected = method == Method::xpbd ? c.dual : c.primal;
            if (expected == 0) continue;
            const double found = sweepsPerDigit(c, method, expected);
            char what[96];
            std::snprintf(what, sizeof what, "%s, K %g, tip x%g, half x%g: %.1f sweeps a digit",
                          method == Method::xpbd ? "XPBD" : "block", c.stiffness, c.tipMass,
                          c.contrast, found);
            CHECK(report(what, std::fabs(found / expected - 1), 0.02));
        }
}

}  // namespace

TEST_CASE("primal and dual: sweeps a digit on a linear chain", "[block][convergence][IN9]") {
    check({{.stiffness = 1, .dual = 2.8, .primal = 2.8},
           {.stiffness = 1e2, .dual = 138, .primal = 138},
           {.stiffness = 1e4, .dual = 367, .primal = 367},
           {.stiffness = 1e2, .tipMass = 10, .dual = 170, .primal = 101},
           {.stiffness = 1e2, .tipMass = 1000, .dual = 218, .primal = 67},
           {.contrast = 1e2, .dual = 27, .primal = 199}});
}

TEST_CASE("primal and dual: the whole table", "[.][long][block][convergence]") {
    check({{.stiffness = 1e6, .dual = 373, .primal = 373},
           {.stiffness = 1e4, .tipMass = 10, .dual = 714, .primal = 362},
           {.stiffness = 1e6, .tipMass = 10, .dual = 738, .primal = 373},
           {.stiffness = 1e2, .tipMass = 100, .dual = 210, .primal = 71},
           {.stiffness = 1e4, .tipMass = 100, .dual = 3840, .primal = 318},
           {.stiffness = 1e6, .tipMass = 100, .dual = 4646, .primal = 372},
           {.stiffness = 1e4, .tipMass = 1000, .dual = 14616, .primal = 174},
           {.stiffness = 1e6, .tipMass = 1000, .dual = 43158, .primal = 367},
           {.contrast = 1e4, .dual = 31, .primal = 19820},
           {.contrast = 1e6, .dual = 31, .primal = 0}});
}
