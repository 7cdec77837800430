// Vertices under gravity and soft constraints, whose forces make an ordinary differential equation,
// solved by another way than any method of the core: classical Runge-Kutta of order 4, in double.
#pragma once

#include "trajectory.h"

#include <plait/world.h>

namespace plait {

// `stepsPerFrame` steps to each of the `frames` of `frameLength` seconds; it is stable for steps
// below 2.8 / omega of the fastest mode. Vertices that are pinned stay; forces other than `gravity`
// (m/s^2) are left out. Throws std::invalid_argument for a set that is rigid or has no terms, and
// for steps below 1.
Trajectory softMotion(const World& world, const Vec<double>& gravity, double frameLength,
                      int frames, int stepsPerFrame);

}  // namespace plait
