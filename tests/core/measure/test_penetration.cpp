// Points inside surfaces and gaps within them, against closed forms, rational arithmetic and brute
// force.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/complex/shapes.h>
#include <plait/measure/surfaces/gap.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/measure/surfaces/penetration.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#if __has_include(<gmpxx.h>) && !defined(PLAIT_WITHOUT_GMP)
#define PLAIT_GMP
#include <gmpxx.h>
#endif

using namespace plait;
using plait::test::note;
using plait::test::Random;
using plait::test::report;

namespace {

using V = Vec<double>;
using Points = std::vector<V>;
using Triangles = std::vector<std::array<int, 3>>;

struct Surface {
    Points x;
    Triangles triangles;
};

// A box with corners on whole numbers, each side of `n` x `n` squares cut in two, each vertex once.
Surface box(int n, const V& low = {0, 0, 0}) {
    Surface s;
    std::map<std::array<int, 3>, int> known;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [place, added] = known.try_emplace(at, static_cast<int>(s.x.size()));
        if (added) s.x.push_back(low + V{double(at[0]), double(at[1]), double(at[2])});
        return place->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int u, int v) {
                        std::array<int, 3> at{};
                        at[axis] = side;
                        at[(axis + 1) % 3] = i + u;
                        at[(axis + 2) % 3] = j + v;
                        return vertex(at);
                    };
                    const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                              d = corner(0, 1);
                    if (side == 0)
                        s.triangles.insert(s.triangles.end(), {{a, c, b}, {a, d, c}});
                    else
                        s.triangles.insert(s.triangles.end(), {{a, b, c}, {a, c, d}});
                }
    return s;
}

Surface joined(Surface a, const Surface& b) {
    const int n = static_cast<int>(a.x.size());
    a.x.insert(a.x.end(), b.x.begin(), b.x.end());
    for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + n, j + n, k + n});
    return a;
}

bool inside(const Surface& s, const V& p) {
    return !findInside(std::array{p}, s.x, s.triangles).empty();
}

#ifdef PLAIT_GMP
using Rational = std::array<mpq_class, 3>;

Rational difference(const V& a, const V& b) {
    return {mpq_class(a.x) - mpq_class(b.x), mpq_class(a.y) - mpq_class(b.y),
            mpq_class(a.z) - mpq_class(b.z)};
}
Rational product(const Rational& a, const Rational& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dotOf(const Rational& a, const Rational& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// By rational arithmetic: 2 on the surface, 1 where it winds round p, else 0. The ray runs in a
// direction of its own, and in another one where it meets an edge.
int exactSide(const Surface& s, const V& p, Random& random) {
    for (;;) {
        const Rational ray = difference(random.point(1), {});
        int winding = 0;
        bool generic = true;
        for (const auto& [i, j, k] : s.triangles) {
            const V &a = s.x[i], &b = s.x[j], &c = s.x[k];
            const Rational u = difference(a, p), v = difference(b, p), w = difference(c, p);
            const Rational n = product(difference(b, a), difference(c, a));
            if (dotOf(n, n) == 0) continue;
            const std::array<mpq_class, 3> area{
                dotOf(product(v, w), ray), dotOf(product(w, u), ray), dotOf(product(u, v), ray)};
            const mpq_class height = dotOf(n, u), speed = dotOf(n, ray);
            if (height == 0) {
                const std::array<mpq_class, 3> flat{
                    dotOf(product(v, w), n), dotOf(product(w, u), n), dotOf(product(u, v), n)};
                if (flat[0] >= 0 && flat[1] >= 0 && flat[2] >= 0) return 2;
            }
            const auto [least, most] = std::minmax({sgn(area[0]), sgn(area[1]), sgn(area[2])});
            if (least * most < 0) continue;
            if (least == 0 || most == 0 || speed == 0) generic = false;
            if (sgn(height) * sgn(speed) > 0) winding += sgn(speed);
        }
        if (generic) return winding != 0;
    }
}
#endif

// The least distance of convex sets by nested search: slow, and good to 1e-8 of their size.
template <class Distance>
double least(const Distance& distance) {
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
        const double a = low + 0.4 * (high - low), b = low + 0.6 * (high - low);
        if (distance(a) < distance(b))
            high = b;
        else
            low = a;
    }
    return distance((low + high) / 2);
}

V between(const V& a, const V& b, double s) { return a + s * (b - a); }

double bruteGap(const Surface& s, double within) {
    double gap = within;
    const auto edges = edgesOf(s.triangles);
    for (int v = 0; v < static_cast<int>(s.x.size()); ++v)
        for (const auto& [a, b, c] : s.triangles) {
            if (v == a || v == b || v == c) continue;
            gap = std::min(
                gap, least([&](double f) {
                    return least([&](double g) {
                        return length(between(between(s.x[a], s.x[b], f), s.x[c], g) - s.x[v]);
                    });
                }));
        }
    for (const auto& [a, b] : edges)
        for (const auto& [c, d] : edges) {
            if (a >= c || a == d || b == c || b == d) continue;
            gap = std::min(
                gap, least([&](double f) {
                    return least([&](double g) {
                        return length(between(s.x[a], s.x[b], f) - between(s.x[c], s.x[d], g));
                    });
                }));
        }
    return gap;
}

Surface ball(int subdivisions, double radius, const V& centre) {
    const Shape shape =
        sphere({.subdivisions = subdivisions, .radius = radius}, {.origin = centre});
    Surface s{shape.positions, {}};
    for (int t = 0; t < shape.complex.count(2); ++t)
        s.triangles.push_back(shape.complex.triangle(t));
    return s;
}

}  // namespace

TEST_CASE("inside a box, on its faces, edges and corners, and beside them", "[penetration]") {
    const Surface s = box(3);
    const double low[]{std::nextafter(0, -1), 0, std::nextafter(0, 1), 1, 1.5, 2,
                       std::nextafter(3, 0),  3, std::nextafter(3, 4)};
    const auto strictly = [](double a) { return a > 0 && a < 3; };
    int wrong = 0;
    for (const double x : low)
        for (const double y : low)
            for (const double z : low)
                wrong += inside(s, {x, y, z}) != (strictly(x) && strictly(y) && strictly(z));
    CHECK(wrong == 0);
    // Turned inside out it bounds the same points.
    Surface out = s;
    for (auto& t : out.triangles) std::swap(t[0], t[1]);
    CHECK(inside(out, {1, 1, 1}));
    CHECK_FALSE(inside(out, {4, 1, 1}));
}

TEST_CASE("inside two boxes at once, in a hollow one, at a corner of eight", "[penetration]") {
    const Surface two = joined(box(4), box(4, {2, 2, 2}));
    CHECK(inside(two, {1, 1, 1}));
    CHECK(inside(two, {2.5, 2.5, 2.5}));  // in both: it winds round twice
    CHECK(inside(two, {5, 5, 5}));
    CHECK_FALSE(inside(two, {5, 5, 1}));
    CHECK_FALSE(inside(two, {3, 3, 2}));  // on the one, in the other
    Surface hollow = box(1, {1, 1, 1});
    for (auto& t : hollow.triangles) std::swap(t[0], t[1]);
    hollow = joined(box(3), hollow);
    CHECK(inside(hollow, {0.5, 1.5, 1.5}));
    CHECK_FALSE(inside(hollow, {1.5, 1.5, 1.5}));
    // Every ray from here runs along edges of both.
    const Surface touching = joined(box(2), box(2, {2, 2, 2}));
    CHECK_FALSE(inside(touching, {2, 2, 2}));
    CHECK_FALSE(inside(touching, {1, 1, 3}));
}

TEST_CASE("surfaces that are not closed and bad points are refused", "[penetration]") {
    Surface s = box(2);
    CHECK(findInside({}, s.x, s.triangles).empty());
    CHECK(findInside(s.x, {}, {}).empty());
    Surface turned = s;
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    CHECK_THROWS_AS(inside(turned, {1, 1, 1}), std::invalid_argument);
    s.triangles.pop_back();
    CHECK_THROWS_AS(inside(s, {1, 1, 1}), std::invalid_argument);
    s.triangles.push_back({0, 1, 99});
    CHECK_THROWS_AS(inside(s, {1, 1, 1}), std::invalid_argument);
    const Surface whole = box(2);
    CHECK_THROWS_AS(inside(whole, {std::nan(""), 1, 1}), std::invalid_argument);
}

#ifdef PLAIT_GMP
TEST_CASE("inside is what rational arithmetic says", "[penetration]") {
    Random random(11);
    int counts[3]{};
    for (int round = 0; round < 16; ++round) {
        // Closed however the corners lie: tetrahedra, crumpled boxes and balls, every other time
        // with all corners and points on a coarse lattice, where most rays meet edges.
        Surface s = round % 4 < 2 ? box(2, {-1, -1, -1}) : ball(0, 1.2, {});
        for (int t = 0; t < 4; ++t) {
            Surface tetrahedron{{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
            for (int i = 0; i < 4; ++i) tetrahedron.x.push_back(random.point(1.5));
            s = joined(s, tetrahedron);
        }
        for (V& x : s.x) x += random.point(0.4);
        Points points;
        for (int i = 0; i < 40; ++i) points.push_back(random.point(1.6));
        if (round % 2)
            for (Points* all : {&s.x, &points})
                for (V& x : *all)
                    x = {std::round(2 * x.x) / 2, std::round(2 * x.y) / 2, std::round(2 * x.z) / 2};
        points.insert(points.end(), s.x.begin(), s.x.begin() + 8);
        for (int i = 0; i < 8; ++i) points.push_back(between(s.x[i], s.x[i + 1], 0.5));
        std::vector<int> expected;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const int side = exactSide(s, points[i], random);
            ++counts[side];
            if (side == 1) expected.push_back(static_cast<int>(i));
        }
        CHECK(findInside(points, s.x, s.triangles) == expected);
    }
    for (const int count : counts) CHECK(count > 50);  // of each kind
}
#endif

TEST_CASE("a cloth over a body: inside, and crossing it", "[penetration]") {
    const Surface body = ball(4, 1, {0.1, 0.2, 0.3});
    double apothem = 2;  // the radius of the ball inside the body
    for (const auto& [a, b, c] : body.triangles)
        apothem = std::min(
            apothem, length((1 / 3.0) * (body.x[a] + body.x[b] + body.x[c]) - V{0.1, 0.2, 0.3}));
    Random random(3);
    Points points;
    for (int i = 0; i < 20000; ++i) points.push_back(V{0.1, 0.2, 0.3} + random.point(1.2));
    const auto timed = [&](const Surface& s) {
        const auto start = std::chrono::steady_clock::now();
        const std::vector<int> found = findInside(points, s.x, s.triangles);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        note("20,000 points, triangles: " + std::to_string(s.triangles.size()) + ", seconds",
             time.count());
        return found;
    };
    const std::vector<int> found = timed(body);
    timed(ball(6, 1, {0.1, 0.2, 0.3}));
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const double r = length(points[i] - V{0.1, 0.2, 0.3});
        const bool in = std::binary_search(found.begin(), found.end(), i);
        wrong += (r < apothem && !in) || (r > 1 && in);
    }
    CHECK(wrong == 0);

    // A triangle that cuts through, one that is swallowed whole, one outside.
    const auto crossings = [&](const Points& cloth) {
        const Surface all = joined(body, {cloth, {{0, 1, 2}}});
        const Triangles last{all.triangles.back()};
        return countCrossings(all.x, body.triangles, last);
    };
    CHECK(crossings({{-3, 0.21, -3}, {3, 0.21, -3}, {0, 0.21, 4}}) > 50);
    CHECK(crossings({{0.1, 0.2, 0.3}, {0.3, 0.2, 0.3}, {0.1, 0.3, 0.3}}) == 0);
    CHECK(crossings({{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}) == 0);
    CHECK(crossings({{0.1, 0.2, 0.3}, {5, 0.21, 0.3}, {0.1, 0.2, 0.31}}) >= 2);
}

TEST_CASE("gap: two sheets, at a slant, through each other", "[gap]") {
    const auto sheets = [](double apart, double slant) {
        Surface s;
        for (const double z : {0.0, apart})
            for (const auto& [x, y] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
                s.x.push_back({x + (z > 0 ? 0.21 : 0), y, z + (z > 0 ? slant * y : 0)});
        s.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
        return s;
    };
    for (const double apart : {1e-6, 1e-3, 0.3}) {
        for (const double slant : {0.0, 0.5}) {
            const Surface s = sheets(apart, slant);
            CHECK(leastGap(s.x, s.triangles, 0.5) == Approx(apart).epsilon(1e-9));
        }
        CHECK(leastGap(sheets(apart, 0).x, sheets(apart, 0).triangles, apart / 2) == apart / 2);
    }
    const Surface crossed = sheets(0.1, -0.3);
    CHECK(leastGap(crossed.x, crossed.triangles, 0.5) == 0);
    CHECK_THROWS_AS(leastGap(crossed.x, crossed.triangles, -1), std::invalid_argument);
    CHECK_THROWS_AS(leastGap(crossed.x, Triangles{{0, 1, 8}}, 1), std::invalid_argument);
    CHECK(leastGap({}, {}, 0.5) == 0.5);
}

TEST_CASE("gap: as brute force finds it", "[gap]") {
    Random random(19);
    double worst = 0;
    int found = 0;
    for (int round = 0; round < 30; ++round) {
        Surface s;
        for (int t = 0; t < 4; ++t) {
            const V middle = random.point(2);
            for (int i = 0; i < 3; ++i) s.x.push_back(middle + random.point(1));
            s.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        if (round % 3 == 0)  // in one plane, parallel, side by side
            for (V& x : s.x) x.z = x.y > 0 ? 0.4 : 0;
        if (countIntersections(s.x, s.triangles) > 0) continue;
        const double within = 1.5, gap = leastGap(s.x, s.triangles, within);
        found += gap < within;
        worst = std::max(worst, std::fabs(gap - bruteGap(s, within)));
    }
    CHECK(report("off brute force, m", worst, 1e-7));
    CHECK(found > 10);
}
