#include "shadow.h"

#include "render/shaders/shadow.h"

#include <glm/gtc/matrix_transform.hpp>

namespace plait {

void ShadowMap::render(const glm::vec3& towards, const glm::vec3& center, float radius,
                       const std::function<void(const glm::mat4&)>& draw) {
    const glm::vec3 up = std::abs(towards.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    const float half = 1.25f * radius;  // a margin of light around the casters, wider than a blur
    const glm::mat4 toClip = glm::ortho(-half, half, -half, half, 0.0f, 2 * half) *
                             glm::lookAt(center + half * towards, center, up);
    matrix_ = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f)) * toClip;
    texel_ = 2 * half / static_cast<float>(size_);

    depth_.bind();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_DEPTH_CLAMP);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw(toClip);
    glDisable(GL_DEPTH_CLAMP);

    glBindTexture(GL_TEXTURE_2D, depth_.texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void ShadowMap::compare() const {
    glBindTexture(GL_TEXTURE_2D, depth_.texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

ShadowBlur::ShadowBlur(const ShadowBlurOptions& options)
    : spacing_(options.spacing),
      wideSpacing_(options.wideSpacing),
      farSpacing_(options.farSpacing),
      first_(blurVertexShader, options.shader),
      blur_(blurVertexShader, blurShader),
      across_(makeTarget(options.size, options.size, options.format)),
      narrow_(makeTarget(options.size, options.size, options.format)),
      wide_(makeTarget(options.size / 2, options.size / 2, options.format)) {
    if (farSpacing_ > 0) far_ = makeTarget(options.size / 4, options.size / 4, options.format);
}

void ShadowBlur::render(const ShadowMap& map, float height, const VertexArray& empty) const {
    glDisable(GL_DEPTH_TEST);
    narrow_.bind();
    first_.use();
    first_.set("source", 0, map.depth());
    first_.set("toWorld", glm::inverse(map.matrix()));
    first_.set("height", height);
    drawScreen(empty);
    blur_.use();
    const float texel = 1 / static_cast<float>(narrow_.width);
    const float near = spacing_ * texel, far = wideSpacing_ * texel;
    blur(narrow_.texture, across_, {near, 0}, empty);
    blur(across_.texture, narrow_, {0, near}, empty);
    blur(narrow_.texture, across_, {far, 0}, empty);
    blur(across_.texture, wide_, {0, far}, empty);
    if (farSpacing_ == 0) return;
    blur(wide_.texture, across_, {2 * farSpacing_ * texel, 0}, empty);
    blur(across_.texture, far_, {0, 2 * farSpacing_ * texel}, empty);
}

void ShadowBlur::blur(const Texture& from, const Target& to, const glm::vec2& step,
                      const VertexArray& empty) const {
    to.bind();
    blur_.set("source", 0, from);
    blur_.set("step", step);
    drawScreen(empty);
}

}  // namespace plait
