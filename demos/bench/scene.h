// How fast a scene is taken from numbers to film, in each quality. Prints, never judges.
#pragma once

#include <string>

namespace plait {

// A line of figures for each of draft and preview: simulating alone, drawing alone, and both with
// encoding as `plait run` has them; and how long the first frame takes. Returns an exit status.
int benchScene(const std::string& scene, int threads);

}  // namespace plait
