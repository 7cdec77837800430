// Pieces that bounce, as the rigid bodies they are.
#include "piece_pile.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/energy.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, thick = 1e-3;

// A frame is a substep, so that nothing is missed between two.
SolverOptions everySubstep(int rate, int passes) {
    SolverOptions every = options(1, passes);
    every.schedule.frameRate = {rate, 1};
    return every;
}

// A ball of eight corners around and one at either pole.
Shape ball(double radius) {
    Shape shape = sphere({.subdivisions = 1, .radius = radius});
    const auto low =
        std::ranges::min_element(shape.positions, {}, [](const Vec<double>& x) { return x.y; });
    const Vec<double> axis = cross(*low, {0, -1, 0});
    const Rotation from = frameOf(*low, axis), to = frameOf({0, -1, 0}, axis);
    for (Vec<double>& x : shape.positions) x = to * from.back(x);
    return shape;
}

// One that falls on a floor from rest, its lowest point so high (m) over where it touches.
Pile dropped(const Shape& shape, double height, double restitution, double friction = 0.5) {
    double low = 0;
    for (const Vec<double>& x : shape.positions) low = std::min(low, x.y);
    Pile pile;
    pile.restitution = restitution;
    pile.add(shape, {.density = 1000, .shift = {0, height + 2 * thick - low, 0}}, thick, friction);
    pile.floor(thick, friction);
    pile.meet({0, -g, 0});
    return pile;
}

// How high it is over where it touches, as often as it turns.
std::vector<double> apexes(const Pile& pile, double height, int rate, int count) {
    Solver<double> solver(pile.world, everySubstep(rate, 4));
    const double start = pile.middle(solver.positions(), 0).y;
    std::vector<double> found;
    double before = start, most = 0;
    bool rising = false;
    for (int i = 0; i < 8 * rate && std::ssize(found) < count; ++i) {
        solver.frame();
        const double y = pile.middle(solver.positions(), 0).y;
        if (y > before && !rising) rising = true, most = 0;
        most = std::max(most, y - start + height);
        if (y < before && rising) rising = false, found.push_back(most);
        before = y;
    }
    return found;
}

}  // namespace

TEST_CASE("piece bounces: what is dropped rises to e^2 h, and never higher", "[pieces]") {
    constexpr double height = 0.5;
    const std::array<std::pair<std::string, Shape>, 2> shapes{
        {{"a box", box({0.2, 0.1, 0.2})}, {"a ball", ball(0.1)}}};
    for (const auto& [name, shape] : shapes)
        for (const double e : {0.3, 0.5, 0.8, 1.0}) {
            const auto found = apexes(dropped(shape, height, e), height, 240, e < 0.5 ? 1 : 3);
            double expected = height;
            for (std::size_t i = 0; i < found.size(); ++i) {
                expected *= e * e;
                const std::string what = name + ", e = " + std::to_string(e).substr(0, 3) +
                                         ", bounce " + std::to_string(i + 1);
                CHECK(report(what + ": off e^2 h", std::fabs(found[i] / expected - 1), 0.01));
                CHECK(found[i] <= expected * (1 + 1e-9));
            }
            CHECK(std::ssize(found) == (e < 0.5 ? 1 : 3));
        }
}

TEST_CASE("piece bounces: bounces come ever faster and end", "[pieces]") {
    constexpr double height = 1, e = 0.5;
    const Pile pile = dropped(box({0.2, 0.1, 0.2}), height, e);
    Solver<float> solver(pile.world, everySubstep(480, 4));
    const double start = pile.middle(solver.positions(), 0).y;
    double last = 0;  // s, when it was last in the air
    for (int i = 0; i < 3 * 480; ++i) {
        solver.frame();
        if (pile.middle(solver.positions(), 0).y - start + height > 1e-4 * height)
            last = solver.time();
    }
    const double expected = std::sqrt(2 * height / g) * (1 + e) / (1 - e);
    CHECK(report("bounces end at t0 (1 + e) / (1 - e)", std::fabs(last / expected - 1), 0.05));
    CHECK(pile.counts(solver).bounces > 4);
    CHECK(pile.counts(solver).failures() == 0);
}

TEST_CASE("piece bounces: a box that lands flat does not begin to spin", "[pieces]") {
    const Pile pile = dropped(box({0.2, 0.1, 0.3}), 0.3, 0.7);
    Solver<float> solver(pile.world, everySubstep(240, 4));
    double spin = 0;
    for (int i = 0; i < 240; ++i) {
        solver.frame();
        const auto v = solver.velocities();
        const Vec<double> mean = pile.middle(v, 0);
        for (int k = pile.pieces[0].vertices.first; k < pile.pieces[0].vertices.last; ++k)
            spin = std::max(spin, length(v[k] - mean));
    }
    REQUIRE(pile.counts(solver).bounces > 2);
    CHECK(report("a flat landing: speed of corners about the centre, m/s", spin, 1e-3));
}

// n in, n out; what the others keep is the error.
TEST_CASE("piece bounces: Newton's cradle", "[pieces]") {
    constexpr double side = 0.1, apart = side + 2 * thick;
    constexpr int count = 5;
    for (int in = 1; in <= 3; ++in) {
        Pile pile;
        pile.restitution = 1;
        for (int i = 0; i < count; ++i)
            pile.add(box({side, side, side}),
                     {.density = 1000,
                      .shift = {i * apart - (i < in ? 0.05 : 0.0), 0, 0},
                      .velocity = {i < in ? 1.0 : 0.0, 0, 0}},
                     thick, 0.3);
        pile.meet({0, 0, 0});
        Solver<float> solver(pile.world, options(10, 4));
        for (int frame = 0; frame < 6; ++frame) solver.frame();
        const auto v = solver.velocities();
        double wrong = 0, energy = 0;
        for (int i = 0; i < count; ++i) {
            const double speed = length(pile.middle(v, i));
            energy += speed * speed / in;
            if (i < count - in) wrong += speed * speed / in;
        }
        CHECK(
            report("cradle, " + std::to_string(in) + " in: energy in the wrong ones", wrong, 1e-6));
        CHECK(report("cradle, " + std::to_string(in) + " in: energy lost", std::fabs(1 - energy),
                     1e-5));
    }
}

TEMPLATE_TEST_CASE("piece bounces: momenta stay, and energy never grows", "[pieces]", float,
                   double) {
    for (const double e : {0.5, 1.0}) {
        Pile pile;
        pile.restitution = e;
        pile.add(box({0.2, 0.1, 0.05}),
                 {.density = 1000,
                  .turn = turnBy({0.3, 0.2, 0.1}),
                  .velocity = {2, 0, 0},
                  .spin = {1, 5, 2}},
                 thick, 0.5);
        pile.add(prism(5, 0.1, 0.05),
                 {.density = 3000, .turn = turnBy({0, 0.1, 0.5}), .shift = {0.4, 0.02, 0}}, thick,
                 0.5);
        pile.meet({0, 0, 0});
        const auto& mass = pile.world.mass;
        // Of velocities, in so many substeps.
        const double rounding = std::is_same_v<TestType, float> ? 4e-6 : 1e-8;
        double turned[2];
        for (const int finer : {0, 1}) {
            Solver<TestType> solver(pile.world, options(finer ? 320 : 20, 4));
            const auto energy = [&] { return kineticEnergy(mass, solver.velocities()); };
            const auto spin = [&] {
                return angularMomentum(mass, solver.positions(), solver.velocities());
            };
            const Vec<double> linear = momentum(mass, solver.velocities()), angular = spin();
            const double start = energy();
            double most = 0;
            for (int frame = 0; frame < 12; ++frame) {
                solver.frame();
                most = std::max(most, energy());
            }
            REQUIRE(pile.counts(solver).bounces > 0);
            const Vec<double> left = momentum(mass, solver.velocities());
            CHECK(report("an oblique bounce: momentum", length(left - linear) / length(linear),
                         rounding));
            CHECK(report("an oblique bounce: energy gained", most / start - 1, 1e-5));
            turned[finer] = length(spin() - angular) / length(angular);
            note("an oblique bounce: angular momentum", turned[finer]);
            note("an oblique bounce: energy left", energy() / start);
        }
        // Off by how far they were moved in the substep of the impact.
        CHECK(turned[1] < 0.15 * turned[0]);
    }
}

TEST_CASE("piece bounces: the same bits from any number of threads, and resumed",
          "[pieces][determinism][threads]") {
    Pile pile;
    pile.restitution = 0.6;
    for (int i = 0; i < 12; ++i)
        pile.add(prism(3 + i % 4, 0.08, 0.05),
                 {.density = 1000,
                  .turn = turnBy({0.3 * i, 0.2, 0.1 * i}),
                  .shift = {0.05 * (i % 2), 0.2 + 0.2 * i, 0.03 * (i % 3)}},
                 thick, 0.4);
    pile.floor(thick, 0.4);
    pile.meet();
    std::uint64_t expected = 0;
    State<float> middle;
    for (const int threads : {1, 2, 3}) {
        Solver<float> solver(pile.world, options(10, 2, threads));
        for (int frame = 0; frame < 12; ++frame) solver.frame();
        if (threads == 1) middle = solver.state();
        for (int frame = 0; frame < 12; ++frame) solver.frame();
        if (threads == 1) expected = solver.hash();
        CHECK(solver.hash() == expected);
        REQUIRE(pile.counts(solver).bounces > 10);
        CHECK(pile.counts(solver).failures() == 0);
    }
    Solver<float> resumed(pile.world, options(10, 2, 2));
    resumed.restore(middle, 0);
    for (int frame = 0; frame < 12; ++frame) resumed.frame();
    CHECK(resumed.hash() == expected);
}

// A tower stands, and a box bounces beside it; in units of so many metres.
TEST_CASE("pieces: millimetres, metres and kilometres are alike", "[pieces]") {
    struct Figures {
        double apex, drift, slid;
    };
    const auto figuresOf = [](double unit) {
        Pile pile;
        const auto add = [&](const Vec<double>& at, const Vec<double>& velocity, double e) {
            pile.restitution = e;
            pile.add(box({0.1 * unit, 0.1 * unit, 0.1 * unit}),
                     {.density = 1000 / (unit * unit * unit),
                      .shift = unit * at,
                      .velocity = unit * velocity},
                     thick * unit, 0.4);
        };
        for (int i = 0; i < 3; ++i) add({0, 0.052 + 0.102 * i, 0}, {}, 0);
        add({1, 0.552, 0}, {}, 1);
        add({-1, 0.052, 0}, {-1, 0, 0}, 0);
        pile.restitution = 0.6;
        pile.add(box({6 * unit, 0.2 * unit, 6 * unit}), {.shift = {0, -0.1 * unit, 0}},
                 thick * unit, 0.4, true);
        pile.meet({0, -g * unit, 0}, 0.5 * unit);
        Solver<float> solver(pile.world, everySubstep(240, 8));
        const auto start = solver.positions();
        Figures figures{};
        for (int i = 0; i < 240; ++i) {
            solver.frame();
            if (i > 120)
                figures.apex = std::max(figures.apex, pile.middle(solver.positions(), 3).y / unit);
        }
        const auto end = solver.positions();
        figures.drift = length(pile.middle(end, 2) - pile.middle(start, 2)) / unit;
        figures.slid = (pile.middle(start, 4).x - pile.middle(end, 4).x) / unit;
        return figures;
    };
    const Figures metres = figuresOf(1);
    note("a bounce with e = 0.8, m", metres.apex - 0.052);
    note("a tower's drift in 1 s, m", metres.drift);
    CHECK(report("a stopping way, against v^2 / 2 mu g", std::fabs(metres.slid * 2 * 0.4 * g - 1),
                 0.02));
    CHECK(metres.apex - 0.052 <= 0.64 * 0.5);
    for (const double unit : {1e-3, 1e3}) {
        const Figures other = figuresOf(unit);
        const std::string of = "units of " + std::to_string(unit).substr(0, 5) + " m: ";
        CHECK(report(of + "bounce", std::fabs(other.apex - metres.apex), 1e-5));
        CHECK(report(of + "drift of a tower", std::fabs(other.drift - metres.drift), 1e-5));
        CHECK(report(of + "stopping way", std::fabs(other.slid - metres.slid), 1e-5));
    }
}
