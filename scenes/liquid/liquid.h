// Scenes of liquids.
#pragma once

#include "../scene.h"

namespace plait {

Scene damBreak(const Knobs&);

}  // namespace plait
