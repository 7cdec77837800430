// Pictures and videos, read by FFmpeg.
#pragma once

#include "render/pictures/picture.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plait::test {

struct Video {
    int width = 0, height = 0;
    int rateFrames = 0, rateSeconds = 0;
    std::string codec, pixelFormat, colorSpace, colorRange;
    std::vector<Picture> frames;
    std::vector<double> times;  // s
};

Video readVideo(const std::filesystem::path& path);

// The names and sizes of the boxes of an MP4, in their order.
struct Box {
    std::string name;
    std::uint64_t size;
};
std::vector<Box> boxes(const std::vector<std::uint8_t>& file);

std::vector<std::uint8_t> readBytes(const std::filesystem::path& path);

}  // namespace plait::test
