#include "weave.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace plait {
namespace {

constexpr int size = 256, threads = 32;

// In 0 .. 1, from integers alone.
float noise(std::uint32_t a, std::uint32_t b) {
    std::uint32_t h = a * 0x9E3779B1u + b * 0x85EBCA77u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

std::uint8_t byte(float v) { return static_cast<std::uint8_t>(std::lround(255 * (0.5f + v))); }

}  // namespace

Texture makeWeave() {
    std::vector<std::uint8_t> texels;
    const float perTexel = 2 * std::numbers::pi_v<float> * threads / size;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const int warp = column * threads / size, weft = row * threads / size;
            // Plain weave: warp and weft lie on top in turn, each thread a little its own.
            const bool over = (warp + weft) % 2 == 0;
            const float tilt = 0.16f * std::sin(perTexel * static_cast<float>(over ? column : row));
            const float slub = over ? noise(static_cast<std::uint32_t>(warp), 1)
                                    : noise(static_cast<std::uint32_t>(weft), 2);
            texels.push_back(byte(over ? tilt : 0));
            texels.push_back(byte(over ? 0 : tilt));
            texels.push_back(byte(0.2f * (slub - 0.5f)));
        }
    Texture texture = makeTexture(size, size, GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, texels.data(),
                                  {.wrap = GL_REPEAT});
    glGenerateMipmap(GL_TEXTURE_2D);
    // Even from where a thread is half a texel: what is left of the noise would show as a grid.
    constexpr int last = 4;
    const std::vector<std::uint8_t> even(3 * (size >> last) * (size >> last), byte(0));
    glTexImage2D(GL_TEXTURE_2D, last, GL_RGB8, size >> last, size >> last, 0, GL_RGB,
                 GL_UNSIGNED_BYTE, even.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return texture;
}

}  // namespace plait
