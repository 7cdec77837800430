// Pieces that meet: they rest, slide, push and part as rigid bodies do, and never pass through each
// other.
#include "piece_pile.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/pieces/mass_ratio.h>
#include <plait/measure/surfaces/intersections.h>

#include <algorithm>
#include <random>

using namespace plait;
using namespace plait::test;

namespace {

// Boxes of 10 cm on each other, of these densities.
Pile tower(const std::vector<double>& densities) {
    constexpr double side = 0.1, thick = 1e-3;
    Pile pile;
    for (std::size_t i = 0; i < densities.size(); ++i)
        pile.add(
            box({side, side, side}),
            {.density = densities[i],
             .shift = {0, side / 2 + 2 * thick + static_cast<double>(i) * (side + 2 * thick), 0}},
            thick, 0.5);
    pile.floor(thick, 0.5);
    pile.meet();
    return pile;
}

// How far any of a tower has gone, in sides, after so many seconds.
double drift(const Pile& pile, int substeps, int passes, int seconds) {
    Solver<float> solver(pile.world, options(substeps, passes));
    const auto start = solver.positions();
    for (int frame = 0; frame < 24 * seconds; ++frame) solver.frame();
    const auto end = solver.positions();
    double most = 0;
    for (std::size_t p = 0; p + 1 < pile.pieces.size(); ++p)
        most = std::max(most, length(pile.middle(end, static_cast<int>(p)) -
                                     pile.middle(start, static_cast<int>(p))));
    CHECK(pile.counts(solver).heldBack == 0);
    return most / 0.1;
}

// Shards of glass that fall into a box, in columns.
Pile shards(int count) {
    constexpr double thick = 1e-4, friction = 0.4;
    Pile pile;
    std::mt19937 random(1);
    const auto within = [&](double a, double b) {
        return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int i = 0; i < count; ++i) {
        const Shape shape = prism(3 + static_cast<int>(random() % 4), within(0.01, 0.03), 0.004);
        const Vec<double> axis{within(-1, 1), within(-1, 1), within(-1, 1)};
        pile.add(
            shape,
            {.density = 2500,
             .turn = turnBy((within(0, 3) / length(axis)) * axis),
             .shift = {0.07 * (i % 3) - 0.07, 0.05 + 0.07 * (i / 9), 0.07 * (i / 3 % 3) - 0.07}},
            thick, friction);
    }
    pile.floor(thick, friction);
    for (const double side : {-1.0, 1.0}) {
        pile.add(box({0.2, 4, 1}), {.shift = {side * 0.215, 2, 0}}, thick, friction, true);
        pile.add(box({1, 4, 0.2}), {.shift = {0, 2, side * 0.215}}, thick, friction, true);
    }
    pile.meet();
    return pile;
}

std::vector<std::array<int, 3>> trianglesOf(const World& world) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < world.complex.count(2); ++t) triangles.push_back(world.complex.triangle(t));
    return triangles;
}

}  // namespace

TEST_CASE("piece contacts: towers stand for a minute", "[pieces][figures]") {
    const double five = drift(tower({1000, 1000, 1000, 1000, 1000}), 10, 8, 60);
    const double heavy = drift(tower({1000, 100000}), 10, 32, 60);
    CHECK(report("five boxes, drift in 60 s, in sides", five, 0.01));
    CHECK(report("two boxes of 1 : 100, drift in 60 s, in sides", heavy, 0.02));
}

TEST_CASE("piece contacts: ten boxes and one of 100 times the mass on top stand for a minute",
          "[pieces][long]") {
    std::vector<double> densities(10, 1000);
    densities.push_back(100000);
    const double ten = drift(tower(densities), 40, 32, 60);
    CHECK(report("ten boxes and one of 100, drift in 60 s, in sides", ten, 0.02));
}

TEST_CASE("piece contacts: on a slope a box rests below the angle of friction and slides above it",
          "[pieces]") {
    const double slope = std::atan(0.5), g = 9.81;
    for (const double friction : {0.4, 0.6}) {
        Pile pile;
        pile.add(box({0.2, 0.1, 0.2}), {.density = 1000, .shift = {0, 0.052, 0}}, 1e-3, friction);
        pile.floor(1e-3, friction);
        pile.meet({g * std::sin(slope), -g * std::cos(slope), 0});
        Solver<float> solver(pile.world, options(10, 8));
        const double start = pile.middle(solver.positions(), 0).x;
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        const double way = pile.middle(solver.positions(), 0).x - start;
        const double slides = g * (std::sin(slope) - friction * std::cos(slope)) / 2;
        if (friction > 0.5)
            CHECK(report("a box that rests, m in 1 s", std::fabs(way), 1e-4));
        else
            CHECK(report("a box that slides, against Coulomb", std::fabs(way / slides - 1), 0.01));
    }
}

namespace {

struct Momenta {
    Vec<double> linear, angular;
};

template <class Real>
Momenta momentaOf(const Pile& pile, const Solver<Real>& solver) {
    const auto x = solver.positions(), v = solver.velocities();
    return {momentum(pile.world.mass, v), angularMomentum(pile.world.mass, x, v)};
}

}  // namespace

TEMPLATE_TEST_CASE("piece contacts: what collides keeps both momenta", "[pieces]", float, double) {
    Pile pile;
    pile.add(box({0.2, 0.1, 0.05}),
             {.density = 1000,
              .turn = turnBy({0.3, 0.2, 0.1}),
              .velocity = {2, 0, 0},
              .spin = {1, 5, 2}},
             1e-3, 0.5);
    pile.add(prism(5, 0.1, 0.05),
             {.density = 3000, .turn = turnBy({0, 0.1, 0.5}), .shift = {0.4, 0.02, 0}}, 1e-3, 0.5);
    pile.meet({0, 0, 0});
    // Rounding of velocities, in as many substeps.
    const double rounding = std::is_same_v<TestType, float> ? 4e-6 : 1e-9;
    double turned[2];
    for (const int finer : {0, 1}) {
        Solver<TestType> solver(pile.world, options(finer ? 80 : 20, 4));
        const Momenta before = momentaOf(pile, solver);
        for (int frame = 0; frame < 12; ++frame) solver.frame();
        const Momenta after = momentaOf(pile, solver);
        CHECK(length(pile.middle(solver.positions(), 1) - Vec<double>{0.4, 0.02, 0}) > 0.1);
        CHECK(report("a collision: momentum",
                     length(after.linear - before.linear) / length(before.linear), rounding));
        turned[finer] = length(after.angular - before.angular) / length(before.angular);
        note("a collision: angular momentum", turned[finer]);
    }
    // A push that takes its turn over two substeps is off by how far levers turn between them.
    CHECK(turned[1] < 0.35 * turned[0]);
}

TEST_CASE("piece contacts: nothing passes through, however fast and thin", "[pieces]") {
    for (const double speed : {5.0, 50.0, 500.0}) {
        Pile pile;
        pile.add(prism(3, 0.01, 0.001),
                 {.density = 2500,
                  .turn = turnBy({0.4, 0.1, 0.3}),
                  .shift = {0, 0.5, 0},
                  .velocity = {0, -speed, 0},
                  .spin = {40, 20, 10}},
                 1e-5, 0.4);
        pile.add(box({2, 0.001, 2}), {.shift = {0, 0, 0}}, 1e-5, 0.4, true);
        pile.meet();
        Solver<float> solver(pile.world, options(2, 2));
        for (int frame = 0; frame < 12; ++frame) solver.frame();
        CHECK(pile.middle(solver.positions(), 0).y > 0);
        CHECK(pile.counts(solver).failures() == 0);
        CHECK(countIntersections(solver.positions(), trianglesOf(pile.world)) == 0);
    }
}

TEST_CASE("piece contacts: shards of glass in a pile never overlap", "[pieces]") {
    const Pile pile = shards(90);
    Solver<float> solver(pile.world, options(20, 4));
    const auto triangles = trianglesOf(pile.world);
    const int walls = countIntersections(solver.positions(), triangles);
    long held = 0;
    for (int frame = 0; frame < 36; ++frame) {
        if (frame == 30) held = pile.counts(solver).heldBack;
        solver.frame();
        REQUIRE(countIntersections(solver.positions(), triangles) == walls);
    }
    const ContactCounts& counts = pile.counts(solver);
    double speed = 0, low = 1;
    const auto x = solver.positions(), v = solver.velocities();
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (pile.world.pinned[i]) continue;
        speed += length(v[i]) / static_cast<double>(x.size());
        low = std::min(low, x[i].y);
    }
    note("90 shards: points that touch", static_cast<double>(counts.contacts));
    note("90 shards: vertices put back", static_cast<double>(counts.heldBack));
    note("90 shards: mean speed at last, m/s", speed);
    CHECK(counts.failures() == 0);
    CHECK(counts.heldBack == held);  // none at rest
    CHECK(low > 0);
    CHECK(counts.contacts > 100);
}

TEST_CASE("piece contacts: the same bits from any number of threads, and resumed",
          "[pieces][determinism][threads]") {
    const Pile pile = shards(27);
    std::uint64_t expected = 0;
    State<float> middle;
    for (const int threads : {1, 2, 3}) {
        Solver<float> solver(pile.world, options(10, 2, threads));
        for (int frame = 0; frame < 6; ++frame) solver.frame();
        if (threads == 1) middle = solver.state();
        for (int frame = 0; frame < 6; ++frame) solver.frame();
        if (threads == 1) expected = solver.hash();
        CHECK(solver.hash() == expected);
        REQUIRE(pile.counts(solver).contacts > 10);
    }
    Solver<float> resumed(pile.world, options(10, 2, 2));
    resumed.restore(middle, 0);
    for (int frame = 0; frame < 6; ++frame) resumed.frame();
    CHECK(resumed.hash() == expected);
}

TEST_CASE("piece contacts: a mass ratio beyond the settings is warned of in a line", "[pieces]") {
    const ScheduleOptions eighty = options(10, 8).schedule;
    for (const auto& [heavy, passes, warned] :
         {std::tuple{79.0, 8, 0}, {81.0, 8, 1}, {81.0, 9, 0}, {1000.0, 32, 1}}) {
        World world = tower({1000, heavy * 1000, 2000}).world;
        warnOfMassRatio(world, options(10, passes).schedule);
        CHECK(std::ssize(world.warnings) == warned);
    }
    World world = tower({1000, 100000}).world;
    warnOfMassRatio(world, eighty, 0.5);  // a film twice as slow looks twice as often
    CHECK(world.warnings.empty());
    warnOfMassRatio(world, eighty);
    REQUIRE(world.warnings.size() == 1);
    CHECK(world.warnings[0] ==
          "pieces differ in mass by 100 : 1; contacts evaluated 80 times in 1/24 s hold up to 80 : "
          "1");
}

TEST_CASE("piece contacts: what is wrong is refused by name", "[pieces]") {
    Pile pile;
    pile.add(box({1, 1, 1}), {}, 1e-3, 0.5);
    Shape dented = box({1, 1, 1});
    dented.positions[7] = {0.1, 0.1, 0.1};
    pile.add(dented, {.shift = {3, 0, 0}}, 1e-3, 0.5);
    pile.meet();
    CHECK_THROWS_WITH(Solver<float>(pile.world, options(4, 1)), "contacts: it is not convex");
    CHECK_THROWS_WITH(meetPieces(pile.world, {}, {.name = "glass"}),
                      "glass: there must be one surface a piece");
}
