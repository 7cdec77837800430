#pragma once

#include "../knob.h"
#include "../scene.h"

namespace plait {

// A party balloon: limp, blown up, tied and dropped.
Scene balloon(const Knobs& knobs);

// One that is blown up and let go, its neck open.
Scene letGo(const Knobs& knobs);

// One that hangs full and is pricked by a needle.
Scene burst(const Knobs& knobs);

// Two of them, joined by a tube.
Scene twoBalloons(const Knobs& knobs);

}  // namespace plait
