// Sheets that are cut while they hang: they go on from the same state, held by what is left.
#include "cut_sheets.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr int n = 32, cutFrame = 30;
constexpr double frameTime = 1 / 60.0;

World bare(SimplicialComplex complex) {
    const Shape shape = square(n);
    World world;
    world.add(shape, {.density = 0.2});
    world.complex = std::move(complex);
    world.pin({0, n - 1});
    world.act<Gravity>(GravityOptions{});
    return world;
}

struct Cut {
    std::vector<int> edges;
    std::vector<bool> side;  // by vertex
};

Cut where(const std::function<bool(int)>& side) {
    Cut cut{across(square(n).complex, side, [](int) { return true; }), {}};
    for (int v = 0; v < n * n; ++v) cut.side.push_back(side(v));
    return cut;
}

struct Outcome {
    double strain = 0;      // of what is not cut, over the run after it
    double energy = -1e30;  // J, the highest after the cut, which has 0
    double lowest = 0;      // m, at the end
    double apart = 0;       // m, the furthest that ends of a cut edge are apart
    Vec<double> gained{};   // kg m/s, by the vertices of one side, beyond free fall
    double falling = 0;     // kg m/s, theirs
};

// A sheet that swings from two corners, cut after 0.5 s, and what it does for another second.
Outcome cutWhileItSwings(const Cut& cut, const SheetOptions& sheet, bool anew) {
    const SimplicialComplex complex = square(n).complex;
    const SolverOptions options = optionsOf({});
    World whole = bare(complex), rest = bare(without(complex, cut.edges));
    SheetPlan plan(whole, {0, n * n}, sheet);
    plan.hold(whole);
    Solver<float> before(whole, options);
    for (int frame = 0; frame < cutFrame; ++frame) before.frame();
    plan.cut(cut.edges);
    if (anew)
        holdSheet(rest, {0, n * n}, sheet);
    else
        plan.hold(rest);
    Solver<float> solver(rest, options);
    solver.restore(before.state(), before.evaluations());

    const Rows<Stretch> edges = linksOf(rest);
    std::vector<double> mass = rest.mass;
    for (std::size_t v = 0; v < mass.size(); ++v)
        if (cut.side[v]) mass[v] = 0;
    const auto energy = [&] {
        return kineticEnergy(rest.mass, solver.velocities()) +
               gravitationalEnergy(rest.mass, solver.positions(), {0, -9.81, 0});
    };
    const double start = energy();
    const Vec<double> moving = momentum(mass, solver.velocities());
    Outcome outcome;
    for (int frame = 1; frame <= 60; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        for (const double e : strainsOf(edges, x)) outcome.strain = std::max(outcome.strain, e);
        outcome.energy = std::max(outcome.energy, energy() - start);
        for (const int e : cut.edges) {
            const auto [a, b] = complex.edge(e);
            outcome.apart = std::max(outcome.apart, length(x[b] - x[a]));
        }
    }
    for (const Vec<double>& x : solver.positions()) outcome.lowest = std::min(outcome.lowest, x.y);
    double weight = 0;
    for (const double m : mass) weight += m;
    const Vec<double> fallen = momentum(mass, solver.velocities());
    outcome.falling = length(fallen);
    outcome.gained = fallen - moving - Vec<double>{0, -9.81 * 60 * frameTime * weight, 0};
    std::printf("    strain %.2f %%, E %.1e J, lowest %.3f m, %.3f m apart\n", 100 * outcome.strain,
                outcome.energy, outcome.lowest, outcome.apart);
    return outcome;
}

const SheetOptions sheets[] = {{.aggregates = true}, {.strands = false, .aggregates = true}};

}  // namespace

TEST_CASE("cuts: a sheet cut in half while it swings", "[inextensible][cuts][figures]") {
    const Cut half = where([](int v) { return v % n < n / 2; });
    for (const SheetOptions& sheet : sheets) {
        const Outcome cut = cutWhileItSwings(half, sheet, false);
        const Outcome anew = cutWhileItSwings(half, sheet, true);
        CHECK(cut.strain < 0.02);
        CHECK(cut.strain < 1.5 * anew.strain);
        CHECK(cut.energy < 1e-3);
        CHECK(cut.apart > 0.5);
        CHECK(std::fabs(cut.lowest - anew.lowest) < 0.05);
    }
}

TEST_CASE("cuts: a strip that is cut off falls freely", "[inextensible][cuts]") {
    const Cut strip = where([](int v) { return v / n < 24; });
    for (const SheetOptions& sheet : sheets) {
        const Outcome cut = cutWhileItSwings(strip, sheet, false);
        CHECK(cut.strain < 0.02);
        CHECK(cut.energy < 1e-3);
        CHECK(report("momentum beyond free fall", length(cut.gained) / cut.falling, 1e-5));
    }
}
