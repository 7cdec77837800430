// A number and its derivative in one direction: `evaluate` of a kind, run in it, gives second
// derivatives to the last digit, with no text of their own.
#pragma once

#include "math.h"

namespace plait {

template <class T>
struct Dual {
    T value, slope;

    Dual() = default;
    Dual(T v, T s) : value(v), slope(s) {}
    template <class S>
        requires(__is_same(S, float) || __is_same(S, double) || __is_same(S, int))
    explicit Dual(S s) : value(static_cast<T>(s)), slope(0) {}

    friend Dual operator+(const Dual& a, const Dual& b) {
        return {a.value + b.value, a.slope + b.slope};
    }
    friend Dual operator-(const Dual& a, const Dual& b) {
        return {a.value - b.value, a.slope - b.slope};
    }
    friend Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
    friend Dual operator*(const Dual& a, const Dual& b) {
        return {a.value * b.value, a.slope * b.value + a.value * b.slope};
    }
    friend Dual operator/(const Dual& a, const Dual& b) {
        const T q = a.value / b.value;
        return {q, (a.slope - q * b.slope) / b.value};
    }
    friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
};

template <class T>
Dual<T> select(bool mask, const Dual<T>& yes, const Dual<T>& no) {
    return mask ? yes : no;
}

template <class T>
Dual<T> squareRoot(const Dual<T>& a) {
    const T root = squareRoot(a.value);
    return {root, divide(a.slope, 2 * root)};
}

// By its derivative: the slope of the polynomials in arctangent.h is less exact than they are.
template <class T>
Dual<T> arctangent2(const Dual<T>& y, const Dual<T>& x) {
    return {arctangent2(y.value, x.value),
            divide(x.value * y.slope - y.value * x.slope, x.value * x.value + y.value * y.value)};
}

}  // namespace plait
