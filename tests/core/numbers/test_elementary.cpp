// Elementary functions against long double, their special values, and their bits.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/hash.h>
#include <plait/numbers/elementary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using plait::arctangent2;
using plait::test::Random;
using plait::test::report;

namespace {

// |value - exact| in units of the last place of T at the exact value.
template <class T>
double ulps(T value, long double exact) {
    const T rounded = std::abs(static_cast<T>(exact));
    const T unit = std::nextafter(rounded, std::numeric_limits<T>::infinity()) - rounded;
    return static_cast<double>(std::abs(value - exact) / unit);
}

// The largest error of f over `count` arguments that draw(u, i) makes.
template <class F, class Exact, class Draw>
double worst(int count, F f, Exact exact, Draw draw) {
    Random u(2009);
    double error = 0;
    for (int i = 0; i < count; ++i) {
        const double x = draw(u, i);
        error = std::max(error, ulps(f(x), exact(static_cast<long double>(x))));
    }
    return error;
}

double anyScale(Random& u, double power) {
    return (u.uniform(0, 1) < 0.5 ? -1 : 1) * std::exp2(u.uniform(-power, power));
}

// Angles up to 1e5: evenly spread, next to the multiples of pi/2, and of all sizes.
double angle(Random& u, int i) {
    if (i % 3 == 0) return u.uniform(-1e5, 1e5);
    if (i % 3 == 1) return std::round(u.uniform(-63661, 63661)) * (std::numbers::pi / 2);
    return std::exp2(u.uniform(-100, 16));
}

double nearOne(Random& u, int i) {
    return i % 2 ? u.uniform(0.5, 2) : std::exp2(u.uniform(-1021, 1023));
}

void checkErrors(int count) {
    const auto evenly = [](double a, double b) {
        return [=](Random& u, int) { return u.uniform(a, b); };
    };
    CHECK(report("sine, |x| <= 1e5, ulp", worst(count, plait::sine, sinl, angle), 1));
    CHECK(report("cosine, |x| <= 1e5, ulp", worst(count, plait::cosine, cosl, angle), 1));
    CHECK(report("exponential, normal range, ulp",
                 worst(count, plait::exponential, expl, evenly(-708.3, 709.7)), 1));
    CHECK(report("exponential, |x| < 1, ulp", worst(count, plait::exponential, expl, evenly(-1, 1)),
                 1));
    CHECK(report("logarithm, ulp", worst(count, plait::logarithm, logl, nearOne), 1));
}

// The worst relative error, of results within the normal range.
double powerError(int count) {
    Random u(2009);
    double error = 0;
    for (int i = 0; i < count; ++i) {
        const double base = nearOne(u, i);
        const double exponent = i % 3 ? u.uniform(-3, 3) : u.uniform(-700, 700) / std::log(base);
        const long double exact = powl(base, exponent);
        if (exact < 1e-307L || exact > 1e308L) continue;
        const long double e = std::abs(plait::power(base, exponent) / exact - 1);
        error = std::max(error, static_cast<double>(e));
    }
    return error;
}

// Points all round, near and far from the axes and the borders of the fans.
template <class T>
std::array<T, 2> point(Random& u, int i) {
    if (i % 4 == 0) return {T(anyScale(u, 40)), T(anyScale(u, 40))};
    const double a = i % 4 == 1
                         ? std::round(u.uniform(-8, 8)) * std::atan(0.5) + u.uniform(-1e-3, 1e-3)
                         : u.uniform(-4, 4);
    const double r = std::exp2(u.uniform(-10, 10));
    return {T(r * std::sin(a)), T(r * std::cos(a))};
}

template <class T>
double arctangentError(int count) {
    Random u(2009);
    double error = 0;
    for (int i = 0; i < count; ++i) {
        const auto [y, x] = point<T>(u, i);
        error = std::max(error, ulps(arctangent2(y, x), atan2l(y, x)));
    }
    return error;
}

void checkArctangent(int count) {
    CHECK(report("arctangent2, double, ulp", arctangentError<double>(count), 2));
    CHECK(report("arctangent2, float, ulp", arctangentError<float>(count), 2));
}

// The least that arctangent2 asks of a pack.
struct Four {
    std::array<float, 4> lane{};

    Four() = default;
    explicit Four(double a) { lane.fill(static_cast<float>(a)); }

    template <class F>
    static auto map(F f) {
        using R = decltype(f(0));
        std::array<R, 4> r{};
        for (int i = 0; i < 4; ++i) r[i] = f(i);
        return r;
    }
    template <class F>
    static Four lanes(F f) {
        Four r;
        r.lane = map(f);
        return r;
    }
    using Mask = std::array<bool, 4>;

    friend Four operator+(Four a, Four b) {
        return lanes([&](int i) { return a.lane[i] + b.lane[i]; });
    }
    friend Four operator-(Four a, Four b) {
        return lanes([&](int i) { return a.lane[i] - b.lane[i]; });
    }
    friend Four operator*(Four a, Four b) {
        return lanes([&](int i) { return a.lane[i] * b.lane[i]; });
    }
    friend Four operator/(Four a, Four b) {
        return lanes([&](int i) { return a.lane[i] / b.lane[i]; });
    }
    friend Mask operator<(Four a, Four b) {
        return map([&](int i) { return a.lane[i] < b.lane[i]; });
    }
    friend Mask operator>(Four a, Four b) { return b < a; }
    friend Four select(Mask m, Four a, Four b) {
        return lanes([&](int i) { return m[i] ? a.lane[i] : b.lane[i]; });
    }
};

// Bits of all functions over a hundred thousand samples, made without libm.
std::uint64_t hashOfFunctions() {
    Random u(2009);
    std::vector<double> values;
    for (int i = 0; i < 100'000; ++i) {
        const double x = u.uniform(-1e5, 1e5), y = u.uniform(-700, 700), z = u.uniform(0, 1);
        const float fy = static_cast<float>(y), fx = static_cast<float>(u.uniform(-700, 700));
        values.insert(values.end(), {plait::sine(x), plait::cosine(x), plait::exponential(y),
                                     plait::logarithm(z), plait::power(z, y), arctangent2(y, x),
                                     static_cast<double>(arctangent2(fy, fx))});
    }
    return plait::hashOf(values);
}

}  // namespace

TEST_CASE("elementary functions, errors over 20,000 points", "[elementary]") {
    checkErrors(20'000);
    checkArctangent(20'000);
    CHECK(report("power, relative", powerError(20'000), 1e-14));
}

TEST_CASE("elementary functions, errors over a million points", "[elementary][long]") {
    checkErrors(1'000'000);
    checkArctangent(1'000'000);
    CHECK(report("power, relative", powerError(1'000'000), 1e-14));
}

// The literal came from g++ 12 at -O3 and holds for every compiler, level and x86-64 processor.
TEST_CASE("elementary functions have the same bits everywhere", "[elementary][determinism]") {
    CHECK(hashOfFunctions() == 0x3211581c742f7386);
}

TEST_CASE("elementary functions, special values", "[elementary]") {
    using namespace plait;
    CHECK(sine(0) == 0);
    CHECK(cosine(0) == 1);
    CHECK(sine(-2.5) == -sine(2.5));
    CHECK(cosine(-2.5) == cosine(2.5));
    CHECK(ulps(sine(1e6), sinl(1e6L)) < 2);
    CHECK(std::isnan(sine(1.1e6)));
    CHECK(std::isnan(cosine(-infinity)));
    CHECK(std::isnan(sine(std::nan(""))));

    CHECK(exponential(0) == 1);
    CHECK(exponential(-708.39) > 0);
    CHECK(exponential(-708.4) == 0);
    CHECK(exponential(709.78) < infinity);
    CHECK(exponential(709.79) == infinity);
    CHECK(exponential(infinity) == infinity);
    CHECK(exponential(-infinity) == 0);
    CHECK(std::isnan(exponential(std::nan(""))));

    CHECK(logarithm(1) == 0);
    CHECK(ulps(logarithm(0x1p-1022), logl(0x1p-1022L)) < 2);
    CHECK(logarithm(0) == -infinity);
    CHECK(logarithm(0x1p-1050) == -infinity);
    CHECK(logarithm(infinity) == infinity);
    CHECK(std::isnan(logarithm(-1)));
    CHECK(std::isnan(logarithm(std::nan(""))));

    CHECK(power(2, 10) == 1024);
    CHECK(ulps(power(2, 0.5), sqrtl(2)) < 2);
    CHECK(power(10, -3) == 1e-3);
    CHECK(power(7, 0) == 1);
    CHECK(power(0, 2) == 0);
    CHECK(power(0, -2) == infinity);
    CHECK(power(2, 1e300) == infinity);
    CHECK(power(2, -1e300) == 0);
    CHECK(std::isnan(power(-2, 2)));
}

TEMPLATE_TEST_CASE("arctangent2, special values", "[elementary]", float, double) {
    const auto at = [](double y, double x) {
        return arctangent2(static_cast<TestType>(y), static_cast<TestType>(x));
    };
    const auto pi = static_cast<TestType>(std::numbers::pi);
    CHECK(at(0, 0) == 0);
    CHECK(at(-0.0, -0.0) == 0);
    CHECK(at(0, 1) == 0);
    CHECK(at(0, -1) == pi);
    CHECK(at(-0.0, -1) == pi);
    CHECK(at(1, 0) == pi / 2);
    CHECK(at(-1, 0) == -pi / 2);
    CHECK(at(1, 1) == pi / 4);
    CHECK(at(-1, -1) == -static_cast<TestType>(0.75 * std::numbers::pi));
    CHECK(at(1e15, -1e15) == static_cast<TestType>(0.75 * std::numbers::pi));
    CHECK(at(1e-30, 1e15) >= 0);
    CHECK(at(1e-30, -1e15) == pi);
    CHECK(at(-1e-30, -1e15) == -pi);
}

TEST_CASE("arctangent2, a pack's lanes are the scalar's bits", "[elementary]") {
    Random u(2009);
    int different = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::array<std::array<float, 2>, 4> p;
        for (int k = 0; k < 4; ++k) p[k] = point<float>(u, i + k);
        const Four y = Four::lanes([&](int k) { return p[k][0]; });
        const Four x = Four::lanes([&](int k) { return p[k][1]; });
        const Four angles = arctangent2(y, x);
        for (int k = 0; k < 4; ++k) different += angles.lane[k] != arctangent2(p[k][0], p[k][1]);
    }
    CHECK(different == 0);
}
