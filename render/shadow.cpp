#include "shadow.h"

#include "shaders/shadow.h"

#include <glm/gtc/matrix_transform.hpp>

namespace plait {

ShadowMap::ShadowMap(const ShadowOptions& options)
    : options_(options), depth_(makeDepthTarget(options.size)) {
    if (options.spacing == 0) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        return;
    }
    blur_ = Program(blurVertexShader, blurShader);
    across_ = makeTarget(options.size, options.size, GL_RG32F);
    narrow_ = makeTarget(options.size, options.size, GL_RG32F);
    wide_ = makeTarget(options.size / 2, options.size / 2, GL_RG32F);
}

void ShadowMap::render(const glm::vec3& towards, const glm::vec3& center, float radius,
                       const std::function<void(const glm::mat4&)>& draw,
                       const VertexArray& empty) {
    const glm::vec3 up = std::abs(towards.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    const float half = 1.25f * radius;  // a margin of light around the casters, wider than a blur
    const glm::mat4 toClip = glm::ortho(-half, half, -half, half, 0.0f, 2 * half) *
                             glm::lookAt(center + half * towards, center, up);
    matrix_ = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f)) * toClip;

    depth_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw(toClip);

    texel_ = 2 * half / static_cast<float>(options_.size);
    if (options_.spacing == 0) return;
    glDisable(GL_DEPTH_TEST);
    blur_.use();
    const float texel = 1 / static_cast<float>(options_.size);
    const float narrow = options_.spacing * texel, far = options_.wideSpacing * texel;
    blur(depth_.texture, true, across_, {narrow, 0}, empty);
    blur(across_.texture, false, narrow_, {0, narrow}, empty);
    blur(narrow_.texture, false, across_, {far, 0}, empty);
    blur(across_.texture, false, wide_, {0, far}, empty);
}

void ShadowMap::blur(const Texture& from, bool fromDepth, const Target& to, const glm::vec2& step,
                     const VertexArray& empty) const {
    to.bind();
    blur_.set("source", 0, from);
    blur_.set("fromDepth", fromDepth ? 1 : 0);
    blur_.set("step", step);
    drawScreen(empty);
}

}  // namespace plait
