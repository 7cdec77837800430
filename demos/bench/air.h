// The cost of the air. Prints, never judges.
#pragma once

namespace plait {

// Returns an exit status.
int benchAir();

}  // namespace plait
