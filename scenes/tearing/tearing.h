#pragma once

#include "../knob.h"
#include "../scene.h"

namespace plait {

// Two hands tear a vest from its hem up, and let go.
Scene tornVest(const Knobs& knobs);

}  // namespace plait
