// A world's natural pose, taken as its start [SH11]: cloth that hangs before the film begins.
#pragma once

#include "solver_options.h"
#include "world.h"

namespace plait {

struct RelaxOptions {
    double speed = 1e-4;   // m/s, at which the fastest vertex counts as at rest; above 0
    int frames = 2400;     // at most, 1 or more
    double damping = 0.3;  // part of the velocity that is lost in 1/24 s, 0 to below 1,
                           // unless the solver's own is more; best for a swing of 1.5 s
};

struct Relaxed {
    int frames;    // taken
    double speed;  // m/s, of the fastest vertex at the end
};

// Runs `world` damped, in double, until no vertex is faster than `speed` at the end of two frames
// in a row; puts every vertex that is not pinned where it then is, at rest. Rest shapes stay as
// they are. Pins stay where they are at time 0; what else changes with time, such as gusts and
// targets, goes on meanwhile and may never let the world rest: compare the speed returned with the
// one asked for. Throws std::invalid_argument for options out of range, and what Solver throws.
Relaxed relax(World& world, SolverOptions options, const RelaxOptions& relaxation = {});

}  // namespace plait
