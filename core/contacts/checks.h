// What contacts of either sort refuse.
#pragma once

#include "surface.h"

#include <cmath>

namespace plait {

inline bool isMeasure(double a) { return a >= 0 && std::isfinite(a); }

// Throws std::invalid_argument, naming the set and the value, for one out of range; friction out of
// range is warned of.
void checkSurface(World& world, const Surface& surface, const std::string& set);

}  // namespace plait
