#pragma once

#include "../knob.h"
#include "../scene.h"

namespace plait {

// A wine glass slides off a table.
Scene wineGlass(const Knobs& knobs);

}  // namespace plait
