// Polynomials on [0, 1] that know how wrong they may be.
#pragma once

#include "double_double.h"

namespace plait {

// Twice the relative error of an operation: bounds count roundings with it, so that the roundings
// of the bounds themselves, always doubles, are covered as well.
template <class T>
inline constexpr double roundoff = 0;
template <>
inline constexpr double roundoff<double> = 0x1p-52;
template <>
inline constexpr double roundoff<DoubleDouble> = 0x1p-101;

namespace detail {

// Where sizes are near 1, below all that a query can tell from 0: it covers what underflow loses.
inline constexpr double tiny = 0x1p-900;

// n choose k.
constexpr double binomial(int n, int k) {
    double b = 1;
    for (int i = 1; i <= k; ++i) b = b * (n - k + i) / i;
    return b;
}

template <class T>
constexpr T magnitude(const T& a) {
    return a < 0 ? -a : a;
}
template <class T>
constexpr T larger(const T& a, const T& b) {
    return a < b ? b : a;
}

}  // namespace detail

// The polynomial sum of c[i] B_i(t), B_i(t) = (n choose i) t^i (1 - t)^(n - i), on [0, 1], where it
// lies between the least and the greatest coefficient (Farouki, The Bernstein polynomial basis: a
// centennial retrospective, 2012). Every coefficient is within `error` of the one meant, as the
// usual forward analysis has it (Higham, Accuracy and Stability of Numerical Algorithms, 3.1), as
// long as nothing underflows. T: double or DoubleDouble.
template <int n, class T = double>
struct Bernstein {
    T c[n + 1];
    double error;

    // The greatest |c[i]|.
    double size() const {
        double s = 0;
        for (const T& a : c) s = detail::larger(s, detail::magnitude(static_cast<double>(a)));
        return s;
    }

    friend Bernstein operator+(const Bernstein& a, const Bernstein& b) {
        Bernstein sum;
        for (int i = 0; i <= n; ++i) sum.c[i] = a.c[i] + b.c[i];
        sum.error = (a.error + b.error + roundoff<T> * sum.size()) * (1 + roundoff<double>);
        return sum;
    }
    friend Bernstein operator-(const Bernstein& a, const Bernstein& b) {
        Bernstein negative = b;
        for (T& coefficient : negative.c) coefficient = -coefficient;
        return a + negative;
    }
    friend Bernstein operator*(const T& s, const Bernstein& a) {
        Bernstein product;
        for (int i = 0; i <= n; ++i) product.c[i] = s * a.c[i];
        product.error =
            (detail::magnitude(static_cast<double>(s)) * a.error + roundoff<T> * product.size()) *
            (1 + 2 * roundoff<double>);
        return product;
    }
};

// Farouki 2012, equation (44). The weights of a coefficient add up to 1, so the sizes bound it.
template <int m, int n, class T>
Bernstein<m + n, T> operator*(const Bernstein<m, T>& a, const Bernstein<n, T>& b) {
    using detail::binomial;
    Bernstein<m + n, T> product{};
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            const T weight = T(binomial(m, i) * binomial(n, j)) / T(binomial(m + n, i + j));
            product.c[i + j] += weight * (a.c[i] * b.c[j]);
        }
    }
    constexpr int fewer = m < n ? m : n;
    const double p = a.size(), q = b.size();
    product.error =
        (p * b.error + q * a.error + a.error * b.error + (fewer + 3) * roundoff<T> * p * q) *
        (1 + 4 * roundoff<double>);
    return product;
}

// A point that moves along a polynomial in every coordinate.
template <int n, class T>
struct Course {
    Bernstein<n, T> x, y, z;
};

template <int m, int n, class T>
Bernstein<m + n, T> dot(const Course<m, T>& a, const Course<n, T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <int m, int n, class T>
Course<m + n, T> cross(const Course<m, T>& a, const Course<n, T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace plait
