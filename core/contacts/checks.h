// What contacts of either sort refuse.
#pragma once

#include "surface.h"

#include <cmath>

namespace plait {

inline bool isMeasure(double a) { return a >= 0 && std::isfinite(a); }

// The surface, its thickness given. Throws std::invalid_argument, naming the set and the value, for
// one out of range; friction out of range is warned of.
Surface checked(World& world, Surface surface, const std::string& set);

}  // namespace plait
