// Numbers of twice the digits of a double, for what double cannot decide.
#pragma once

#include "../numbers/exact.h"

namespace plait {

// The unevaluated sum high + low, |low| at most half an ulp of high: some 32 digits. Sums and
// products of two have a relative error of at most 7 * 2^-106, quotients 15 * 2^-106 (Joldes,
// Muller, Popescu, Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic, 2017, algorithms 6, 10 and 17), as long as nothing underflows.
struct DoubleDouble {
    double high, low;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double a) : high(a), low(0) {}  // a double is one: implicit
    DoubleDouble(const Twofold& a) : high(a.high), low(a.low) {}

    explicit operator double() const { return high; }

    friend DoubleDouble operator-(const DoubleDouble& a) { return Twofold{-a.high, -a.low}; }
    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const Twofold s = exactSum(a.high, b.high), t = exactSum(a.low, b.low);
        const Twofold v = exactSum(s.high, s.low + t.high);
        return exactSum(v.high, t.low + v.low);
    }
    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const Twofold p = exactProduct(a.high, b.high);
        return exactSum(p.high, p.low + (a.high * b.low + a.low * b.high));
    }
    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double q = a.high / b.high;
        const DoubleDouble r = a - b * DoubleDouble(q);
        return exactSum(q, r.high / b.high);
    }
    DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
    DoubleDouble& operator*=(const DoubleDouble& b) { return *this = *this * b; }

    friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) = default;
    friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b < a || a == b; }
    friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) { return b >= a; }
};

}  // namespace plait
