// atan2 as one text for double, float and packs: +, -, *, / and select only, so it gives the same
// bits in every lane, on every processor and from every compiler (libm's does not).
#pragma once

#include "math.h"

namespace plait {
inline namespace PLAIT_ISA {

// c0 + z (c1 + z (c2 + ...)), in that order of operations.
template <class T>
T polynomial(T, double last) {
    return T(last);
}
template <class T, class... Rest>
T polynomial(T z, double first, Rest... rest) {
    return T(first) + z * polynomial(z, rest...);
}

// The angle of (x, y) from the x axis in radians, in [-pi, pi]; error below 2 ulp of T.
//
// A y of either zero counts as +0: (0, x < 0) is pi, and -pi comes only from rounding a y < 0.
// (0, 0) is 0. Finite for all finite input below 1e15 in magnitude; y / x may underflow to 0.
//
// The plane is cut into five fans around k pi/4, k = 0 ... 4, in each of which the angle is
// k pi/4 + atan(q) with |q| <= 1/2. The polynomials are minimax on q^2 <= 1/4, relative error 5e-18
// (double) and 3e-10 (float). pi/4 is in two parts, the first short enough
// for k times it to be exact.
template <class T>
T arctangent2(T y, T x) {
    constexpr bool isDouble = __is_same(Scalar<T>, double);
    const T zero = T(0), one = T(1);
    const T ax = select(x < zero, zero - x, x), ay = select(y < zero, zero - y, y);

    const auto left = x < zero;
    const auto steep = ay > ax;
    const auto diagonal = select(steep, ax + ax, ay + ay) > select(steep, ay, ax);
    const T sum = ay + x, difference = ay - x;
    const T above =
        select(diagonal, select(left, zero - sum, difference), select(steep, zero - x, ay));
    const T below = select(diagonal, select(left, difference, sum), select(steep, ay, x));
    const T q = above / select(ax + ay > zero, below, one);
    const T k =
        select(diagonal, select(left, T(3), one), select(steep, T(2), select(left, T(4), zero)));

    const T z = q * q;
    T p;
    if constexpr (isDouble) {
        p = polynomial(z, -0.3333333333333322, 0.1999999999994612, -0.14285714279305858,
                       0.11111110763149698, -0.09090898439417064, 0.07692103751768396,
                       -0.06664080145953823, 0.0585993489298009, -0.05128602993472096,
                       0.04203455407213899, -0.027686127541068403, 0.010280207228516804);
    } else {
        p = polynomial(z, -0.333333272, 0.199995038, -0.142723239, 0.109428919, -0.0799087642,
                       0.038814226);
    }
    const T quarter = T(isDouble ? 0x1.921fb54442d18p-1 : 0x1.921fbp-1);
    const T rest = T(isDouble ? 0x1.1a62633145c07p-55 : 0x1.5110b4p-23);
    const T angle = k * quarter + (q + (q * (z * p) + k * rest));
    return select(y < zero, zero - angle, angle);
}

}  // namespace PLAIT_ISA
}  // namespace plait
