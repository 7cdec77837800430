// Between float and double, and between vectors and numbers side by side.
#pragma once

#include "math.h"
#include "symmetric.h"

namespace plait {

template <class To, class From>
Vec<To> as(const Vec<From>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}

template <class To, class From>
Symmetric<To> as(const Symmetric<From>& a) {
    const auto to = [](From number) { return static_cast<To>(number); };
    return {to(a.xx), to(a.xy), to(a.xz), to(a.yy), to(a.yz), to(a.zz)};
}

// Three numbers as a vector in double, and back.
template <class Real>
Vec<double> three(const Real* p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

template <class Real>
void put(Real* p, const Vec<double>& v) {
    p[0] = static_cast<Real>(v.x);
    p[1] = static_cast<Real>(v.y);
    p[2] = static_cast<Real>(v.z);
}

}  // namespace plait
