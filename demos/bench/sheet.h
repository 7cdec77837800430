// How cheaply an inextensible sheet is held: the work that peers were measured on.
#pragma once

namespace plait {

// A sheet of 1 m on two pins falls for 2 s at 60 frames a second, of 64 x 64 to 512 x 512 vertices,
// with the sets and the counted work that reach 1 % and 0.1 %: milliseconds to set it up and a
// frame (median), the largest strain over the last second (and its mean over frames) and before,
// and, since a sheet that does not move does not stretch either, its first swing, where it is after
// 1 s and the energy lost by then, beside a converged run. Returns an exit status.
int benchSheet(int threads);

}  // namespace plait
