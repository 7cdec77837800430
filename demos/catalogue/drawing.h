// A schedule as a drawing: S figures 9 and 11, for one scene.
#pragma once

#include "facts.h"

#include <string>

namespace plait {

// SVG to stand in a page: sets in their order from the top, columns from the left, a mark for each
// evaluation of the first substep; how a frame is cut into substeps below. Its colours are the
// page's. Names of sets are links to `links`, one a set; "" for none.
std::string scheduleDrawing(const SceneFacts& facts, const std::vector<std::string>& links);

// What it shows, in a sentence or two.
std::string scheduleWords(const SceneFacts& facts);

}  // namespace plait
