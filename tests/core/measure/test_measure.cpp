// Measures against closed forms.
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/energy.h>
#include <plait/measure/hash.h>
#include <plait/measure/momentum.h>
#include <plait/measure/strain.h>
#include <plait/measure/surfaces/geometry.h>
#include <plait/numbers/finite.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

using namespace plait;
using plait::test::report;

namespace {

using V = Vec<double>;
using Edges = std::vector<std::array<int, 2>>;
using Triangles = std::vector<std::array<int, 3>>;
using Numbers = std::vector<double>;

double distance(const V& a, const V& b) { return length(a - b); }

// A box from 0 to `size`, its twelve triangles anticlockwise from outside.
std::vector<V> boxCorners(const V& size, const V& at) {
    std::vector<V> x(8);
    for (int i = 0; i < 8; ++i) {
        x[i] = at + V{i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0};
    }
    return x;
}
const Triangles boxTriangles{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                             {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

}  // namespace

// n points on a ring of radius r that turns at rate w round an axis and moves along: each figure of
// the ring is that of one point.
TEST_CASE("energies and momenta of a turning ring", "[measure]") {
    const int n = 1000;
    const double m = 0.3, r = 0.7, w = 5;
    const V centre{10, -20, 5}, drift{1, 2, -3}, g{0, -9.81, 0};
    Numbers masses(n, m);
    std::vector<V> x, v;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n;
        x.push_back(centre + V{r * std::cos(a), 0, r * std::sin(a)});
        v.push_back(drift + V{w * r * std::sin(a), 0, -w * r * std::cos(a)});
    }
    const double kinetic = n * m / 2 * (w * r * w * r + dot(drift, drift));
    CHECK(report("kinetic energy, relative", std::abs(kineticEnergy(masses, v) / kinetic - 1),
                 1e-15));
    CHECK(report("gravitational energy, relative",
                 std::abs(gravitationalEnergy(masses, x, g) / (n * m * 9.81 * -20) - 1), 1e-15));
    CHECK(report("momentum, kg m/s", distance(momentum(masses, v), n * m * drift), 1e-12));
    const V spin{0, n * m * w * r * r, 0};
    CHECK(report("angular momentum about the centre, kg m^2/s",
                 distance(angularMomentum(masses, x, v, centre), spin), 1e-12));
    CHECK(report("angular momentum about the origin, kg m^2/s",
                 distance(angularMomentum(masses, x, v), spin + n * m * cross(centre, drift)),
                 1e-11));
    CHECK(report("centre of mass, m", distance(centreOfMass(masses, x), centre), 1e-14));
}

TEST_CASE("sums keep what rounding takes", "[measure]") {
    // Half of 2 x 1e16, then ten thousand ones, then away with the first: plain sums lose the ones.
    Numbers values{1e8, 1}, compliances{0.5, 0.5};
    values.resize(10'001, 1);
    compliances.resize(10'001, 0.5);
    CHECK(harmonicEnergy(values, compliances) == 1e16 + 1e4);
    CompensatedSum sum;
    for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
    CHECK(sum.value() == 2);
}

TEST_CASE("stretch energy has two sides", "[measure]") {
    const std::vector<V> x{{0, 0, 0}, {3, 0, 4}, {3, 1, 4}, {3, 1, 4}};
    const Edges edges{{0, 1}, {1, 2}, {2, 3}};
    const Numbers rest{4, 3, 0}, compliance{0.25, 0.1, 0};
    CHECK(stretchEnergy(x, edges, rest, compliance) == Approx(1 / 0.5 + 4 / 0.2));
    CHECK(stretchEnergy(x, edges, rest, compliance, Numbers{9, 0.5, 9}) == Approx(2 + 4));
    CHECK(stretchEnergy(x, edges, rest, compliance, Numbers{9, 1e30, 9}) == Approx(2));
    CHECK(harmonicEnergy(Numbers{3, -2, 7}, Numbers{2, 4, 0}) == 9 / 4.0 + 4 / 8.0);
    CHECK_THROWS_AS(harmonicEnergy(Numbers{1}, Numbers{-1}), std::invalid_argument);
    CHECK_THROWS_AS(harmonicEnergy(Numbers{1}, Numbers{1, 2}), std::invalid_argument);
    CHECK_THROWS_AS(stretchEnergy(x, Edges{{0, 4}}, Numbers{1}, Numbers{1}), std::invalid_argument);
}

TEST_CASE("strain of edges", "[measure]") {
    // Edge i of 200 from the origin: extended by i %, but the last is halved.
    std::vector<V> x{{0, 0, 0}};
    Edges edges;
    Numbers rest;
    for (int i = 0; i < 200; ++i) {
        rest.push_back(0.5 + i);
        x.push_back(V{0, 1, 0} * (rest.back() * (i < 199 ? 1 + i / 100.0 : 0.5)));
        edges.push_back({0, i + 1});
    }
    const auto s = summarizeStrain(x, edges, rest);
    CHECK(s.maximum == Approx(1.98));
    CHECK(s.minimum == Approx(-0.5));
    CHECK(s.percentile99 == Approx(1.96));  // the 198th of 200
    CHECK(s.mean == Approx((1.98 * 199 / 2 + 0.5) / 200));
    CHECK(strains(x, edges, rest)[17] == Approx(0.17));

    CHECK(summarizeStrain(x, {}, {}).maximum == 0);
    const auto one = summarizeStrain(x, Edges{{0, 1}}, Numbers{1});
    CHECK(one.maximum == -0.5);
    CHECK(one.percentile99 == 0.5);
    CHECK_THROWS_AS(summarizeStrain(x, Edges{{0, 1}}, Numbers{0}), std::invalid_argument);
    CHECK_THROWS_AS(summarizeStrain(x, Edges{{-1, 1}}, Numbers{1}), std::invalid_argument);
}

TEST_CASE("area and volume of a box", "[measure]") {
    for (const V at : {V{0, 0, 0}, V{1e3, -2e3, 3e3}}) {
        const auto x = boxCorners({2, 3, 5}, at);
        CHECK(report("area of a box, relative", std::abs(area(x, boxTriangles) / 62 - 1), 1e-15));
        CHECK(
            report("volume of a box, relative", std::abs(volume(x, boxTriangles) / 30 - 1), 1e-15));
    }
    auto inverted = boxTriangles;
    for (auto& t : inverted) std::swap(t[0], t[1]);
    CHECK(volume(boxCorners({2, 3, 5}, {}), inverted) == Approx(-30));
    CHECK(volume({}, {}) == 0);
    CHECK_THROWS_AS(area({}, boxTriangles), std::invalid_argument);
}

TEST_CASE("lowest point and centre of mass", "[measure]") {
    const std::vector<V> x{{0, 3, 1}, {5, -1, 0}, {6, -1, 0}, {-9, 0, 9}};
    CHECK(lowestPoint(x, {0, 1, 0}) == x[1]);
    CHECK(lowestPoint(x, {0, -2, 0}) == x[0]);
    CHECK(lowestPoint(x, {1, 0, -1}) == x[3]);
    CHECK_THROWS_AS(lowestPoint({}, {0, 1, 0}), std::invalid_argument);
    CHECK_THROWS_AS(lowestPoint(x, {}), std::invalid_argument);

    CHECK(centreOfMass(Numbers{1, 0, 3, 0}, x) == V{4.5, 0, 0.25});
    CHECK_THROWS_AS(centreOfMass(Numbers{0, 0, 0, 0}, x), std::invalid_argument);
    CHECK_THROWS_AS(centreOfMass(Numbers{1}, x), std::invalid_argument);
}

TEST_CASE("all finite", "[measure]") {
    CHECK(allFinite(Numbers{}));
    CHECK(allFinite(Numbers{0, -0.0, 1e308, 5e-324}));
    CHECK_FALSE(allFinite(Numbers{0, infinity}));
    CHECK_FALSE(allFinite(Numbers{-infinity, 0}));
    CHECK_FALSE(allFinite(std::vector<float>{1, std::nanf("")}));
    const std::vector<V> x{{0, 0, 0}, {1, 1, 1}};
    CHECK(allFinite(std::span(x)));
    for (double V::* axis : {&V::x, &V::y, &V::z}) {
        auto bad = x;
        bad[1].*axis = std::nan("");
        CHECK_FALSE(allFinite(bad));
    }
}

TEST_CASE("hash of bytes", "[measure]") {
    const auto hash = [](const Numbers& v) { return hashOf(v); };
    // By the header's recipe, in a few lines of another language.
    const std::array<unsigned char, 11> bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    CHECK(hashOf(bytes) == 0xab67bfedcb8fc716);
    CHECK(hash({}) == 0xaf63bd4c29620a93);
    CHECK(hash({1, 2}) == 0xbfe085ecb4b1979f);

    CHECK(hash({1, 2}) != hash({2, 1}));
    CHECK(hash({1, 2}) != hash({1, 2, 0}));
    CHECK(hash({0}) != hash({-0.0}));
    CHECK(hash({1, 2, 3}) != hash({-1, -2, 3}));
    const Numbers v{3, 4};
    CHECK(hashOf(v, hash({1})) != hashOf(v, hash({2})));
}
