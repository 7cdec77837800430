// The ballerina's dress: a skirt of two layers in contact with itself and with her, while she
// dances.
#pragma once

#include "scene.h"

namespace plait {

Scene dress(const Knobs&);

}  // namespace plait
