// One run of a study: solved, timed and recorded.
#pragma once

#include "study.h"

#include <limits>

namespace plait {

// Time is that of Solver::frame alone, on one thread. Short runs are run again, unrecorded, for 50
// ms, and their median counts; the recorded one is the warm-up. What cannot run says so in
// `ending`, and so does what sweeps more than `mostWork` constraints, where it ends.
Recording solve(const Study& study, const Run& run, bool timed = true,
                long mostWork = std::numeric_limits<long>::max());

// Keeps the calling thread on the k-th core that the program may use, counted round.
void pinThread(int k);

int movingVertices(const World& world);

}  // namespace plait
