// Collision queries against integer arithmetic: nothing missed, nothing late.
#include "query_cases.h"
#include "query_oracle.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/collision/polynomials.h>
#include <plait/collision/query.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace plait;
using namespace plait::test;

namespace {

using V = Vec<double>;

#ifdef PLAIT_GMP
// Of few digits: so that much is exactly parallel, in a plane, at an end, at a corner.
double whole(Random& random) { return random.below(7) - 3; }

// Anywhere; on a lattice; far from the origin; crossing many times their size.
MovingVertex draw(Random& random, int family) {
    MovingVertex m{random.point(1), random.point(1)};
    if (family == 1)
        m = {{whole(random), whole(random), whole(random)},
             {whole(random), whole(random), whole(random)}};
    if (family == 2) m.start += V{1e6, -1e6, 3e5}, m.end += V{1e6, -1e6, 3e5};
    if (family == 3) m.end = m.end + 1e3 * random.point(1);
    return m;
}

// `early`: a moment of grazing lasts longer than one of crossing.
void print(const std::string& what, const Score& s, double early) {
    INFO(what);
    CHECK(report(what + ": missed", s.missed, 0));
    CHECK(report("  told late", s.late, 0));
    CHECK(report("  early", s.early, early));
    note("  cases", s.cases);
    note("  touching", s.touching);
    note("  degenerate", s.degenerate);
    CHECK(report("  told where they pass by", s.invented, 0));
    CHECK(s.touching > s.cases / 100);
}

void holdThin(int each) {
    Random random(3);
    Score plane, triangle, edges;
    for (int i = 0; i < each; ++i) {
        std::vector<MovingVertex> v;
        for (int k = 0; k < 4; ++k) v.push_back(draw(random, i % 4));
        for (const bool edge : {false, true}) {
            const ExactPolygon polygon(v, edge, 0);
            holdThin(polygon, polygon.face(), touch(v, edge, 0), edge ? edges : triangle);
        }
        v.pop_back();
        for (MovingVertex& m : v) m.start.z = m.end.z = 0;
        const ExactPolygon flat(v, false, 0);
        holdThin(flat, flat.edge(0), thinPointEdge(v[0], v[1], v[2]), plane);
    }
    print("point and edge in a plane", plane, 1e-9);
    print("point and triangle", triangle, 1e-9);
    print("edge and edge", edges, 1e-9);
}

void holdThick(int each) {
    Random random(5);
    for (int kind = 0; kind < 4; ++kind) {
        Score score;
        for (int i = 0; i < each; ++i) {
            std::vector<MovingVertex> v;
            for (int k = 0; k < std::min(kind + 2, 4); ++k) v.push_back(draw(random, i % 4));
            const double thickness =
                i % 4 == 1 ? 0.25 * (1 + random.below(4)) : 0.5 * std::exp2(-random.below(20));
            const bool edges = kind == 3;
            hold(ExactPolygon(v, edges, thickness).thick(), false, touch(v, edges, thickness),
                 score);
        }
        const char* names[]{"thick points", "thick point and edge", "thick point and triangle",
                            "thick edges"};
        print(names[kind], score, 1e-6);
    }
}

TEST_CASE("thin queries are those of exact arithmetic", "[ccd][CC4][CC5]") { holdThin(1'700); }

TEST_CASE("thin queries, a million", "[ccd][long][CC4][CC5]") { holdThin(340'000); }

TEST_CASE("thick queries are those of exact arithmetic", "[ccd][CC6]") { holdThick(1'250); }

TEST_CASE("thick queries, 100,000", "[ccd][long][CC6]") { holdThick(25'000); }
#endif

TEST_CASE("in one dimension: the sign of the distance", "[ccd][CC3]") {
    const auto line = [](double start, double end) {
        return MovingVertex{{start, 5, 0}, {end, -3, 1}};
    };
    CHECK_FALSE(thinPointPoint(line(0, 1), line(1, 2)));
    CHECK_FALSE(thinPointPoint(line(0, 0), line(5e-324, 1)));
    CHECK(thinPointPoint(line(0, 1), line(1, 1)).value_or(0) > 1 - 1e-15);
    CHECK(thinPointPoint(line(1, 4), line(1, 2)) == 0.0);
    CHECK(thinPointPoint(line(-1e300, 1e300), line(0, 0)).value_or(0) ==
          Approx(0.5).epsilon(1e-15));

    Random random(2);
    int wrong = 0, late = 0;
    double early = 0;
    for (int i = 0; i < 10'000; ++i) {
        // Of 40 bits: the line of t has its root at V0 / (V0 - V1), which long double rounds once.
        const auto number = [&] { return std::floor(random.uniform(-0x1p40, 0x1p40)); };
        const double a = number(), b = number(), c = number(), d = number();
        const Impact impact = thinPointPoint(line(a, b), line(c, d));
        const long double from = c - a, to = d - b;
        wrong += impact.has_value() != ((from <= 0) != (to < 0) || to == 0);
        if (!impact) continue;
        late += *impact > from / (from - to);
        early = std::max(early, static_cast<double>(from / (from - to) - *impact));
    }
    CHECK(wrong == 0);
    CHECK(late == 0);
    CHECK(report("a root in one dimension, early", early, 2e-15));
}

// What a test of overlap at the end of each step would say.
bool nearAtEnd(const MovingVertex& p, double thickness) { return std::abs(p.end.z) <= thickness; }

TEST_CASE("a bullet passes no sheet, at 1 to 100,000 thicknesses a step", "[ccd][CC2][FX33]") {
    const double thickness = 0.01;
    const MovingVertex a{{-1, -1, 0}, {-1, -1, 0}}, b{{2, -1, 0}, {2, -1, 0}},
        c{{-1, 2, 0}, {-1, 2, 0}};
    int missedAtEnd = 0, runs = 0, missed = 0;
    double worst = 0;
    Random random(8);
    for (double speed = 1; speed < 2e5; speed *= 10) {
        for (int i = 0; i < 100; ++i) {
            const double step = speed * thickness;
            double z = thickness * 1.001 + step * random.uniform(0, 1);
            bool ever = false, atEnd = false;
            while (z > -2 * thickness) {
                const MovingVertex p{{0.1, 0.2, z}, {0.1, 0.2, z - step}};
                const Impact thick = thickPointTriangle(p, a, b, c, thickness);
                const Impact thin = thinPointTriangle(p, a, b, c);
                if (thick && !ever) {
                    const double exact = (z - thickness) / step;
                    worst = std::max(worst, std::abs(exact - *thick));
                    ever = true;
                }
                missed += thin.has_value() != (z >= 0 && z - step <= 0);
                atEnd = atEnd || nearAtEnd(p, thickness);
                z -= step;
            }
            ++runs;
            missed += !ever;
            missedAtEnd += !atEnd;
        }
    }
    CHECK(missed == 0);
    CHECK(report("time of impact of a bullet", worst, 1e-13));
    note("bullets", runs);
    note("  that overlap at the end of no step", missedAtEnd);
    CHECK(missedAtEnd > runs / 2);
}

TEST_CASE("the polynomials of thick simplices have the degree and the values of their name",
          "[ccd][CC6]") {
    Random random(4);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const MovingVertex v{random.point(1), random.point(1)}, e{random.point(1), random.point(1)},
            f{random.point(1), random.point(1)};
        const double h = random.uniform(0, 1);
        const Bernstein<2> point = pointPolynomial(v, h);
        const Bernstein<4> line = linePolynomial(v, e, h);
        const Bernstein<6> plane = planePolynomial(v, e, f, h);
        for (double t = 0; t <= 1; t += 0.125) {
            const V x = at(v, t), y = at(e, t), z = at(f, t), n = cross(y, z), m = cross(x, y);
            const auto error = [&](const auto& p, double expected) {
                constexpr int n1 = sizeof(p.c) / sizeof(double);
                double sum = 0;
                for (int k = 0; k < n1; ++k)
                    sum += detail::binomial(n1 - 1, k) * std::pow(t, k) *
                           std::pow(1 - t, n1 - 1 - k) * p.c[k];
                worst = std::max(worst, std::abs(sum - expected));
            };
            error(point, dot(x, x) - h * h);
            error(line, dot(m, m) - h * h * dot(y, y));
            error(plane, dot(x, n) * dot(x, n) - h * h * dot(n, n));
        }
    }
    CHECK(report("values of the polynomials", worst, 1e-13));
}

TEST_CASE("queries refuse what is no number and no thickness", "[ccd]") {
    const MovingVertex a{{0, 0, 0}, {1, 0, 0}}, b{{0, 1, 0}, {1, 1, 0}}, c{{0, 0, 1}, {1, 0, 1}};
    const double bad[]{std::numeric_limits<double>::quiet_NaN(),
                       std::numeric_limits<double>::infinity(),
                       -std::numeric_limits<double>::infinity()};
    for (const double x : bad) {
        MovingVertex m = a;
        m.end.y = x;
        CHECK_THROWS_AS(thinPointEdge(m, b, c), std::invalid_argument);
        CHECK_THROWS_AS(thinPointTriangle(a, b, c, m), std::invalid_argument);
        CHECK_THROWS_AS(thinEdgeEdge(a, m, b, c), std::invalid_argument);
        CHECK_THROWS_AS(thickPointPoint(m, a, 1), std::invalid_argument);
        CHECK_THROWS_AS(thickPointPoint(a, b, x), std::invalid_argument);
        CHECK_THROWS_AS(thickPointEdge(a, m, c, 1), std::invalid_argument);
        m = a;
        m.start.x = x;
        CHECK_THROWS_AS(thinPointPoint(m, a), std::invalid_argument);
        CHECK_THROWS_AS(thickEdgeEdge(a, b, m, c, 1), std::invalid_argument);
    }
    CHECK_THROWS_AS(thickPointTriangle(a, b, c, a, -1e-300), std::invalid_argument);
    CHECK_NOTHROW(thickPointTriangle(a, b, c, a, 0));
}

}  // namespace
