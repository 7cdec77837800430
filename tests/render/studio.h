// A picture as the renderer makes them, without the renderer: a striped cloth, shaded along its
// waves, before a backdrop. For tests of what is done with pictures.
#pragma once

#include "render/pictures/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plait::test {

struct Studio {
    double shift = 0;                          // pixels, of the cloth to the right
    std::array<double, 3> cloth{200, 50, 31};  // sRGB
    std::array<double, 3> stripe{241, 230, 212};
    double time = 0;  // s, moves the waves
};

inline Picture studio(int width, int height, const Studio& s = {}) {
    const auto colorAt = [&](double x, double y) {
        std::array<double, 3> color;
        for (int k = 0; k < 3; ++k)
            color[k] = std::array{30.0, 45.0, 60.0}[k] + std::array{180.0, 140.0, 95.0}[k] * y * y;
        const double u = (x - s.shift / width - 0.28) / 0.46;
        const double wave = 9 * u - 5 * s.time;
        const double v = (y - 0.15 - 0.04 * u * std::sin(wave)) / 0.62;
        if (u < 0 || u > 1 || v < 0 || v > 1) return color;
        const double light = 0.75 + 0.25 * std::cos(wave) * u;
        const bool striped = std::abs(v - 0.5 - 0.2 * std::sin(14 * u)) < 0.08 ||
                             std::abs(v - 0.5 + 0.2 * std::sin(14 * u)) < 0.08;
        color = striped ? s.stripe : s.cloth;
        for (double& c : color) c *= light;
        return color;
    };
    Picture picture{width, height, {}};
    constexpr int n = 3;  // samples a side
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::array<double, 3> sum{};
            for (int i = 0; i < n * n; ++i) {
                const auto c =
                    colorAt((x + (i % n + 0.5) / n) / width, (y + (i / n + 0.5) / n) / height);
                for (int k = 0; k < 3; ++k) sum[k] += c[k] / (n * n);
            }
            for (const double c : sum)
                picture.rgb.push_back(static_cast<std::uint8_t>(std::clamp(c + 0.5, 0.0, 255.0)));
        }
    return picture;
}

inline Picture mirrored(Picture picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width / 2; ++x)
            std::swap_ranges(&picture.rgb[3 * (y * picture.width + x)],
                             &picture.rgb[3 * (y * picture.width + x)] + 3,
                             &picture.rgb[3 * (y * picture.width + picture.width - 1 - x)]);
    return picture;
}

// Peak signal over noise, dB.
inline double signalToNoise(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow(a.rgb[i] - b.rgb[i], 2);
    return 10 * std::log10(255.0 * 255 * static_cast<double>(a.rgb.size()) / sum);
}

}  // namespace plait::test
