// Points that come and go: what is poured, thrown and let go of.
#pragma once

#include "../scene.h"

namespace plait {

Scene dissolve(const Knobs&);
Scene fireworks(const Knobs&);
Scene grainPile(const Knobs&);

}  // namespace plait
