// A chain of rigid links under gravity, solved by another way than any method of the core: forces
// of constraint from a tridiagonal system (index 1), classical Runge-Kutta of order 4, and after
// each step a projection onto the links and their rates (Hairer, Wanner, "Solving ordinary
// differential equations II", VII.2). In double.
#pragma once

#include "trajectory.h"

#include <plait/world.h>

namespace plait {

// The vertices of `world`, in the order in which links of their rest length join them, from its
// start on; `stepsPerFrame` steps to each of the `frames` of `frameLength` seconds. Vertices that
// are pinned stay. Throws std::invalid_argument for fewer than two vertices or steps below 1.
Trajectory rigidChain(const World& world, const Vec<double>& gravity, double frameLength,
                      int frames, int stepsPerFrame);

// A bob on the link from vertex 0, pinned, to vertex 1, as the equation of its angle:
// a'' = -(g / l) sin a, by the same Runge-Kutta method. It swings in the plane z = 0.
Trajectory pendulumByAngle(const World& world, double g, double frameLength, int frames,
                           int stepsPerFrame);

}  // namespace plait
