// The cost of collision queries, one by one, and how their answers compare with exact ones. Prints,
// never judges.
#pragma once

namespace plait {

// Reads the query sets of the folder that PLAIT_CCD_DATA names, or ../shared/ccd; random queries
// where the latter has none. Returns an exit status. Throws FileError.
int benchCcd();

}  // namespace plait
