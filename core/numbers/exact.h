// Sums and products of two doubles without error, from rounded operations alone: what
// elementary.cpp and the exact predicates of measure/ stand on. They need -ffp-contract=off and
// round-to-nearest.
#pragma once

namespace plait {

// The unevaluated sum high + low, where high is that sum rounded.
struct Twofold {
    double high, low;
};

// a + b (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B). Exact unless it overflows.
inline Twofold exactSum(double a, double b) {
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}

// a b by halves of 26 bits (Dekker 1971). Exact for |a|, |b| below 2^996 where |a b| is 0 or in
// [2^-968, 2^1023].
inline Twofold exactProduct(double a, double b) {
    const auto upper = [](double c) {
        const double t = 0x1.0000002p27 * c;
        return t - (t - c);
    };
    const double ah = upper(a), al = a - ah, bh = upper(b), bl = b - bh, p = a * b;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

}  // namespace plait
