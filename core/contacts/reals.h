// Three of the solver's numbers as a vector in double, and back.
#pragma once

#include "../math.h"

namespace plait {

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

inline double mean(double a, double b) { return 0.5 * (a + b); }

}  // namespace plait
