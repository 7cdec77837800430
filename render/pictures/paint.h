// The look book's colours, and areas of them in a picture.
#pragma once

#include "picture.h"

#include <cstdint>

namespace plait {

struct Color {
    std::uint8_t r, g, b;  // sRGB
};

inline constexpr Color ink{0x16, 0x20, 0x2c}, ivory{0xf1, 0xe6, 0xd4}, vermilion{0xc8, 0x32, 0x1f},
    steel{0xa9, 0xb2, 0xba};

// How many pixels one of the look book's is, whose pictures are 720 high, or upright 720 wide.
double unitOf(const Picture& picture);

Picture filled(int width, int height, Color color);

// Covers a pixel of the picture by the fraction `alpha`.
void paint(Picture& picture, int x, int y, Color color, double alpha);

// Everything below may lie partly outside of the picture.
void paintRectangle(Picture& picture, int x, int y, int width, int height, Color color,
                    double alpha = 1);
void paintPicture(Picture& picture, int x, int y, const Picture& part);

// The picture in another size, smoothly. Throws std::invalid_argument for sizes below 1.
Picture scaled(const Picture& picture, int width, int height);

}  // namespace plait
