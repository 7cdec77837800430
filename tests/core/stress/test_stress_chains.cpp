// Chains where sweeps fail (validation D 1-4, 13): many links, a heavy end, stiff beside soft, a
// swing that should last, pins too far apart. The budget is 64 sweeps in 1/60 s, and a direct solve
// counts as a sweep.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/constraints/constants.h>
#include <plait/numbers/finite.h>
#include <plait/sheets/inextensible.h>
#include <plait/sheets/strands/strand_set.h>

#include <chrono>
#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81;

enum class Links { swept, solved, held };  // held as a sheet is (inextensible.h)

struct Rope {
    int links = 20;
    double tip = 1;         // mass of the last vertex over that of another
    double lean = 0;        // of the start, downward from horizontal, rad
    double compliance = 0;  // of a link, m/N
    double ratio = 1;       // how much stiffer the upper half is
    Links how = Links::solved;
};

// 1 m of rope, 1 kg without its tip, straight and pinned at one end.
World rope(const Rope& r) {
    World world;
    const Range all =
        world.add(chain({.links = r.links, .to = {std::cos(r.lean), -std::sin(r.lean), 0}}));
    world.mass.assign(world.mass.size(), 1.0 / r.links);
    world.mass.back() *= r.tip;
    world.pin({0});
    world.act<Gravity>(GravityOptions{});
    Rows<Stretch> links = linksOf(world, r.compliance);
    for (std::size_t i = 0; i < links.rows.size() / 2; ++i)
        links.rows[i].compliance = links.rows[i].compression = r.compliance / r.ratio;
    if (r.how != Links::held)
        world.constrain(links, {.name = "links", .direct = r.how == Links::solved});
    else if (r.compliance > 0)
        strand(world, links, {.name = "links"});
    else
        holdSheet(world, all);
    return world;
}

// An evaluation goes forward and back: 32 of them are the budget.
SolverOptions evaluating(int times, Integrator integrator = Integrator::bdf2) {
    return {.integrator = integrator,
            .schedule = {.substeps = times, .frameRate = {.frames = 60}, .iterations = 1}};
}
constexpr int budget = 32;

std::vector<Points> film(const World& world, const SolverOptions& options, double seconds,
                         long* evaluations = nullptr) {
    Solver<double> solver(world, options);
    std::vector<Points> frames;
    for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
        solver.frame();
        frames.push_back(solver.positions());
        REQUIRE(allFinite(frames.back()));
    }
    if (evaluations) *evaluations = solver.evaluations();
    return frames;
}

// The most that a rope of 1 m is too long in a film.
double stretchOf(const std::vector<Points>& frames) {
    double most = 0;
    for (const Points& x : frames) {
        double sum = 0;
        for (std::size_t i = 1; i < x.size(); ++i) sum += length(x[i] - x[i - 1]);
        most = std::max(most, sum - 1);
    }
    return most;
}

double fallStretch(int links, Links how, int evaluations = budget) {
    return stretchOf(film(rope({.links = links, .how = how}), evaluating(evaluations), 2));
}

// As scenes hold sheets, in first order. Strands and tethers both count, so that half as often is
// the budget; mending comes on top. Returns sweeps over all links in 1/60 s.
double checkHeld(int links, int evaluations = budget / 2) {
    long swept = 0;
    const double stretch = stretchOf(film(rope({.links = links, .how = Links::held}),
                                          evaluating(evaluations, Integrator::first), 2, &swept));
    const double sweeps = static_cast<double>(swept) / (120.0 * links);
    note(std::to_string(links) + " links, held: sweeps in 1/60 s, with mending", sweeps);
    CHECK(report("    stretch", stretch, 0.01));
    return sweeps;
}

void checkFall(int links) {
    const std::string name = std::to_string(links) + " links dropped from horizontal: stretch";
    CHECK(report(name, fallStretch(links, Links::solved), 0.01));
    const double swept = fallStretch(links, Links::swept);
    note(name + ", swept", swept);
    // g h^2 N^2 / 2 at rest already (A1).
    const double law = g * links * links / 2 / (60 * budget) / (60 * budget);
    CHECK(swept > law);
}

// Root mean square over vertices and frames, m.
double distance(const std::vector<Points>& a, const std::vector<Points>& b) {
    double squares = 0;
    for (std::size_t f = 0; f < a.size(); ++f)
        for (std::size_t i = 0; i < a[f].size(); ++i)
            squares += dot(a[f][i] - b[f][i], a[f][i] - b[f][i]);
    return std::sqrt(squares / static_cast<double>(a.size() * a[0].size()));
}

struct Swing {
    double stretch, gain;  // m; J over m g L of the tip
};

// A weight on a rope that swings at 30 degrees from the plumb line.
Swing swing(double tip, Links how, int seconds) {
    const World world = rope({.tip = tip, .lean = pi / 3, .how = how});
    const SolverOptions held = evaluating(budget / 2, Integrator::first);
    Solver<double> solver(world, how == Links::held ? held : evaluating(budget));
    const auto energy = [&] {
        const Points x = solver.positions(), v = solver.velocities();
        double sum = 0;
        for (std::size_t i = 1; i < x.size(); ++i)
            sum += world.mass[i] * (dot(v[i], v[i]) / 2 + g * x[i].y);
        return sum / (g * world.mass.back());
    };
    const double start = energy();
    Swing result{0, -1e30};
    for (int frame = 0; frame < 60 * seconds; ++frame) {
        solver.frame();
        REQUIRE(allFinite(solver.positions()));
        result.stretch = std::max(result.stretch, stretchOf({solver.positions()}));
        result.gain = std::max(result.gain, energy() - start);
    }
    return result;
}

void checkSwing(double tip, int seconds) {
    char name[80];
    std::snprintf(name, sizeof name, "a tip %g times as heavy: ", tip);
    for (const Links how : {Links::solved, Links::held}) {
        const Swing done = swing(tip, how, seconds);
        CHECK(report(std::string(name) + "sag error", done.stretch, 0.01));
        CHECK(report(std::string(name) + "energy gained / m g L", done.gain, 0));
    }
}

// What the energy of the scenes' pendulum has changed by after 10 s, in units of m g L.
double pendulumLoss(SolverOptions options, const std::string& name) {
    const Scene scene = build(findScene("pendulum"));
    options.schedule.frameRate = {.frames = 24};
    Solver<double> solver(scene.world, options);
    const auto start = std::chrono::steady_clock::now();
    advance(solver, 240);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    const Vec<double> x = solver.positions()[1], v = solver.velocities()[1];
    REQUIRE(isFinite(x));
    note(name + ", ms a frame", time.count() / 240);
    return std::fabs(dot(v, v) / 2 + g * x.y) / g;
}

// Deviation over mean of the strains of 20 links between pins twice as far apart as they are long,
// the worst frame from the fifth second on.
double unevenness(double compliance, bool direct, int smoothing) {
    World world;
    const Range all =
        world.add(chain({.links = 20}), {.start = chain({.links = 20, .to = {2, 0, 0}}).positions});
    world.mass.assign(world.mass.size(), 0.05);
    world.pin({all.first, all.last - 1});
    world.act<Gravity>(GravityOptions{});
    world.constrain(linksOf(world, compliance), {.name = "links", .direct = direct});
    SolverOptions options = evaluating(budget, Integrator::first);
    options.smoothing = smoothing;
    double worst = 0;
    const std::vector<Points> frames = film(world, options, 6);
    for (std::size_t f = 300; f < frames.size(); ++f) {
        const std::vector<double> strain = strainsOf(linksOf(world), frames[f]);
        double mean = 0, squares = 0;
        for (const double e : strain) mean += e / 20;
        for (const double e : strain) squares += (e - mean) * (e - mean) / 20;
        worst = std::max(worst, std::sqrt(squares) / mean);
    }
    return worst;
}

}  // namespace

TEST_CASE("stress 1: a chain keeps its length", "[stress]") {
    for (const int links : {10, 20, 50, 100}) {
        checkFall(links);
        CHECK(checkHeld(links) <= 64);
    }
    CHECK(fallStretch(100, Links::swept) > 0.01);
}

// One Newton step a substep knows no tension: waves across the chain are as in an explicit scheme.
// The root -1 of its characteristic polynomial bounds (omega h)^2: 4/3 in first order, 144/55 in
// BDF2. At rest the fastest wave of N equal masses has omega^2 = 374.984 g / link for N = 100, the
// largest zero of a Laguerre polynomial, and 4 N g / link for large N: 500 links in the budget, and
// 1000 with four times as much.
TEST_CASE("stress 1: a taut chain solved at once is stable up to a step", "[stress]") {
    const int n = 100;
    for (const auto& [integrator, limit] :
         {std::pair{Integrator::first, 4.0 / 3}, {Integrator::bdf2, 144.0 / 55}})
        for (const double part : {0.97, 1.03}) {
            World world = plumbLine({.links = n, .length = 0.01});
            for (int i = 1; i <= n; ++i) world.start[i].x = i % 2 ? 1e-9 : -1e-9;
            world.constrain(linksOf(world), {.name = "links", .direct = true});
            const double rate = std::sqrt(374.984 * g / 0.01 / limit) / part;
            Solver<double> solver(world, stepping(static_cast<int>(std::lround(rate)), integrator));
            advance(solver, 6000);
            double wave = 0;
            for (const Vec<double>& x : solver.positions()) wave = std::max(wave, std::fabs(x.x));
            note("step of " + std::to_string(part).substr(0, 4) + " of the limit: wave, m", wave);
            CHECK((wave > 1e-7) == (part > 1));
        }
}

TEST_CASE("stress 1: a chain of up to 1000 links", "[stress][long]") {
    checkFall(500);
    const double missed = fallStretch(1000, Links::solved);
    note("1000 links dropped from horizontal: stretch, missed", missed);
    CHECK(missed > 0.01);
    CHECK(report("    with four times the budget", fallStretch(1000, Links::solved, 4 * budget),
                 0.01));
    // By mending, ten and twenty times the budget.
    checkHeld(500);
    checkHeld(1000, budget);
}

TEST_CASE("stress 2: a heavy tip neither sags nor gains energy", "[stress]") {
    for (const double tip : {10.0, 1e4}) checkSwing(tip, 6);
    const double swept = swing(1e4, Links::swept, 2).stretch;
    note("a tip 10000 times as heavy: sag error, swept", swept);
    CHECK(swept > 0.1);
}

TEST_CASE("stress 2: a heavy tip for a minute", "[stress][long]") {
    for (const double tip : {10.0, 100.0, 1e3, 1e4}) {
        checkSwing(tip, 60);
        note("    swept", swing(tip, Links::swept, 60).stretch);
    }
}

// The upper half stiffer than the lower, which hangs 1 cm longer than at rest.
TEST_CASE("stress 3: stiff links beside soft ones", "[stress]") {
    const double compliance = 0.01 / (g * 21 / 2);
    double uniform = 0, uniformHeld = 0, uniformSwept = 0;
    for (const double ratio : {1.0, 1e2, 1e4, 1e6}) {
        Rope r{.compliance = compliance, .ratio = ratio};
        const std::vector<Points> reference = film(rope(r), evaluating(8 * budget), 0.5);
        const double error = distance(film(rope(r), evaluating(budget), 0.5), reference);
        r.how = Links::held;
        const double held = distance(film(rope(r), evaluating(budget), 0.5), reference);
        r.how = Links::swept;
        const double swept = distance(film(rope(r), evaluating(budget), 0.5), reference);
        char name[80];
        std::snprintf(name, sizeof name, "half %g times as stiff: error over uniform", ratio);
        if (ratio == 1) {
            uniform = error;
            uniformHeld = held;
            uniformSwept = swept;
            note("uniform chain: error, m", error);
            REQUIRE(error > 10 * distance(film(rope({.compliance = compliance}),
                                               evaluating(4 * budget), 0.5),
                                          reference));
        } else {
            CHECK(report(name, error / uniform, 2));
            CHECK(report("    as a strand", held / uniformHeld, 2));
            note("    swept", swept / uniformSwept);
            CHECK(swept / uniformSwept > 2);
        }
    }
}

// 8 ms a frame is for the reader: nothing here depends on the clock.
TEST_CASE("stress 4: a pendulum from 90 degrees swings for 10 s", "[stress]") {
    const Scene scene = build(findScene("pendulum"));
    SolverOptions options = scene.options;
    CHECK(
        report("energy lost / m g L, the scene's default", pendulumLoss(options, "default"), 0.01));
    options.integrator = Integrator::first;
    const double missed = pendulumLoss(options, "first order");
    note("energy lost in first order", missed);
    CHECK(missed > 0.1);
    options.schedule.substeps = 1000;
    CHECK(report("energy lost in first order, 1,000 substeps a frame",
                 pendulumLoss(options, "first order, 1,000 substeps"), 0.01));
    options.method = Method::nucleus;
    CHECK(report("energy lost, nucleus, 1,000 substeps a frame",
                 pendulumLoss(options, "nucleus, 1,000 substeps"), 0.01));
}

// What contradicts itself has no solution; with compliance it has the one that shares alike. Rigid
// links do not: in two colours the last swept has its way (3/19 is left by the end links, which
// smoothing moves at one end only), and a direct solve is finite and no more.
TEST_CASE("stress 13: pins twice as far apart as their chain", "[stress]") {
    const double compliance = 1e-5;  // m/N
    CHECK(report("deviation of strains / mean, direct", unevenness(compliance, true, 0), 0.05));
    CHECK(report("deviation / mean, swept and smoothed", unevenness(compliance, false, 10), 0.05));
    const double rigid = unevenness(0, false, 0), smoothed = unevenness(0, false, 10);
    note("deviation / mean of rigid links, swept", rigid);
    CHECK(report("deviation / mean of rigid links, smoothed", smoothed, 3.0 / 19 + 1e-6));
    CHECK(rigid > 1);
    note("deviation / mean of rigid links, direct", unevenness(0, true, 0));
}
