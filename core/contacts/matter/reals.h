// Three of the solver's numbers as a vector in double, and back.
#pragma once

#include "../../constraint.h"
#include "../../numbers/math.h"

#include <algorithm>

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

// Moves a vertex back to where the substep began. Returns whether it was elsewhere.
template <class Real>
bool putBack(const Sweep<Real>& sweep, int vertex) {
    Real* const d = sweep.particles + 8 * vertex + 4;
    const Real* const before = sweep.before + 4 * vertex;
    if (std::equal(before, before + 3, d)) return false;
    std::copy_n(before, 3, d);
    return true;
}

inline double mean(double a, double b) { return 0.5 * (a + b); }

}  // namespace plait
