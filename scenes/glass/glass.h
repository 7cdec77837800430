#pragma once

#include "../knob.h"
#include "../scene.h"

namespace plait {

// A pane in a frame, and a ball of steel that goes through it.
Scene glass(const Knobs& knobs);

}  // namespace plait
