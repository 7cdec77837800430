// What a distant light sees: depths to compare with, and what they say of each texel, blurred
// twice: narrow for what touches the caster, wide for what lies far behind it.
#pragma once

#include "render/gl/gpu.h"

#include <functional>

namespace plait {

class ShadowMap {
public:
    ShadowMap() = default;
    explicit ShadowMap(int size) : size_(size), depth_(makeDepthTarget(size)) {}  // texels a side

    // `draw` draws the casters with the matrix it is given, world to clip. `towards` the light is
    // of length 1. What stands between the light and the sphere casts as well.
    void render(const glm::vec3& towards, const glm::vec3& center, float radius,
                const std::function<void(const glm::mat4&)>& draw);
    // Until it is rendered again a sampler compares, and blends what it finds.
    void compare() const;

    const glm::mat4& matrix() const { return matrix_; }  // world to map and depth in 0 .. 1
    float texel() const { return texel_; }               // m
    const Texture& depth() const { return depth_.texture; }

private:
    int size_ = 0;
    Target depth_;
    glm::mat4 matrix_{1};
    float texel_ = 1;
};

struct ShadowBlurOptions {
    const char* shader;    // from four depths to what is blurred
    GLenum format;         // of that
    int size;              // texels a side, half as many as the map has
    float spacing;         // of the narrow blur's taps, texels: its sigma is twice that
    float wideSpacing;     // of the wide one's
    float farSpacing = 0;  // of the widest one's, in texels of twice the size; 0: there is none
};

class ShadowBlur {
public:
    ShadowBlur() = default;
    explicit ShadowBlur(const ShadowBlurOptions& options);

    // The map must not compare yet. `height` (m) is that of the ground.
    void render(const ShadowMap& map, float height, const VertexArray& empty) const;

    const Texture& narrow() const { return narrow_.texture; }
    const Texture& wide() const { return wide_.texture; }
    const Texture& far() const { return far_.texture; }

private:
    void blur(const Texture& from, const Target& to, const glm::vec2& step,
              const VertexArray& empty) const;

    float spacing_ = 0, wideSpacing_ = 0, farSpacing_ = 0;
    Program first_, blur_;
    Target across_, narrow_, wide_, far_;
};

}  // namespace plait
