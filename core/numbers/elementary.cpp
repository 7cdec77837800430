#include "elementary.h"

#include "exact.h"

#include <bit>
#include <cstdint>
#include <limits>

namespace plait {
namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double smallestNormal = std::numeric_limits<double>::min();

// ln 2; the first part is short enough for its product with any exponent to be exact.
constexpr double ln2High = 0x1.62e42fefap-1, ln2Low = 0x1.cf79abc9e3b3ap-40;

// The nearest integer, ties to even, for |a| < 2^51.
double nearest(double a) { return (a + 0x1.8p52) - 0x1.8p52; }

// 2^k for a normal result.
double powerOfTwo(int k) {
    return std::bit_cast<double>(static_cast<std::int64_t>(k + 1023) << 52);
}

// x - n pi/2 with n the nearest integer to x 2/pi. The first three parts of pi/2 have 33 bits, so
// that their products with n are exact; with four, no double near a multiple of pi/2 loses digits.
struct Reduced {
    Twofold angle;
    int quadrant;
};
Reduced reduce(double x) {
    const double n = nearest(x * 0x1.45f306dc9c883p-1);
    const Twofold a = exactSum(x - n * 0x1.921fb544p+0, -n * 0x1.0b4611a6p-34);
    const Twofold b = exactSum(a.high, -n * 0x1.3198a2ep-69);
    return {exactSum(b.high, (a.low + b.low) - n * 0x1.b839a252049c1p-104),
            static_cast<int>(n) & 3};
}

// sin r for |r| <= pi/4; relative error of the fit 3e-18.
double sineNear(Twofold r) {
    const double x = r.high, z = x * x;
    const double p =
        polynomial(z, -0.16666666666666632, 0.0083333333333224, -0.00019841269829790027,
                   2.7557313684116385e-06, -2.5050756698030027e-08, 1.589670427453672e-10);
    return x + (x * (z * p) + r.low * (1 - 0.5 * z));
}

// cos r for |r| <= pi/4; error of the fit 5e-20. 1 - z/2 keeps its rounding error.
double cosineNear(Twofold r) {
    const double x = r.high, z = x * x, half = 0.5 * z, most = 1 - half;
    const double p =
        polynomial(z, 0.041666666666666616, -0.001388888888887611, 2.480158729054701e-05,
                   -2.755731462300453e-07, 2.087575624221541e-09, -1.1361198428505268e-11);
    return most + (((1 - most) - half) + (z * z * p - x * r.low));
}

// sin(x + quarters pi/2).
double sineFrom(double x, int quarters) {
    if (!(x >= -1e6 && x <= 1e6)) return notANumber;
    const Reduced r = reduce(x);
    const int quadrant = (r.quadrant + quarters) & 3;
    const double value = quadrant & 1 ? cosineNear(r.angle) : sineNear(r.angle);
    return quadrant & 2 ? -value : value;
}

// e^(x.high + x.low): 2^k e^r with |r| <= ln(2)/2, scaled in two halves as 2^1024 is not a double.
double exponentialOf(Twofold x) {
    if (!(x.high >= -708.39)) return x.high < 0 ? 0 : notANumber;
    if (x.high > 709.79) return infinity;
    const double k = nearest(x.high * 0x1.71547652b82fep+0);
    const double high = x.high - k * ln2High, low = x.low - k * ln2Low, r = high + low;
    const double p =
        polynomial(r, 0.5, 0.16666666666666685, 0.04166666666666673, 0.008333333333316685,
                   0.0013888888888858452, 0.00019841269897194868, 2.4801587373712557e-05,
                   2.7557234099033922e-06, 2.755723338694756e-07, 2.5112288507391998e-08,
                   2.092693451693216e-09);
    const int whole = static_cast<int>(k), half = whole / 2;
    return (1 + (high + (r * r * p + low))) * powerOfTwo(half) * powerOfTwo(whole - half);
}

// ln x for normal x: x = 2^k m with m in [sqrt(1/2), sqrt(2)), ln m = 2 atanh s, s = (m - 1)/(m +
// 1).
Twofold logarithmOf(double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    const auto rootHalf = std::bit_cast<std::int64_t>(0x1.6a09e667f3bcdp-1);
    const auto k = (bits - rootHalf) >> 52;
    const double m = std::bit_cast<double>(bits - k * (std::int64_t{1} << 52));
    const double f = m - 1, d = 2 + f, dLow = f - (d - 2), s = f / d;
    const Twofold sd = exactProduct(s, d);
    const double sLow = (((f - sd.high) - sd.low) - s * dLow) / d, z = s * s;
    const double p = polynomial(z, 0.6666666666666666, 0.4000000000000489, 0.2857142856941459,
                                0.22222222607015013, 0.1818177831998508, 0.15386991412917966,
                                0.132520729367667, 0.13235584602406236);
    const auto whole = static_cast<double>(k);
    const Twofold most = exactSum(whole * ln2High, 2 * s);
    return exactSum(most.high, most.low + ((2 * sLow + s * (z * p)) + whole * ln2Low));
}

}  // namespace

double sine(double x) { return sineFrom(x, 0); }

double cosine(double x) { return sineFrom(x, 1); }

double exponential(double x) { return exponentialOf({x, 0}); }

double logarithm(double x) {
    if (!(x >= smallestNormal)) return x > -smallestNormal ? -infinity : notANumber;
    if (x == infinity) return infinity;
    return logarithmOf(x).high;
}

double power(double base, double exponent) {
    if (exponent == 0) return 1;
    const double l = logarithm(base), estimate = exponent * l;
    if (!(estimate > -750 && estimate < 750)) return exponential(estimate);
    const Twofold ln = logarithmOf(base), product = exactProduct(exponent, ln.high);
    return exponentialOf({product.high, product.low + exponent * ln.low});
}

}  // namespace plait
