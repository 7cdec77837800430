#include "legend.h"

#include "render/charts/axis.h"
#include "text.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

Color encode(const glm::vec3& linear) {
    const auto channel = [](float v) {
        const double s =
            v <= 0.0031308f ? 12.92 * v : 1.055 * std::pow(static_cast<double>(v), 1 / 2.4) - 0.055;
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(s, 0.0, 1.0)));
    };
    return {channel(linear.x), channel(linear.y), channel(linear.z)};
}

}  // namespace

void drawLegend(Picture& picture, const Legend& legend) {
    const double unit = unitOf(picture);
    const auto px = [&](double v) { return static_cast<int>(std::lround(v * unit)); };
    const int width = px(260), bar = px(12), pad = px(18);
    const int right = picture.width - px(40) - pad, x = right - width, top = px(40);
    const TextStyle name{Weight::semibold, 18 * unit, ivory};
    const TextStyle small{Weight::regular, 15 * unit, steel, 1, true};
    paintRectangle(picture, x - pad, top, width + 2 * pad, px(90), ink, 0.72);
    const int line = top + px(30), y = line + px(13);
    drawText(picture, x, line, legend.name, name);
    drawText(picture, right - textWidth(legend.unit, small), line, legend.unit, small);

    // Round dark colours, which the panel would swallow.
    const auto frame = [&](int from, int to) {
        paintRectangle(picture, from - 1, y - 1, to - from + 2, bar + 2, steel, 0.5);
    };
    const auto label = [&](double center, const std::string& text) {
        drawText(picture, center - textWidth(text, small) / 2, y + bar + px(20), text, small);
    };
    if (legend.palette == Palette::categories) {
        const int n = static_cast<int>(paletteColors(legend.palette).size());
        for (int i = 0; i < n; ++i) {
            const int from = x + i * width / n, to = x + (i + 1) * width / n - px(4);
            frame(from, to);
            paintRectangle(picture, from, y, to - from, bar,
                           encode(paletteColors(legend.palette)[i]));
            label((from + to) / 2.0, std::to_string(i));
        }
        return;
    }
    frame(x, right);
    const Overlay overlay{.values = {}, .low = 0, .high = 1, .palette = legend.palette};
    for (int column = 0; column < width; ++column) {
        const float s = (static_cast<float>(column) + 0.5f) / static_cast<float>(width);
        paintRectangle(picture, x + column, y, 1, bar, encode(overlayColor(overlay, s)));
    }
    const double low = legend.low, high = legend.high;
    for (const auto& [value, text] : axisTicks({low, high}, false, 4)) {
        const double center = high > low ? x + width * (value - low) / (high - low) : x;
        const int tick = std::min(static_cast<int>(center), right - 1);
        paintRectangle(picture, tick, y + bar, std::max(1, px(1)), px(4), steel);
        label(center, text);
    }
}

}  // namespace plait
