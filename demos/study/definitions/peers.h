// What other engines made of the sheet on two pins: rigid links, flat at the start, 2 s at 60
// frames a second. Bullet 3.24, Jolt 3b47ec39, PositionBasedDynamics d0894bd and Blender 3.4.1,
// each through its own interface, one thread of an Intel Xeon with AVX-512 at about 2.9 GHz.
#pragma once

#include "demos/study/study.h"

#include <vector>

namespace plait {

// Errors as strainErrors() has them. Empty for sizes other than 128 and 256.
std::vector<Peer> peersOnSheet(int n);

// And of the heavy rod of 64 links, w L^3 / B = 10: Jolt 3b47ec39, one thread of an AMD EPYC with
// AVX-512. Errors are those of cantileverStudy().
std::vector<Peer> peersOnRod();

}  // namespace plait
