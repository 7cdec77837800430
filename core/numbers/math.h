// Small vectors for every number type a kernel runs in: double, float and the packs of lanes.h.
//
// Everything that is compiled once per instruction set lives in an inline namespace of its own
// (PLAIT_ISA), so that the linker can never pick a function built for a wider processor.
// Here belong only plain arithmetic types; what knows particles or constraints does not.
#pragma once

#ifndef PLAIT_ISA
#define PLAIT_ISA base
#endif

namespace plait {
inline namespace PLAIT_ISA {

// The scalar behind a number type, and how many of them it holds.
template <class T>
struct Lanes {
    using Scalar = T;
    static constexpr int count = 1;
};
template <class T>
using Scalar = typename Lanes<T>::Scalar;

inline constexpr double pi = 3.14159265358979323846, infinity = __builtin_inf();

inline float squareRoot(float a) { return __builtin_sqrtf(a); }
inline double squareRoot(double a) { return __builtin_sqrt(a); }

// Lane-wise choice; for scalars the mask is bool. Both sides are always evaluated.
template <class T>
    requires(__is_same(T, float) || __is_same(T, double))
T select(bool mask, T yes, T no) {
    return mask ? yes : no;
}

// a / b, and 0 where b is not above 1e-30: the only division kernels use. Coincident points, zero
// areas and constraints between pinned vertices end here, instead of in a NaN whose hash is stable.
template <class T>
T divide(T a, T b) {
    const auto safe = b > T(1e-30);
    return select(safe, a, T(0)) / select(safe, b, T(1));
}

template <class T>
struct Vec {
    T x, y, z;

    Vec& operator+=(const Vec& b) { return *this = *this + b; }
    Vec& operator-=(const Vec& b) { return *this = *this - b; }

    friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec operator-(const Vec& a) { return {-a.x, -a.y, -a.z}; }
    friend Vec operator*(T s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend Vec operator*(const Vec& a, T s) { return {s * a.x, s * a.y, s * a.z}; }
    friend bool operator==(const Vec&, const Vec&) = default;
};

template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T length(const Vec<T>& a) {
    return squareRoot(dot(a, a));
}

// A fixed array with no library function behind it (std::array's members could be shared between
// instruction sets at -O0).
template <class T, int n>
struct Stencil {
    T item[n];

    T& operator[](int i) { return item[i]; }
    const T& operator[](int i) const { return item[i]; }
    T* begin() { return item; }
    T* end() { return item + n; }
    const T* begin() const { return item; }
    const T* end() const { return item + n; }
};

}  // namespace PLAIT_ISA
}  // namespace plait
