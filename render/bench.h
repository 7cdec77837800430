// What drawing costs.
#pragma once

#include "renderer.h"

namespace plait {

struct RenderTimes {
    double start = 0;  // s, of the constructor: context, shaders, tables
    double first = 0;  // s, of the first frame, which compiles the shaders for this processor
    double frame = 0;  // s, the least of the others
};

// Draws a waving cloth of `cells` by `cells` cells, two triangles each, `frames` times.
RenderTimes benchRender(const RenderOptions& options = {}, int cells = 100, int frames = 8);

}  // namespace plait
