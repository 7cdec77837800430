// Kinds whose rows are evaluated in lanes on curves; any others are too, one by one.
#pragma once

#include "../constraints/kinds.h"
#include "bend_vector.h"
#include "frame_rows.h"

namespace plait {
inline namespace PLAIT_ISA {

using ChainKinds =
    KindList<Stretch, Angle, Bend, BendVector, DirectorAcross, DirectorLength, FrameTurn>;

template <class Kind>
constexpr int valuesOf() {
    if constexpr (requires { Kind::values; })
        return Kind::values;
    else
        return 1;
}

}  // namespace PLAIT_ISA
}  // namespace plait
