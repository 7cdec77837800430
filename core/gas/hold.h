// Gas as sets of a world: one multiplier for all that encloses it, which is its gauge pressure.
#pragma once

#include "../sets/sums.h"
#include "enclosure.h"
#include "gas.h"

#include <functional>

namespace plait {

// The gas is linear about where a substep begins, so that multiplier / h^2 of the set's only sum is
// its gauge pressure (Pa) at the end, to second order in what the volume changes by; exactly so if
// that is constant. Below a millionth of what the skin's area can hold its volume counts as that.
// Throws std::invalid_argument, naming the set, for numbers that are out of range.
void holdGas(World& world, const Enclosure& enclosure, const Gas& gas, SetOptions options);
// `gasAt` says what it is at time t (s), a function of t alone: gas let in or out, or warmed.
void holdGas(World& world, const Enclosure& enclosure, std::function<Gas(double t)> gasAt,
             SetOptions options);
// Its volume (m^3) stays; multiplier / h^2 is the pressure that takes, of either sign.
void holdVolume(World& world, const Enclosure& enclosure, double volume, SetOptions options);

}  // namespace plait
