// Tears against Griffith: what drives them, the load at which they begin, what they cost.
#include "tests/catch.h"
#include "tests/core/tearing/torn_sheets.h"
#include "tests/report.h"

#include <plait/membranes/membrane_set.h>

#include <algorithm>
#include <numeric>

using namespace plait;
using namespace plait::test;

namespace {

SolverOptions damped(int substeps = 1, int iterations = 1) {
    SolverOptions options;
    options.schedule = {.substeps = substeps, .frameRate = {60, 1}, .iterations = iterations};
    options.damping = 0.3;
    return options;
}

GridParameters coarse{33, 9, 0.2, 0.05}, fine{65, 17, 0.2, 0.05};

int tipOf(const World& world, double notch, double middle) {
    for (int v = 0; v < static_cast<int>(world.rest.size()); ++v)
        if (length(world.rest[v] - Vec<double>{notch, middle, 0}) < 1e-9) return v;
    return -1;
}

double tornLength(const World& world, std::span<const std::int32_t> cuts) {
    double sum = 0;
    for (const int e : cuts) {
        if (e < 0) continue;
        const auto ends = world.complex.vertices(1, e);
        sum += length(world.rest[ends[1]] - world.rest[ends[0]]);
    }
    return sum;
}

double takenBy(const Solver<double>& solver) {
    return dynamic_cast<const MembraneSet<double>&>(solver.set(0))
        .taken(solver.state(), solver.state().kept[0]);
}

struct Energy {
    double kinetic = 0, elastic = 0;
};

Energy energyOf(const World& world, const Membrane::Rubber& rubber, const State<double>& state) {
    const World now = world.tornBy(state.cuts);
    const Cuts cuts = now.torn ? *now.torn : world.uncut();
    const SheetStress stress(cuts, {rubber}, world.rest);
    Energy energy;
    for (int t = 0; t < cuts.whole().count(2); ++t) {
        const auto v = cuts.corners(t);
        const auto borne =
            stress.borne(t, {state.position(v[0]), state.position(v[1]), state.position(v[2])});
        energy.elastic += stress.volume(t) * borne.energy;
    }
    for (int v = 0; v < state.count(); ++v)
        if (const auto w = state.particles[v].w; w > 0)
            energy.kinetic += 0.5 / w * dot(state.velocity[v].v, state.velocity[v].v);
    return energy;
}

// A strip with a notch at rest where its clamps are `stretch` apart.
std::vector<Vec<double>> atRest(const Strip& strip) {
    Solver<double> still(strip.world, damped());
    for (int frame = 0; frame < 80; ++frame) still.frame();
    return still.positions();
}

}  // namespace

TEST_CASE("tearing: what drives a tear is what the strip ahead bears", "[tearing][BR1][AT7]") {
    for (const auto& [name, size, jitter] : {std::tuple{"8 cells", coarse, 0.0},
                                             {"8 cells, irregular", coarse, 0.2},
                                             {"16 cells", fine, 0.0},
                                             {"16 cells, irregular", fine, 0.2}}) {
        Strip strip(size, 0.1, jitter);
        strip.draw(1.2, 1.2, 1);
        strip.hold();
        Solver<double> solver(strip.world, damped());
        for (int frame = 0; frame < 60; ++frame) solver.frame();
        const Tear<double> tear(strip.world, {{strip.rubber}, {.cloth = strip.cloth}});
        const Vec<double> drive =
            tear.drive(solver.state(), tipOf(strip.world, 0.1, 0.5 * size.height));
        const std::string of = std::string("J over a ring of 3 edges, ") + name;
        CHECK(report(of, std::fabs(length(drive) / strip.driveAt(1.2) - 1), 0.05));
        CHECK(drive.x > 0.99 * length(drive));
    }
}

TEST_CASE("tearing: the load at which a notch tears is Griffith's", "[tearing][BR1][BR7]") {
    for (const auto& [size, jitter, substeps, iterations] : {std::tuple{coarse, 0.0, 1, 1},
                                                             {coarse, 0.2, 1, 1},
                                                             {coarse, 0.2, 10, 1},
                                                             {coarse, 0.2, 1, 5},
                                                             {coarse, 0.2, 1, 50},
                                                             {fine, 0.2, 1, 1}}) {
        Strip strip(size, 0.1, jitter, 100);
        strip.draw(1.17, 1.27, 1);
        strip.holdTearing({.toughness = strip.driveAt(1.2) / strip.thickness});
        Solver<double> solver(strip.world, damped(substeps, iterations));
        while (solver.state().cuts.empty() && solver.time() < 1) solver.frame();
        const double stretch = 1.17 + 0.1 * solver.time();
        const std::string of = std::to_string(size.rows - 1) + " cells, jitter " +
                               std::to_string(jitter).substr(0, 3) + ", " +
                               std::to_string(substeps) + " substeps, " +
                               std::to_string(iterations) + " iterations";
        CHECK(report("load where it tears, " + of,
                     std::fabs(strip.law.at(stretch, 1).a / strip.law.at(1.2, 1).a - 1), 0.05));
    }
}

TEST_CASE("tearing: what a tear costs comes out of the motion", "[tearing][BR1]") {
    Strip strip(coarse, 0.1, 0.2, 100);
    strip.draw(1.25, 1.25, 1);
    const double toughness = strip.driveAt(1.2) / strip.thickness;
    Strip still = strip;
    still.hold();
    strip.world.start = atRest(still);
    strip.holdTearing({.toughness = toughness});
    const World& world = strip.world;
    SolverOptions options;
    options.schedule = {.substeps = 320, .frameRate = {1000, 1}, .iterations = 2};
    options.integrator = Integrator::bdf2;
    Solver<double> solver(world, options);
    const Energy before = energyOf(world, strip.rubber, solver.state());
    for (int frame = 0; frame < 8; ++frame) solver.frame();
    const State<double>& state = solver.state();
    const Energy after = energyOf(world, strip.rubber, state);
    const double owed = tornLength(world, state.cuts) * strip.thickness * toughness,
                 taken = takenBy(solver);
    CHECK(tornLength(world, state.cuts) > 0.09);
    CHECK(report("energy after 0.1 m of tear",
                 std::fabs((after.kinetic + after.elastic + taken) / before.elastic - 1), 0.02));
    CHECK(report("what its lips have taken", std::fabs(taken / owed - 1), 0.01));
    CHECK(report("length of an irregular path", tornLength(world, state.cuts) / 0.1 - 1, 0.07));
}

TEST_CASE("tearing: the legs of a trouser bear half of what a tear costs", "[tearing][BR1][FX9]") {
    const double width = 0.02, legs = 0.04;
    Strip strip({49, 9, 0.12, width}, legs, 0.1, 100);
    // One leg up, one down, from where they part on.
    const double middle = 0.5 * width;
    World& world = strip.world;
    const Cuts whole = world.uncut();
    const std::vector<Site> sites = sitesOf(whole, world.rest);
    std::vector<int> ends[2];
    for (int v = strip.cloth.first; v < strip.cloth.last; ++v) {
        if (world.isSpare(v)) continue;
        double side = world.rest[v].y - middle;
        if (std::fabs(side) < 1e-9 && !sites[v].triangles.empty()) {
            side = 0;
            for (const Spoke& s : sites[v].spokes) side += s.direction.y;
        }
        const double x = world.rest[v].x;
        if (x < legs - 1e-9)
            world.start[v] = {legs, world.rest[v].y, side > 0 ? legs - x : x - legs};
        if (x < 1e-9) ends[side > 0].push_back(v);
    }
    const double speed = 0.05, toughness = 600;
    for (const int up : {0, 1})
        world.pin(ends[up], Motion([=](const Vec<double>& start, double t) {
                      return start + Vec<double>{0, 0, (up ? speed : -speed) * t};
                  }));
    strip.holdTearing({.toughness = toughness});
    SolverOptions options = damped(4, 2);
    options.damping = 0.9;
    Solver<double> solver(world, options);
    double pull = 0, torn = 0;
    int counted = 0;
    for (int frame = 0; frame < 60; ++frame) {
        solver.frame();
        if (frame == 20) torn = tornLength(world, solver.state().cuts);
        if (frame < 20) continue;
        const World now = world.tornBy(solver.state().cuts);
        const Cuts cuts = now.torn ? *now.torn : world.uncut();
        const SheetStress stress(cuts, {strip.rubber}, world.rest);
        for (int t = 0; t < cuts.whole().count(2); ++t) {
            std::array<Vec<double>, 3> x;
            for (int c = 0; c < 3; ++c) x[c] = solver.state().position(cuts.corners(t)[c]);
            const auto forces = stress.forces(t, x);
            for (int c = 0; c < 3; ++c)
                if (std::ranges::find(ends[1], cuts.corners(t)[c]) != ends[1].end())
                    pull -= forces[c].z;
        }
        ++counted;
    }
    torn = tornLength(world, solver.state().cuts) - torn;
    note("torn, m", torn);
    note("pull, N", pull / counted);
    CHECK(report("pull on a leg",
                 std::fabs(pull / counted / (0.5 * toughness * strip.thickness) - 1), 0.1));
}
