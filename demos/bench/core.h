// The cost of the core's inner loops, beside a hand-written loop as the floor. Prints, never
// judges.
#pragma once

namespace plait {

// Returns an exit status.
int benchCore();

}  // namespace plait
