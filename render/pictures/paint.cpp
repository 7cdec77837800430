#include "paint.h"

extern "C" {
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {

double unitOf(const Picture& picture) { return std::min(picture.width, picture.height) / 720.0; }

Picture filled(int width, int height, Color color) {
    Picture picture{width, height, {}};
    picture.rgb.resize(std::size_t{3} * width * height);
    paintRectangle(picture, 0, 0, width, height, color);
    return picture;
}

void paint(Picture& picture, int x, int y, Color color, double alpha) {
    std::uint8_t* rgb = &picture.rgb[3 * (y * picture.width + x)];
    const std::uint8_t over[] = {color.r, color.g, color.b};
    for (int k = 0; k < 3; ++k)
        rgb[k] = static_cast<std::uint8_t>(std::floor(rgb[k] + alpha * (over[k] - rgb[k]) + 0.5));
}

void paintRectangle(Picture& picture, int x, int y, int width, int height, Color color,
                    double alpha) {
    for (int row = std::max(y, 0); row < std::min(y + height, picture.height); ++row)
        for (int column = std::max(x, 0); column < std::min(x + width, picture.width); ++column)
            paint(picture, column, row, color, alpha);
}

void paintPicture(Picture& picture, int x, int y, const Picture& part) {
    const int first = std::max(0, -x), last = std::min(part.width, picture.width - x);
    for (int row = std::max(0, -y); row < std::min(part.height, picture.height - y); ++row)
        if (first < last)
            std::copy(&part.rgb[3 * (row * part.width + first)],
                      &part.rgb[3 * (row * part.width + last - 1)] + 3,
                      &picture.rgb[3 * ((y + row) * picture.width + x + first)]);
}

Picture scaled(const Picture& picture, int width, int height) {
    if (picture.rgb.empty() || width < 1 || height < 1)
        throw std::invalid_argument("a picture cannot be scaled from or to nothing");
    Picture result{width, height, {}};
    SwsContext* scaler = sws_getContext(
        picture.width, picture.height, AV_PIX_FMT_RGB24, width, height, AV_PIX_FMT_RGB24,
        SWS_LANCZOS | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT | SWS_ACCURATE_RND | SWS_BITEXACT,
        nullptr, nullptr, nullptr);
    if (!scaler) throw std::runtime_error("a picture cannot be scaled: out of memory");
    result.rgb.resize(std::size_t{3} * width * height);
    const std::uint8_t* source[] = {picture.rgb.data()};
    std::uint8_t* target[] = {result.rgb.data()};
    const int from[] = {3 * picture.width}, to[] = {3 * width};
    sws_scale(scaler, source, from, 0, picture.height, target, to);
    sws_freeContext(scaler);
    return result;
}

}  // namespace plait
