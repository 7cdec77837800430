// Pictures as PNG files.
#pragma once

#include "picture.h"

#include <filesystem>

namespace plait {

// 8 bits a channel, deflated by libdeflate, which is several times faster than stb's own. All of
// these throw FileError (whole_file.h).
void writePng(const std::filesystem::path& path, const Picture& picture);

// Any PNG, its alpha dropped.
Picture readPng(const std::filesystem::path& path);

// Any PNG, with what Picture has no room for.
struct PngFile {
    Picture picture;
    Picture alpha;       // as greys; white, opaque, where the file has none
    int channels, bits;  // of the file: 1 to 4, of 8 or 16 bits; palettes count as what they hold
};
PngFile readPngFile(const std::filesystem::path& path);

}  // namespace plait
