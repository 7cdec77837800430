// Pixels as they are written to files and video.
#pragma once

#include <cstdint>
#include <vector>

namespace plait {

struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // sRGB, three bytes a pixel, top row first

    bool operator==(const Picture&) const = default;
};

}  // namespace plait
