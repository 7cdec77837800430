// The slinky against what its wire says (validation A7).
#include "scenes/slinky/landings.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/measure/energy.h>
#include <plait/rods/frame_rows.h>
#include <plait/solver.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace plait;
using namespace plait::test;

// 86 turns, 68 mm, 2.5 x 0.62 mm of steel: as others have weighed and timed it.
TEST_CASE("slinky: its wire alone says what it weighs and how it swings", "[rods][FX4]") {
    const Slinky slinky;
    CHECK(report("mass off 223.5 g", std::fabs(slinky.mass() / 0.2235 - 1), 2e-3));
    CHECK(report("stiffness off 0.621 N/m", std::fabs(slinky.stiffness() / 0.621 - 1), 5e-3));
    CHECK(report("period off 2.40 s", std::fabs(slinky.period() / 2.40 - 1), 5e-3));
    CHECK(report("collapse off T0 / 4 sqrt(3)",
                 std::fabs(slinky.collapse() / slinky.period() * 4 * std::sqrt(3.0) - 1), 1e-12));
}

TEST_CASE("slinky: turns that ride off each other are counted", "[rods][FX4]") {
    const Slinky slinky;
    World world;
    const Rod rod = addSlinky(world, slinky, {0, 0, 0});
    CHECK(turnsBeside(slinky, rod, world.start) == 0);
    // All from the middle up, by what it takes to lie beside the turn below, and no less.
    const auto shifted = [&](double across, double down) {
        std::vector<Vec<double>> x = world.start;
        const int half = slinky.turns / 2 * slinky.links;
        const auto shift = [&](int v) { x[v] += {across, -down * slinky.wire.across, 0}; };
        for (int v = rod.points.first + half; v < rod.points.last; ++v) shift(v);
        for (int v = rod.directors.first + half; v < rod.directors.last; ++v) shift(v);
        return turnsBeside(slinky, rod, x);
    };
    CHECK(shifted(0.003, 0) == 0);
    CHECK(shifted(0, 1) == 0);
    // More than half of the wire's width across it: where the cosine is above 1.25 / 3.
    const double part = shifted(0.003, 1);
    CHECK(report("part of a turn beside the next off 1 - 2 asin(1.25 / 3) / pi",
                 std::fabs(part - 0.7264), 2.0 / slinky.links));
}

TEST_CASE("slinky: hung, let go, its last turn hangs in the air", "[rods][figures][FX4]") {
    const Scene scene = build(findScene("levitation"));
    const Slinky slinky;
    const double extension = -scene.world.start[0].y - slinky.turns * slinky.wire.across;
    note("extension, m", extension);
    CHECK(report("extension off 0.968 m g / 2 k", std::fabs(extension / slinky.extension() - 1),
                 0.025));

    Solver<float> solver(scene.world, scene.options);
    std::vector<double> most(scene.metrics.size());
    const int frames = static_cast<int>(std::lround(scene.seconds * 240));
    for (int frame = 1; frame <= frames; ++frame) {
        solver.frame();
        const auto x = solver.positions(), v = solver.velocities();
        const Snapshot at{x, v, solver.time(), frame, solver.failures()};
        for (std::size_t i = 0; i < most.size(); ++i)
            most[i] = std::max(most[i], scene.metrics[i].measure(at));
    }
    CHECK(report("it hangs off sqrt(m / 3 k)", std::fabs(most[0] / slinky.collapse() - 1), 0.03));
    CHECK(report("last turn moves until then, % of the extension", most[1], 0.5));
    CHECK(report("middle of all off a stone that falls beside it, mm", most[2], 1));
    CHECK(report("wire strain, closed and falling on, %", most[3], 1));
    CHECK(report("turns beside turns", most[4], 0));
    CHECK(report("what contacts did not hold", most[5], 0));
    CHECK(report("shorter than its turns laid on each other, %", most[6], 10));
}

namespace {

// J: what joints bend and twist by, from where vertices are.
class Bending {
public:
    Bending(const Slinky& slinky, const World& world) : edges_(slinky.turns * slinky.links) {
        const double l = length(world.rest[1] - world.rest[0]);
        const Wire& wire = slinky.wire;
        for (int j = 0; j + 1 < edges_; ++j) {
            rows_.push_back(FrameTurn::rest(at(world.rest, j)));
            rows_.back().compliance = {l / wire.bending(), l / wire.bendingSide(),
                                       l / wire.twisting()};
        }
    }

    double energy(const std::vector<Vec<double>>& x) const {
        double sum = 0;
        for (int j = 0; j + 1 < edges_; ++j) {
            FrameTurn::Gradients<double> gradient;
            const auto turned = FrameTurn::evaluate(rows_[j], at(x, j), at(x, j), gradient),
                       compliance = FrameTurn::compliance(rows_[j]);
            for (int k = 0; k < 3; ++k) sum += turned[k] * turned[k] / (2 * compliance[k]);
        }
        return sum;
    }

private:
    Stencil<Vec<double>, 5> at(const std::vector<Vec<double>>& x, int joint) const {
        const int directors = edges_ + 1;
        return {x[joint], x[joint + 1], x[joint + 2], x[directors + joint],
                x[directors + joint + 1]};
    }

    int edges_;
    std::vector<FrameTurn::Row<double>> rows_;
};

struct Walk {
    std::vector<Landing> landings;
    std::vector<double> energies;  // J, then
    double strain = 0;             // at worst
    double speed = 0;              // m/s, of the fastest vertex in the last 1/8 s
    double moving = 0;             // J, of all motion, then
    double apart = 0, width = 0;   // m, then: of the ends, and of all points, along the way
};

Walk walk(int steps) {
    const SceneEntry& entry = findScene("slinky");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::preview);
    knobs.numbers["steps"] = steps;
    const Scene scene = entry.build(knobs);
    const Slinky slinky;
    const World& world = scene.world;
    const Bending bending(slinky, world);
    Landings landings(slinky, knobs.number("rise"), knobs.number("tread"));
    Solver<float> solver(world, scene.options);
    const std::size_t points = slinky.turns * slinky.links + 1;
    Walk walk;
    while (solver.time() < scene.seconds) {
        solver.frame();
        const auto x = solver.positions(), v = solver.velocities();
        if (landings.see(x, solver.time()))
            walk.energies.push_back(kineticEnergy(world.mass, v) +
                                    gravitationalEnergy(world.mass, x, {0, -9.81, 0}) +
                                    bending.energy(x));
        for (std::size_t i = 0; i + 1 < points; ++i)
            walk.strain = std::max(
                walk.strain,
                std::fabs(length(x[i + 1] - x[i]) / length(world.rest[i + 1] - world.rest[i]) - 1));
        if (solver.time() < scene.seconds - 0.125) continue;
        for (const Vec<double>& each : v) walk.speed = std::max(walk.speed, length(each));
        walk.moving = std::max(walk.moving, kineticEnergy(world.mass, v));
        walk.apart = std::max(walk.apart, std::fabs(x[0].x - x[points - 1].x));
        const auto [least, most] =
            std::ranges::minmax(std::span(x).first(points), {}, &Vec<double>::x);
        walk.width = std::max(walk.width, most.x - least.x);
    }
    walk.landings = landings.all();
    return walk;
}

// From landing to landing, once the hand has let go. It can only have been lost.
void checkEnergies(const Walk& walk) {
    for (std::size_t i = 1; i < walk.energies.size(); ++i) {
        const double gained = walk.energies[i] - walk.energies[i - 1];
        note("energy gained to landing " + std::to_string(i + 1) + ", J", gained);
        CHECK(gained < 0);
    }
}

}  // namespace

TEST_CASE("slinky: it walks down the stairs by itself", "[rods][long][FX4]") {
    const Walk down = walk(10);
    const std::vector<Landing>& landings = down.landings;
    // The first is the hand's.
    constexpr std::size_t counted = 4;
    REQUIRE(landings.size() > counted);
    std::vector<double> steps;
    for (std::size_t i = 1; i < landings.size(); ++i) {
        steps.push_back(landings[i].time - landings[i - 1].time);
        note("step " + std::to_string(i) + ", s", steps.back());
        CHECK(landings[i].upper != landings[i - 1].upper);
        CHECK(landings[i].tread == landings[i - 1].tread + 1);
    }
    const double mean = (landings[counted].time - landings[0].time) / counted;
    double uneven = 0;
    for (std::size_t i = 0; i < counted; ++i)
        uneven = std::max(uneven, std::fabs(steps[i] / mean - 1));
    CHECK(report("mean of the first four off 0.7 s, s", std::fabs(mean - 0.7), 0.1));
    CHECK(report("they off their mean", uneven, 0.06));
    CHECK(report("wire strain at worst", down.strain, 0.01));
    checkEnergies(down);
}

// Upright, in one heap; it goes on swaying for long.
TEST_CASE("slinky: where the stairs end it stays", "[rods][long][FX4]") {
    const Walk down = walk(2);
    REQUIRE(down.landings.size() >= 2);
    checkEnergies(down);
    note("fastest at the end, m/s", down.speed);
    note("J in motion at the end", down.moving);
    note("J that its second step loses", down.energies[0] - down.energies[1]);
    CHECK(report("ends apart along the way, m", down.apart, 0.034));
    CHECK(report("widest, m", down.width, 0.1));
}

namespace {

constexpr int held = 1;  // turns by which it hangs

// Hung under gravity of `g` m/s^2 and at rest, what hangs free of it swinging up and down.
struct Hung {
    double mass, extension, period;
};

double lowestTurn(const Slinky& slinky, const std::vector<Vec<double>>& x) {
    double sum = 0;
    for (int i = 0; i < slinky.links; ++i) sum += x[i].y;
    return sum / slinky.links;
}

Hung hungUnder(const Slinky& slinky, double g) {
    World world;
    const Rod rod = addSlinky(world, slinky, {0, 0, 0});
    world.pin(upperTurns(slinky, rod, held));
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    const double closed = lowestTurn(slinky, world.start);
    SolverOptions options{.sweeps = Sweeps::oneWay, .schedule = {.substeps = 12, .iterations = 1}};
    options.damping = 1 - std::exp(-3.0 / 24);
    Solver<float> settle(world, options);
    for (int frame = 0; frame < 24 * 10; ++frame) settle.frame();
    world.start = settle.positions();

    // A quarter of a wave, at 0.05 m/s.
    const int last = (slinky.turns - held) * slinky.links;
    for (int i = 0; i < last; ++i) {
        const double v = -0.05 * std::cos(pi / 2 * i / last);
        world.velocity[rod.points.first + i].y = v;
        world.velocity[rod.directors.first + i].y = v;
    }
    options.damping = 0;
    Solver<float> swing(world, options);
    const double rest = lowestTurn(slinky, world.start);
    std::vector<double> upward;
    double before = 0;
    while (upward.size() < 3 && swing.time() < 12) {
        swing.frame();
        const double now = lowestTurn(slinky, swing.positions()) - rest;
        if (before < 0 && now >= 0) upward.push_back(swing.time() - now / (now - before) / 24);
        before = now;
    }
    REQUIRE(upward.size() == 3);
    double mass = 0;
    for (const double m : world.mass) mass += m;
    return {mass, closed - rest, (upward[2] - upward[0]) / 2};
}

}  // namespace

// Of the turns that hang free.
TEST_CASE("slinky: it swings as its wire says", "[rods][long][FX4]") {
    const Slinky slinky;
    const double free = 1 - double(held) / slinky.turns, mass = free * slinky.mass(),
                 k = slinky.stiffness() / free, period = 4 * std::sqrt(mass / k);
    // Little stretched it is the close-wound coil of the closed forms.
    const Hung little = hungUnder(slinky, 0.5);
    CHECK(report("mass off", std::fabs(little.mass / slinky.mass() - 1), 0.03));
    const double stiffness = mass * 0.5 / (2 * little.extension);
    note("k beside its closed form", stiffness / k);
    CHECK(report("k off", std::fabs(stiffness / k - 1), 0.03));
    note("T0 beside its closed form", little.period / period);
    CHECK(report("T0 off", std::fabs(little.period / period - 1), 0.03));
    // Hung under its whole weight its turns are not level, and it is stiffer.
    const Hung whole = hungUnder(slinky, 9.81);
    CHECK(report("extension off 0.968 m g / 2 k",
                 std::fabs(whole.extension / slinky.extension() - 1), 0.025));
    note("T0, hung, beside that little stretched", whole.period / little.period);
    CHECK(report("off 4 % less", std::fabs(whole.period / little.period - 0.96), 0.01));
}

// Turns that press on each other as they are wound: a fifth of them hangs closed.
TEST_CASE("slinky: with a pre-tension it closes sooner", "[rods][long][FX4]") {
    const Slinky slinky{.pretension = 0.44};
    World world;
    const Rod rod = addSlinky(world, slinky, {0, 0, 0});
    const std::vector<int> hand = upperTurns(slinky, rod, held);
    world.pin(hand);
    world.act<Gravity>(GravityOptions{});
    meet(world, {skinOf(slinky, rod)});
    const double closed = lowestTurn(slinky, world.start);
    hang(world, slinky, rod);
    const double rest = lowestTurn(slinky, world.start);
    CHECK(report("extension off", std::fabs((closed - rest) / slinky.extension() - 1), 0.04));
    world.letGo(hand, 0);

    SolverOptions options{.sweeps = Sweeps::oneWay,
                          .schedule = {.substeps = 1, .frameRate = {1200, 1}, .iterations = 1}};
    Solver<float> solver(world, options);
    double moved = 0, now = 0;
    while (now > -0.005 * slinky.extension() && solver.time() < 0.5) {
        solver.frame();
        if (solver.time() < 0.97 * slinky.collapse()) moved = std::max(moved, std::fabs(now));
        now = lowestTurn(slinky, solver.positions()) - rest;
    }
    note("last turn begins to fall at, s", solver.time());
    CHECK(report("t_c off 0.247 s", std::fabs(solver.time() / 0.247 - 1), 0.03));
    CHECK(report("last turn moves until then, of the extension", moved / slinky.extension(), 5e-3));
}
