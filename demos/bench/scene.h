// How fast a scene is taken from numbers to film, in each quality. Prints, never judges.
#pragma once

#include <string>

namespace plait {

// A table for each of draft and preview: what a frame costs, simulated alone and stage by stage in
// `plait run`, where simulating, drawing and encoding overlap; and how long it takes to the first
// frame and to the whole film. Returns an exit status.
int benchScene(const std::string& scene, int threads);

}  // namespace plait
