// Polynomials know how wrong they may be: their bounds against rational arithmetic.
#include "integer_polynomial.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/collision/polynomials.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

#ifdef PLAIT_GMP
namespace {

Rational exact(double a) { return Rational(a); }
Rational exact(const DoubleDouble& a) { return Rational(a.high) + Rational(a.low); }

Rational exactDot(const Vec<double>& a, const Vec<double>& b) {
    return exact(a.x) * exact(b.x) + exact(a.y) * exact(b.y) + exact(a.z) * exact(b.z);
}

template <class T>
T number(Random& random) {
    const double size = std::exp2(random.below(20) - 10);
    return T(random.uniform(-size, size)) + T(random.uniform(-0x1p-54, 0x1p-54) * size);
}

template <int n, class T>
Bernstein<n, T> draw(Random& random) {
    Bernstein<n, T> p;
    for (T& c : p.c) c = number<T>(random);
    p.error = 0;
    return p;
}

// How far coefficients are from those meant, of what they may be, and the greatest of it so far.
template <int n, class T>
void hold(const Bernstein<n, T>& p, const std::vector<Rational>& meant, double& worst) {
    for (int i = 0; i <= n; ++i) {
        const Rational off = abs(Rational(exact(p.c[i]) - meant[i]));
        if (off != 0) worst = std::max(worst, p.error > 0 ? off.get_d() / p.error : HUGE_VAL);
    }
}

template <int m, int n, class T>
std::vector<Rational> productOf(const Bernstein<m, T>& a, const Bernstein<n, T>& b) {
    using detail::binomial;
    std::vector<Rational> product(m + n + 1);
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
            product[i + j] += exact(a.c[i]) * exact(b.c[j]) *
                              Rational(binomial(m, i) * binomial(n, j)) /
                              Rational(binomial(m + n, i + j));
    return product;
}

template <class T>
void holdOperations() {
    Random random(6);
    double sum = 0, product = 0, multiple = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto a = draw<2, T>(random), c = draw<2, T>(random);
        const auto b = draw<4, T>(random);
        std::vector<Rational> sums, multiples;
        const T s = number<T>(random);
        for (int k = 0; k <= 2; ++k) {
            sums.push_back(exact(a.c[k]) + exact(c.c[k]));
            multiples.push_back(exact(s) * exact(a.c[k]));
        }
        hold(a + c, sums, sum);
        hold(s * a, multiples, multiple);
        hold(a * b, productOf(a, b), product);
        hold(a * c, productOf(a, c), product);
    }
    CHECK(report("error / bound of a sum", sum, 1));
    CHECK(report("  of a multiple", multiple, 1));
    CHECK(report("  of a product", product, 1));
}

}  // namespace

TEST_CASE("polynomials are within their bounds of those meant", "[roots][ccd][CC7]") {
    holdOperations<double>();
    holdOperations<DoubleDouble>();
}

TEST_CASE("differences and squares of distances are within their bounds", "[ccd][CC6]") {
    Random random(7);
    double difference = 0, square = 0;
    for (int i = 0; i < 3000; ++i) {
        // Nothing is scaled: the greatest coordinate is in [0.5, 1).
        MovingVertex a{random.point(0.1), random.point(1e-3)}, b = {random.point(1), {0, 0, 0.75}};
        const Difference<1> d = pointPoint<double>(a, b, 0);
        const Bernstein<1> x = course(d.corner[0]).x;
        hold(x, {Rational(b.start.x) - Rational(a.start.x), Rational(b.end.x) - Rational(a.end.x)},
             difference);
        const double h = random.uniform(0, 8);
        const Rational near = Rational(h) * Rational(h);
        hold(pointPolynomial(a, h),
             {exactDot(a.start, a.start) - near, exactDot(a.start, a.end) - near,
              exactDot(a.end, a.end) - near},
             square);
    }
    CHECK(report("error / bound of a difference", difference, 1));
    CHECK(report("  of a square of a distance", square, 1));
}
#endif
