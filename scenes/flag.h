// The flag: silk at a pole, in wind that calms, freshens and gusts.
#pragma once

#include "scene.h"

namespace plait {

Scene flag(const Knobs&);

}  // namespace plait
