// Pictures as PNG files.
#pragma once

#include "picture.h"

#include <filesystem>

namespace plait {

// 8 bits a channel, deflated by libdeflate, which is several times faster than stb's own. Written
// beside and renamed. Throws std::runtime_error, "file: cause".
void writePng(const std::filesystem::path& path, const Picture& picture);

// Any PNG, its alpha dropped. Throws std::runtime_error, "file: cause".
Picture readPng(const std::filesystem::path& path);

}  // namespace plait
