// The files of a sequence, by a pattern; not for use outside its reader.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace plait {

using NumberedFiles = std::vector<std::pair<long long, std::filesystem::path>>;

// The files that a path matches (MeshSequence says how), ascending by number and evenly so.
// Throws MeshFileError.
NumberedFiles filesOf(const std::filesystem::path& path);

}  // namespace plait
