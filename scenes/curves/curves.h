// Small scenes of curves: what hangs, blows, catches and carries.
#pragma once

#include "../scene.h"

namespace plait {

Scene goal(const Knobs&);
Scene heavyRod(const Knobs&);
Scene sheetSlinky(const Knobs&);
Scene tendrils(const Knobs&);
Scene tress(const Knobs&);

}  // namespace plait
