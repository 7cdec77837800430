// How looking for contacts grows with the mesh. Prints and charts, never judges.
#pragma once

namespace plait {

// A table, and out/bench/detection/chart.svg and .png. Returns an exit status.
int benchDetection();

}  // namespace plait
