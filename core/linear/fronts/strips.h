// Where the strips of a front are, and how many packs of a type a column of one takes.
#pragma once

#include "front_kernels.h"
#include "fused.h"

namespace plait {
inline namespace PLAIT_ISA {

template <class T>
inline constexpr int packs = stripRows / Lanes<T>::count;  // in a column of a strip

inline float* panelStrip(const FrontView& f, int s) {
    return f.panel + stripRows * columnsBefore(f.pivotStrips, s);
}
inline float* schurStrip(const FrontView& f, int s) {
    return f.schur + stripRows * columnsBefore(s);
}

}  // namespace PLAIT_ISA
}  // namespace plait
