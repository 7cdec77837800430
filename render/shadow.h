// What a distant light sees: depths to compare with, and their moments, blurred twice: narrow for
// what touches the caster, wide for what lies far behind it.
#pragma once

#include "gpu.h"

#include <functional>

namespace plait {

struct ShadowOptions {
    int size = 512;     // texels along a side
    float spacing = 0;  // of the narrow blur's taps, texels: its sigma is twice that; 0: no blur
    float wideSpacing = 0;  // of the wide one's
};

class ShadowMap {
public:
    ShadowMap() = default;
    explicit ShadowMap(const ShadowOptions& options);

    // `draw` draws the casters with the matrix it is given, world to clip. `towards` the light is
    // of length 1. Casters outside the sphere are not seen.
    void render(const glm::vec3& towards, const glm::vec3& center, float radius,
                const std::function<void(const glm::mat4&)>& draw, const VertexArray& empty);

    const glm::mat4& matrix() const { return matrix_; }      // world to map and depth in 0 .. 1
    float texel() const { return texel_; }                   // m
    const Texture& depth() const { return depth_.texture; }  // without blur: a sampler compares
    const Texture& narrow() const { return narrow_.texture; }
    const Texture& wide() const { return wide_.texture; }

private:
    void blur(const Texture& from, bool fromDepth, const Target& to, const glm::vec2& step,
              const VertexArray& empty) const;

    ShadowOptions options_;
    Program blur_;
    Target depth_, across_, narrow_, wide_;
    glm::mat4 matrix_{1};
    float texel_ = 1;
};

}  // namespace plait
