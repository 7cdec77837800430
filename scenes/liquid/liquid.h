// Scenes of liquids.
#pragma once

#include "../scene.h"

namespace plait {

Scene damBreak(const Knobs&);
Scene droplets(const Knobs&);
Scene pouring(const Knobs&);
Scene caramel(const Knobs&);

}  // namespace plait
