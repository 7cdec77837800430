// Are there only numbers? Every hash and metric is preceded by this: a NaN passes most comparisons,
// and its hash is very stable.
#pragma once

#include <algorithm>
#include <cmath>

#include "math.h"

namespace plait {

inline bool isFinite(double a) { return std::isfinite(a); }

template <class T>
bool isFinite(const Vec<T>& a) {
    return isFinite(a.x) && isFinite(a.y) && isFinite(a.z);
}

// True if no item is infinite or NaN, and so for none at all. A range (span, vector, array) of
// double, float or Vec of these.
template <class Range>
bool allFinite(const Range& values) {
    return std::all_of(values.begin(), values.end(), [](const auto& a) { return isFinite(a); });
}

}  // namespace plait
