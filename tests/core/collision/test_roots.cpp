// Roots in [0, 1] against integer arithmetic: none missed.
#include "integer_polynomial.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/collision/roots.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

using namespace plait;
using namespace plait::test;

namespace {

#ifdef PLAIT_GMP
// n! / (n - k)!, and n choose k.
long falling(int n, int k) { return k == 0 ? 1 : n * falling(n - 1, k - 1); }
long choose(int n, int k) { return falling(n, k) / falling(k, k); }

// Powers of t from Bernstein coefficients, as they are.
template <int n>
Polynomial exact(const Bernstein<n>& p) {
    const std::vector<Integer> c = integers({p.c, p.c + n + 1});
    Polynomial powers(n + 1);
    for (int k = 0; k <= n; ++k) {
        for (int i = 0; i <= k; ++i)
            powers[k] += c[i] * ((k - i) % 2 ? -1 : 1) * (choose(n, k) * choose(k, i));
    }
    return trimmed(powers);
}

// A product of n factors t - r, rounded or not: its roots are those of what double holds.
template <int n>
Bernstein<n> product(const std::array<double, n>& roots) {
    std::vector<double> numbers(roots.begin(), roots.end());
    numbers.push_back(1);
    const std::vector<Integer> whole = integers(numbers);
    Polynomial p{1};
    for (int i = 0; i < n; ++i) p = p * Polynomial{-whole[i], whole[n]};
    Bernstein<n> b{};
    for (int i = 0; i <= n; ++i) {
        Rational c = 0;
        for (int k = 0; k <= i; ++k) c += Rational(p[k] * choose(i, k)) / choose(n, k);
        for (int k = 0; k < n; ++k) c /= whole[n];
        b.c[i] = c.get_d();
    }
    return b;
}

enum Family { scattered, coefficients, doubled, clustered, nearEnds, wilkinson, families };

template <int n>
Bernstein<n> draw(Random& random, Family family) {
    std::array<double, n> r;
    for (double& a : r) a = random.uniform(-0.2, 1.2);
    if (family == coefficients) {
        Bernstein<n> b{};
        for (double& c : b.c) c = random.uniform(-1, 1);
        return b;
    }
    const double spread = std::ldexp(1, -random.below(50));
    for (int i = 0; i < n; ++i) {
        // Of few digits, so that no rounding parts the two.
        if (family == doubled) r[i] = i % 2 ? r[i - 1] : std::round(r[i] * 128) / 128;
        if (family == clustered) r[i] = r[0] + spread * random.uniform(-1, 1);
        if (family == nearEnds) r[i] = random.below(2) + spread * random.uniform(-1, 1);
        if (family == wilkinson) r[i] = (i + random.below(2)) / (n + 0.5);
    }
    return product<n>(r);
}

struct Count {
    int roots = 0, missed = 0, twice = 0, simple = 0, wrong = 0;
    double width = 0;
};

// Every root of what double holds is in a bracket, alone in a simple one.
template <int n>
void check(const Bernstein<n>& b, Count& count) {
    const Polynomial p = withoutMultiples(exact(b));
    if (p.empty()) return;
    const Sturm sturm(p);
    const Brackets brackets = isolateRoots(b);
    int held = 0;
    for (const Bracket<>& bracket : brackets) {
        const int inside = sturm.count(Rational(bracket.low), Rational(bracket.high));
        held += inside;
        count.wrong += bracket.simple && inside != 1;
        count.simple += bracket.simple;
        if (!bracket.simple) continue;
        count.width = std::max(count.width, bracket.high - bracket.low);
    }
    const int all = sturm.count(0, 1);
    count.roots += all;
    count.missed += std::max(0, all - held);
    count.twice += std::max(0, held - all);
}

void checkFamilies(int each) {
    Random random(11);
    for (int family = 0; family < families; ++family) {
        Count count;
        for (int i = 0; i < each; ++i) {
            const int degree = 1 + random.below(6);
            const auto f = static_cast<Family>(family);
            [&]<int... n>(std::integer_sequence<int, n...>) {
                ((degree == n + 1 ? check(draw<n + 1>(random, f), count) : void()), ...);
            }(std::make_integer_sequence<int, 6>());
        }
        const char* names[]{"scattered", "of random coefficients", "double",
                            "clustered", "near the ends",          "as Wilkinson's"};
        const std::string name = names[family];
        CHECK(report("roots missed, " + name, count.missed, 0));
        CHECK(report("  widest bracket of a simple root", count.width, 1e-12));
        note("  roots", count.roots);
        note("  simple brackets", count.simple);
        CHECK(count.wrong == 0);
        CHECK(count.twice == 0);
        CHECK(count.roots > each / 4);
        if (family < doubled) CHECK(count.simple == count.roots);
    }
}

TEST_CASE("no root of a polynomial up to degree 6 is missed", "[roots][ccd][CC7]") {
    checkFamilies(3'400);
}

TEST_CASE("no root of a polynomial is missed, a million", "[roots][ccd][long][CC7]") {
    checkFamilies(170'000);
}
#endif

TEST_CASE("a list of brackets that is full holds what comes in its last", "[roots][ccd]") {
    Brackets<> brackets;
    for (int i = 0; i < 12; ++i) brackets.append({0.08 * i, 0.08 * i + 0.01, true});
    REQUIRE(brackets.size() == brackets.capacity);
    CHECK((brackets[6].simple && !brackets[7].simple));
    CHECK((brackets[7].low == 0.08 * 7 && brackets[7].high == 0.08 * 11 + 0.01));
}

TEST_CASE("roots at the ends, double, none, everywhere", "[roots][ccd]") {
    const auto one = isolateRoots(Bernstein<1>{{-1, 3}, 0});
    REQUIRE(one.size() == 1);
    CHECK((one[0].low <= 0.25 && one[0].high >= 0.25 && one[0].high - one[0].low < 1e-14));
    CHECK(one[0].simple);

    // (2 t - 1)²: touches 0, which no sign shows; a hair above it does not.
    const auto two = isolateRoots(Bernstein<2>{{1, -1, 1}, 0});
    REQUIRE(two.size() == 1);
    CHECK((two[0].low < 0.5 && two[0].high > 0.5 && two[0].high - two[0].low < 1e-6));
    CHECK_FALSE(two[0].simple);
    CHECK(isolateRoots(Bernstein<2>{{1 + 1e-13, -1 + 1e-13, 1 + 1e-13}, 0}).size() == 0);
    CHECK(isolateRoots(Bernstein<2>{{1 + 1e-13, -1 + 1e-13, 1 + 1e-13}, 2e-13}).size() == 1);

    // (2 t - 1) (4 t - 1): one where the first part is split.
    const auto middle = isolateRoots(Bernstein<2>{{1, -2, 3}, 0});
    REQUIRE(middle.size() == 2);
    CHECK((middle[0].simple && middle[1].simple));

    const auto ends = isolateRoots(Bernstein<2>{{0, 1, 0}, 0});
    REQUIRE(ends.size() == 2);
    CHECK(
        (ends[0].low == 0 && ends[0].high < 1e-14 && ends[1].high == 1 && ends[1].low > 1 - 1e-14));

    const auto all = isolateRoots(Bernstein<6>{});
    REQUIRE(all.size() == 1);
    CHECK((all[0].low == 0 && all[0].high == 1));
    CHECK(isolateRoots(Bernstein<6>{{1e300, 1e-300, 1, 1, 1, 1, 1}, 0}).size() <= 1);

    // What is not a number is anywhere.
    const auto wrong =
        isolateRoots(Bernstein<3>{{1, std::numeric_limits<double>::quiet_NaN(), 1, 1}, 0});
    REQUIRE(wrong.size() == 1);
    CHECK((wrong[0].low == 0 && wrong[0].high == 1));
}

}  // namespace
