// The exact predicate against integer and rational arithmetic.
#include "tests/catch.h"
#include "tests/random.h"

#include <plait/measure/surfaces/orientation.h>

#include <array>
#include <cmath>
#include <utility>

#if __has_include(<gmpxx.h>) && !defined(PLAIT_WITHOUT_GMP)
#define PLAIT_GMP
#include <gmpxx.h>
#endif

using namespace plait;
using plait::test::Random;

namespace {

using V = Vec<double>;

#ifdef PLAIT_GMP
int exactOrientation(const V& a, const V& b, const V& c, const V& d) {
    const auto relative = [&](const V& p) {
        return std::array<mpq_class, 3>{mpq_class(p.x) - mpq_class(d.x),
                                        mpq_class(p.y) - mpq_class(d.y),
                                        mpq_class(p.z) - mpq_class(d.z)};
    };
    const auto u = relative(a), v = relative(b), w = relative(c);
    const mpq_class determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                  u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                  u[2] * (v[0] * w[1] - v[1] * w[0]);
    return sgn(determinant);
}

// Four points of one of several families, most of them in a plane or an ulp beside it.
std::array<V, 4> fourPoints(Random& random, int family) {
    std::array<V, 4> p;
    for (auto& x : p) x = random.point(family == 1 ? 1e-70 : 1);
    const double s = random.uniform(-1, 2), t = random.uniform(-1, 2);
    if (family == 2 || family == 3) p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    if (family == 3) p[3] += V{1e6, -1e6, 3e5}, p[0] += V{1e6, -1e6, 3e5};
    if (family == 4) p[3] = p[1] + s * (p[0] - p[1]);
    if (family == 5) p[3] = p[2];
    if (family == 6) {
        for (auto& x : p) x = {std::floor(8 * x.x) / 10, std::floor(8 * x.y) / 10, x.x / 3};
    }
    if (family == 7) {
        for (auto& x : p) x = {x.x * std::exp2(random.uniform(-200, 200)), x.y, x.z * 1e-30};
    }
    if (family == 8) {
        for (auto& x : p) x.z = x.x + x.y;
    }
    return p;
}
#endif

}  // namespace

TEST_CASE("orientation of simple tetrahedra", "[orientation]") {
    const V o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    CHECK(orientation(x, y, z, o) == 1);
    CHECK(orientation(y, x, z, o) == -1);
    CHECK(orientation(x, y, V{0.25, 0.25, 0}, o) == 0);
    // Three tenths are not 0.3: the plane x + y + z = 0.6 as rounded, exactly.
    CHECK(orientation({0.6, 0, 0}, {0, 0.6, 0}, {0, 0, 0.6}, {0.1, 0.2, 0.3}) != 0);
    CHECK(orientation({0.75, 0, 0}, {0, 0.75, 0}, {0, 0, 0.75}, {0.125, 0.25, 0.375}) == 0);
}

// Whole coordinates below 2^39: the determinant has less than 127 bits.
TEST_CASE("orientation is that of 128-bit integers", "[orientation]") {
    __extension__ using Wide = __int128;
    Random random(7);
    int wrong = 0, zero = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::array<V, 4> p;
        for (auto& x : p)
            x = {std::round(random.uniform(-1, 1) * 0x1p36), random.below(9) - 4.0, 0};
        for (auto& x : p) x.z = std::round(random.uniform(-1, 1) * 0x1p36);
        // In the plane of the others, then a unit beside it half of the time.
        p[3] = p[0] + (random.below(7) - 3.0) * (p[1] - p[2]);
        p[3].y += random.below(2);
        std::swap(p[3], p[random.below(4)]);
        const auto relative = [&](const V& a) {
            const V d = a - p[3];
            return std::array{static_cast<Wide>(d.x), static_cast<Wide>(d.y),
                              static_cast<Wide>(d.z)};
        };
        const auto u = relative(p[0]), v = relative(p[1]), w = relative(p[2]);
        const Wide determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                 u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                 u[2] * (v[0] * w[1] - v[1] * w[0]);
        const int sign = (determinant > 0) - (determinant < 0);
        wrong += orientation(p[0], p[1], p[2], p[3]) != sign;
        zero += sign == 0;
    }
    CHECK(wrong == 0);
    CHECK(zero > 5'000);
    CHECK(zero < 15'000);
}

#ifdef PLAIT_GMP
TEST_CASE("orientation is that of rational arithmetic", "[orientation]") {
    Random random(7);
    for (int family = 0; family < 9; ++family) {
        int wrong = 0, zero = 0;
        for (int i = 0; i < 3000; ++i) {
            auto p = fourPoints(random, family);
            std::swap(p[3], p[random.below(4)]);
            const int exact = exactOrientation(p[0], p[1], p[2], p[3]);
            wrong += orientation(p[0], p[1], p[2], p[3]) != exact;
            zero += exact == 0;
        }
        CAPTURE(family, zero);
        CHECK(wrong == 0);
        // Coplanar to the bit, and coplanar but for rounding.
        if (family == 5) CHECK(zero == 3000);
        if (family == 3) CHECK(zero < 3000);
    }
}
#endif
