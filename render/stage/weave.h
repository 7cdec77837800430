// The threads of a cloth, as a small table that repeats.
#pragma once

#include "render/gl/gpu.h"

namespace plait {

// Of two threads, m. Where a pixel is wider the table is even.
inline constexpr float weavePitch = 0.0025f;

// 4 cm of cloth: tilt of the surface along and across the warp and lightness, all around one half.
// With mipmaps: seen from afar it is even, so that it never aliases.
Texture makeWeave();

}  // namespace plait
