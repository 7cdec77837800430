#include "overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plait {
namespace {

constexpr std::array heat{glm::vec3(0.011f, 0.018f, 0.033f), glm::vec3(0.098f, 0.05f, 0.11f),
                          glm::vec3(0.578f, 0.032f, 0.014f), glm::vec3(0.84f, 0.32f, 0.06f),
                          glm::vec3(0.88f, 0.791f, 0.658f)};
constexpr std::array diverging{glm::vec3(0.013f, 0.195f, 0.216f), glm::vec3(0.3f, 0.5f, 0.48f),
                               glm::vec3(0.88f, 0.791f, 0.658f), glm::vec3(0.78f, 0.3f, 0.2f),
                               glm::vec3(0.578f, 0.032f, 0.014f)};
// The chart colours of the look book.
constexpr std::array categories{
    glm::vec3(0.008f, 0.014f, 0.025f), glm::vec3(0.578f, 0.032f, 0.014f),
    glm::vec3(0.007f, 0.198f, 0.235f), glm::vec3(0.694f, 0.371f, 0.053f),
    glm::vec3(0.238f, 0.456f, 0.716f), glm::vec3(0.366f, 0.323f, 0.275f)};

}  // namespace

std::span<const glm::vec3> paletteColors(Palette palette) {
    if (palette == Palette::heat) return heat;
    if (palette == Palette::diverging) return diverging;
    return categories;
}

glm::vec3 overlayColor(const Overlay& overlay, float value) {
    const auto colors = paletteColors(overlay.palette);
    const int n = static_cast<int>(colors.size());
    if (overlay.palette == Palette::categories) {
        const int i = static_cast<int>(std::lround(value)) % n;
        return colors[i < 0 ? i + n : i];
    }
    const float last = static_cast<float>(n - 1);
    const float s =
        std::clamp(last * (value - overlay.low) / (overlay.high - overlay.low), 0.0f, last);
    const int i = std::min(static_cast<int>(s), n - 2);
    return glm::mix(colors[i], colors[i + 1], s - static_cast<float>(i));
}

}  // namespace plait
