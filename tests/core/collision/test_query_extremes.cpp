// Collision queries where rounding decides: what touches at all is told, and in time.
#include "query_cases.h"
#include "query_oracle.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/kernels/workers.h>

#include <cmath>
#include <optional>

using namespace plait;
using namespace plait::test;

namespace {

TEST_CASE("what touches, however degenerate and of whatever size, is told in time", "[ccd]") {
    const bool flushed = GENERATE(false, true);
    std::optional<FlushDenormals> flush;
    if (flushed) flush.emplace();
    Random random(23);
    for (const double scale : {1.0, 0x1p-990, 0x1p1000}) {
        int missed = 0, late = 0;
        for (int i = 0; i < 1500; ++i) {
            const double t0 = 0.25 * random.below(5);
            const bool edges = random.below(2);
            auto v = touching(random, edges, t0, i % 5);
            for (MovingVertex& m : v) m = {scale * m.start, scale * m.end};
            for (const double thickness : {0.0, 1e-12 * scale, 3 * scale}) {
                const Impact impact = touch(v, edges, thickness);
                missed += !impact;
                late += impact && *impact > t0;
            }
        }
        CAPTURE(scale, flushed);
        CHECK(report("missed", missed, 0));
        CHECK(report("  told late", late, 0));
    }
}

#ifdef PLAIT_GMP
void holdAny(const std::vector<MovingVertex>& v, bool edges, double thickness, Score& score) {
    const ExactPolygon polygon(v, edges, thickness);
    const Impact impact = touch(v, edges, thickness);
    if (thickness == 0)
        holdThin(polygon, polygon.face(), impact, score);
    else
        hold(polygon.thick(), false, impact, score);
}

void print(const Score& s) {
    CHECK(report("missed", s.missed, 0));
    CHECK(report("  told late", s.late, 0));
    note("  told where they pass by", s.invented);
    note("  early, the most", s.early);
    note("  cases", s.cases);
    note("  touching", s.touching);
    CHECK((s.touching > s.cases / 10 && s.touching < s.cases));
}

// Moved away from where they touch, or graze each other, by a few roundings up to 1e-9.
void holdNear(int each) {
    Random random(31);
    for (const bool thick : {false, true}) {
        Score score;
        for (int i = 0; i < each; ++i) {
            const bool edges = random.below(2);
            auto v = touching(random, edges, 0.25 * random.below(5), i % 5);
            const double noise = std::ldexp(1, -30 - random.below(22));
            for (MovingVertex& m : v)
                if (random.below(3)) m.start += random.point(noise), m.end += random.point(noise);
            const double graze = length(v[0].start - v[random.below(2) + 1].start);
            holdAny(v, edges, thick ? random.below(2) ? noise : graze : 0, score);
        }
        print(score);
    }
}

TEST_CASE("what touches or not by a rounding is told as exact arithmetic has it", "[ccd]") {
    holdNear(1000);
}

TEST_CASE("what touches or not by a rounding, 20,000", "[ccd][long]") { holdNear(10'000); }

TEST_CASE("in one dimension, however extreme: as exact arithmetic has it", "[ccd][CC3]") {
    const double numbers[]{0,     1,     -1,     1e-300, -1e-300,  1e300,     -1e300,
                           3e-10, 1e-10, 5e-324, 1e-308, 1.79e308, -1.79e308, 1 + 0x1p-52};
    Random random(41);
    int wrong = 0, late = 0;
    for (int i = 0; i < 10'000; ++i) {
        double x[4];
        for (double& a : x) a = numbers[random.below(14)] * (random.below(2) ? 1 : 0.75);
        const std::vector<Integer> exact = integers({x[0], x[1], x[2], x[3]});
        const Integer from = exact[2] - exact[0], to = exact[3] - exact[1];
        const Impact impact =
            thinPointPoint({{x[0], 0, 0}, {x[1], 0, 0}}, {{x[2], 0, 0}, {x[3], 0, 0}});
        wrong += impact.has_value() == (sgn(from) * sgn(to) > 0);
        if (!impact || from == 0) {
            late += impact && *impact > 0;
            continue;
        }
        late += Rational(*impact) * abs(Integer(from - to)) > abs(from);
    }
    CHECK(wrong == 0);
    CHECK(late == 0);
}

// Of sizes far apart: many touch at the start, many at the end.
void holdUneven(int each) {
    const double numbers[]{0, 1, -1, 1e-12, -1e-12, 1e12, -1e12, 0x1p-30, 0x1p30, 1 + 0x1p-52};
    Random random(19);
    Score score;
    for (int i = 0; i < each; ++i) {
        const bool edges = random.below(2), last = random.below(2);
        auto v = touching(random, edges, last, i % 5);
        const int first = random.below(10), kinds = 2 + random.below(9);
        const auto number = [&] { return numbers[(first + random.below(kinds)) % 10]; };
        const auto point = [&] { return Vec<double>{number(), number(), number()}; };
        for (MovingVertex& m : v) (last ? m.start : m.end) = point();
        if (random.below(2))
            for (MovingVertex& m : v) (last ? m.end : m.start) = point();
        for (const double thickness : {0.0, std::abs(number())})
            holdAny(v, edges, thickness, score);
    }
    print(score);
}

TEST_CASE("queries of sizes far apart are those of exact arithmetic", "[ccd]") { holdUneven(1000); }

TEST_CASE("queries of sizes far apart, 20,000", "[ccd][long]") { holdUneven(10'000); }
#endif

// They touch at the start, or at the end, and the other numbers are as extreme as they can be.
TEST_CASE("queries of extreme numbers miss nothing and end", "[ccd]") {
    const double numbers[]{0,      1,     -1,     1e-300,   -1e-300,   1e300,
                           -1e300, 1e-16, 5e-324, 1.79e308, -1.79e308, 1 + 0x1p-52};
    Random random(17);
    int missed = 0, wrong = 0, calls = 0;
    for (int i = 0; i < 5000; ++i) {
        const bool edges = random.below(2), last = random.below(2);
        auto v = touching(random, edges, last, i % 5);
        const int first = random.below(12), kinds = 2 + random.below(11);
        const auto number = [&] { return numbers[(first + random.below(kinds)) % 12]; };
        for (MovingVertex& m : v) (last ? m.start : m.end) = {number(), number(), number()};
        for (const double thickness : {0.0, std::abs(number())}) {
            const Impact impact = touch(v, edges, thickness);
            missed += !impact || (!last && *impact != 0);
            auto any = v;
            for (MovingVertex& m : any) (last ? m.end : m.start) = {number(), number(), number()};
            const Impact other = touch(any, edges, thickness);
            wrong += other && !(*other >= 0 && *other <= 1);
            calls += 2;
        }
    }
    CHECK(report("missed", missed, 0));
    CHECK(wrong == 0);
    note("queries", calls);
}

}  // namespace
