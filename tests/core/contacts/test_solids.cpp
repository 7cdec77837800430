// Solids with a formula, against brute force; placements; and what colliders refuse.
#include "collider_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <array>
#include <stdexcept>
#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

// By the twelve triangles of the box, which may have no area.
double bruteDistance(const Solid& solid, const Vec<double>& p) {
    const Vec<double>& a = solid.half;
    std::array<Vec<double>, 8> corner;
    for (int i = 0; i < 8; ++i)
        corner[i] = {i & 1 ? a.x : -a.x, i & 2 ? a.y : -a.y, i & 4 ? a.z : -a.z};
    const bool inside = std::fabs(p.x) < a.x && std::fabs(p.y) < a.y && std::fabs(p.z) < a.z;
    double least = 1e9;
    for (const auto& [u, v] : {std::pair{1, 2}, {2, 4}, {4, 1}})
        for (const int n : {0, 7 - u - v}) {
            for (const auto& t : {std::array{n, n + u, n + v}, {n + u, n + v, n + u + v}}) {
                const Pairing pair{{0, 1, 2, 3}, 1, 3};
                const auto at = nearest(pair, {p, corner[t[0]], corner[t[1]], corner[t[2]]});
                least = std::min(least, length(at.apart));
            }
        }
    return (inside ? -least : least) - solid.radius;
}

}  // namespace

TEST_CASE("colliders: distances and ways out against brute force", "[colliders]") {
    Random random(1);
    for (const auto& [name, solid] : solids) {
        double worst = 0, off = 0;
        for (int i = 0; i < 300; ++i) {
            const Vec<double> p = random.point(i < 150 ? 1.0 : 0.1);
            const Side side = sideOf(solid, p);
            worst = std::max(worst, std::fabs(side.distance - bruteDistance(solid, p)));
            const Vec<double> foot = p - side.distance * side.normal;
            off = std::max(
                {off, std::fabs(length(side.normal) - 1), std::fabs(sideOf(solid, foot).distance)});
        }
        CHECK(report(name + ": distance, m", worst, 1e-14));
        CHECK(report(name + ": the way out ends on it, m", off, 1e-13));
    }
    CHECK(sideOf(Solid::plane(), {3, -0.2, 5}).distance == -0.2);
}

TEST_CASE("colliders: when a path comes near, against samples of it", "[colliders]") {
    Random random(2);
    for (const auto& [name, solid] : solids) {
        double late = 0;
        int met = 0;
        constexpr int samples = 2000;
        for (int i = 0; i < 1000; ++i) {
            const Vec<double> start = random.point(1), end = random.point(1);
            const double gap = i % 2 ? 0.01 : 0;
            if (sideOf(solid, start).distance < gap) continue;
            double first = 2;
            for (int n = 0; n <= samples && first > 1; ++n) {
                const double t = double(n) / samples;
                if (sideOf(solid, start + t * (end - start)).distance <= gap) first = t;
            }
            const auto t = reaches(solid, start, end, gap);
            const double told = t.value_or(3);
            if (first <= 1) {
                CHECK(told <= first);  // none is missed
                ++met;
                if (first - told > 1.0 / samples) late = std::max(late, first - told);
            }
            if (told <= 1) {
                const Vec<double> at = start + told * (end - start);
                CHECK(std::fabs(sideOf(solid, at).distance - gap) < 1e-12);
            }
        }
        CHECK(met > 50);
        // Sooner than a sample only where the path grazes between two of them.
        CHECK(report(name + ": sooner than the samples", late, 0.05));
    }
}

TEST_CASE("colliders: placements turn steadily and the shorter way round", "[colliders]") {
    Random random(3);
    double worst = 0, middle = 0;
    for (int i = 0; i < 1000; ++i) {
        const double angle = i % 4 == 0 ? pi * (1 - 1e-9) : random.uniform(0, pi);
        const Vec<double> axis = direction(random);
        const Placement a(turnedAbout(direction(random), random.uniform(-3, 3), random.point(1)),
                          "a");
        const Placement b = between(a, a, angle * axis, 1);
        const Vec<double> turn = turnBetween(a, b);
        worst = std::max(worst, std::fabs(length(turn) - angle));
        const Placement again = between(a, b, turn, 1), half = between(a, b, turn, 0.5);
        for (const auto side : {&Placement::x, &Placement::y, &Placement::z})
            worst = std::max(worst, length(again.*side - b.*side));
        middle = std::max(middle, length(turnBetween(a, half) - 0.5 * turn));
    }
    CHECK(report("end, rad", worst, 1e-8));  // an angle near half a turn has half the digits
    CHECK(report("middle, rad", middle, 1e-8));
    const Posing keys = keyed({{0, {}}, {2, turnedAbout({0, 0, 1}, 1, {4, 0, 0})}});
    CHECK(length(keys(-1).origin) == 0);
    CHECK(length(keys(1).origin - Vec<double>{2, 0, 0}) < 1e-15);
    CHECK(length(keys(1).across - Vec<double>{cosine(0.5), sine(0.5), 0}) < 1e-15);
    CHECK(length(keys(9).across - Vec<double>{cosine(1), sine(1), 0}) < 1e-15);
}

TEST_CASE("colliders: what cannot be is refused", "[colliders]") {
    const auto throws = [](const Collider& c, const Surface& s, const ColliderOptions& o = {}) {
        World world;
        addPoint(world, {});
        CHECK_THROWS_AS(collide(world, {c}, {s}, o), std::invalid_argument);
    };
    const Surface fine = rough({0, 1}, 0);
    throws({.solid = Solid::sphere(-1)}, fine);
    throws({.solid = Solid::box(1, NAN, 1)}, fine);
    throws({.solid = {}, .frame = {.up = {1, 1, 0}}}, fine);
    throws({.solid = {}, .motion = [](double) { return Frame{.origin = {NAN, 0, 0}}; }}, fine);
    throws({.solid = {}, .restitution = 2}, fine);
    throws({.solid = {}, .stickiness = -1}, fine);
    throws({.solid = {}}, rough({0, 2}, 0));
    throws({.solid = {}}, fine, {.recovery = -1});
    World world;
    addPoint(world, {});
    CHECK_THROWS_AS(collide(world, {Collider{}}, {fine, fine}), std::invalid_argument);
    CHECK_THROWS_AS(keyed({}), std::invalid_argument);
    CHECK_THROWS_AS(keyed({{1, {}}, {1, {}}}), std::invalid_argument);
}
