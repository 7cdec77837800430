// What contact costs: the work that peers were measured on.
#pragma once

namespace plait {

// A sheet of 1 m falls from 5 cm above a ball of 25 cm radius and meets it and itself, for 2 s at
// 60 frames a second, of 64 x 64 and 128 x 128 vertices: milliseconds a frame (median, mean,
// worst), counted work, what crosses and what failed in any frame (none may), the largest strain,
// what 99 % of the threads do not exceed (largest of all frames, and at the end), and how low the
// sheet hangs at the end. Returns an exit status: 1 where something crosses.
int benchDrape(int threads);

}  // namespace plait
