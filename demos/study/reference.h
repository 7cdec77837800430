// The reference of a study: found, checked against itself and another integrator, and kept.
#pragma once

#include "study/study.h"

#include <filesystem>

namespace plait {

Reference findReference(const Study& study);

// That of the file, if it is of this model and rule; else it is found and written there.
Reference keptReference(const Study& study, const std::filesystem::path& file);

// One line: what it is, how exact, and for how long.
std::string describe(const Study& study, const Reference& reference);

}  // namespace plait
