// A run at one glance.
#pragma once

#include "picture.h"

#include <span>
#include <string>
#include <vector>

namespace plait {

// A frame of the sheet and its time, s.
struct SheetFrame {
    Picture picture;
    double time = 0;
};

// Which `count` of `frames` frames to show: evenly spread, the first and the last among them;
// all where there are fewer.
std::vector<int> sheetFrames(int frames, int count = 12);

// Frames with their times, in rows of four that are `width` pixels wide (of pictures that are
// upright more, of very wide ones fewer), each of the shape of the first, under the title. Throws
// std::invalid_argument without frames.
Picture contactSheet(std::span<const SheetFrame> frames, const std::string& title,
                     int width = 1920);

}  // namespace plait
