// The reference of a study: found, checked against itself and another integrator, and kept.
#pragma once

#include "demos/study/study.h"

#include <filesystem>

namespace plait {

// Shows how many frames are solved unless it is `quiet`. Throws Interrupted.
Reference findReference(const Study& study, bool quiet = true);

// That of the file, if it is of this model and rule; else it is found and written there.
Reference keptReference(const Study& study, const std::filesystem::path& file, bool quiet = true);

// One line: what it is, how exact, and for how long.
std::string describe(const Study& study, const Reference& reference);

}  // namespace plait
