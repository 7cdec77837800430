// What a rod costs, solved at once along its curve, and how true it is. Prints, never judges.
#pragma once

namespace plait {

// Returns an exit status.
int benchRods();

}  // namespace plait
