// What both sorts of contacts do with the solver's numbers.
#pragma once

#include "../../constraint.h"
#include "../../numbers/convert.h"

#include <algorithm>

namespace plait {

// Part of a gap that contacts keep to the last. What is pressed nearer, and could not cross, is
// counted as failed all the same.
inline constexpr double leastPart = 0.25;

// Moves a vertex back to where the substep began. Returns whether it was elsewhere.
template <class Real>
bool putBack(const Sweep<Real>& sweep, int vertex) {
    Real* const d = sweep.particles + 8 * vertex + 4;
    const Real* const before = sweep.before + 4 * vertex;
    if (std::equal(before, before + 3, d)) return false;
    std::copy_n(before, 3, d);
    return true;
}

// What a gap lacks (m), but for rounding.
inline double lackOf(double distance, double gap) {
    const double lack = gap - distance;
    return lack > 1e-6 * gap ? lack : 0;
}

inline double mean(double a, double b) { return 0.5 * (a + b); }

}  // namespace plait
