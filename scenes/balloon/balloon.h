#pragma once

#include "../knob.h"
#include "../scene.h"

namespace plait {

// A party balloon: limp, blown up, tied and dropped.
Scene balloon(const Knobs& knobs);

}  // namespace plait
