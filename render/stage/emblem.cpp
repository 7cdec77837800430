#include "emblem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plait {
namespace {

constexpr float turn = 2 * std::numbers::pi_v<float>;
constexpr float amplitude = 0.2f, halfWidth = 0.057f, gap = 0.013f, idealPeriod = 0.8f;

// The strand y = amplitude sin a, a = turn x / period: the distance of a point and how far the
// nearest place of the strand lies above the others, sin 2a (which makes it pass over and under).
struct Near {
    float distance, depth;
};

Near nearest(float x, float y, float phase, float period) {
    const float k = turn / period;
    float s = x;
    // Newton on the foot of the perpendicular, kept within the flank it starts on.
    for (int i = 0; i < 4; ++i) {
        const float a = k * s + phase, f = amplitude * std::sin(a), d = amplitude * k * std::cos(a);
        const float slope = s - x + (f - y) * d;
        s -= std::clamp(slope / (1 + d * d + std::max(0.0f, -k * k * f * (f - y))), -0.03f, 0.03f);
    }
    const float a = k * s + phase;
    return {std::hypot(s - x, amplitude * std::sin(a) - y), std::sin(2 * a)};
}

unsigned short encode(float distance) {
    const float s = std::clamp(0.5f + 0.5f * distance / Emblem::reach, 0.0f, 1.0f);
    return static_cast<unsigned short>(std::lround(65535 * s));
}

}  // namespace

Emblem makeEmblem(float aspect) {
    const float turns = std::max(1.0f, std::round(aspect / idealPeriod));
    Emblem emblem{.period = aspect / turns};
    for (int row = 0; row < emblem.height; ++row)
        for (int column = 0; column < emblem.width; ++column) {
            const float x = emblem.period * (static_cast<float>(column) + 0.5f) /
                            static_cast<float>(emblem.width);
            const float y =
                (static_cast<float>(row) + 0.5f) / static_cast<float>(emblem.height) - 0.5f;
            std::array<Near, 3> strands;
            for (int i = 0; i < 3; ++i)
                strands[i] = nearest(x, y, turn * static_cast<float>(i) / 3, emblem.period);
            std::array<float, 3> visible;
            for (int i = 0; i < 3; ++i) {
                visible[i] = strands[i].distance - halfWidth;
                for (const Near& other : strands)
                    if (other.depth > strands[i].depth)
                        visible[i] = std::max(visible[i], halfWidth + gap - other.distance);
            }
            emblem.texels.push_back(encode(std::min(visible[0], visible[2])));
            emblem.texels.push_back(encode(visible[1]));
        }
    return emblem;
}

}  // namespace plait
