#include "grade.h"

#include "render/shaders/grade.h"
#include "render/shaders/shadow.h"

#include <algorithm>

namespace plait {
namespace {

constexpr float exposure = 1;

}  // namespace

Grade::Grade(int width, int height)
    : bright_(blurVertexShader, brightShader),
      bloom_(blurVertexShader, bloomShader),
      grade_(blurVertexShader, gradeShader),
      small_(makeTarget(std::max(width / 4, 1), std::max(height / 4, 1), GL_RGBA16F)),
      across_(makeTarget(small_.width, small_.height, GL_RGBA16F)),
      result_(makeTarget(width, height, GL_RGBA8)),
      pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

Picture Grade::apply(const Texture& scene, float vignette, const VertexArray& empty) {
    const glm::vec2 size(result_.width, result_.height),
        texel = 1.0f / glm::vec2(small_.width, small_.height);
    glDisable(GL_DEPTH_TEST);
    small_.bind();
    bright_.use();
    bright_.set("source", 0, scene);
    bright_.set("texel", 1.0f / size);
    drawScreen(empty);

    // Sigma is width / 160: two taps, each 1 / 320 of the width apart.
    const float apart = std::max(1.0f, static_cast<float>(small_.width) / 320.0f);
    bloom_.use();
    across_.bind();
    bloom_.set("source", 0, small_.texture);
    bloom_.set("step", glm::vec2(apart * texel.x, 0));
    drawScreen(empty);
    small_.bind();
    bloom_.set("source", 0, across_.texture);
    bloom_.set("step", glm::vec2(0, apart * texel.y));
    drawScreen(empty);

    result_.bind();
    grade_.use();
    grade_.set("scene", 0, scene);
    grade_.set("bloom", 1, small_.texture);
    grade_.set("size", size);
    grade_.set("exposure", exposure);
    grade_.set("vignette", vignette);
    drawScreen(empty);

    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, result_.width, result_.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
    Picture picture{result_.width, result_.height,
                    std::vector<std::uint8_t>(pixels_.size() / 4 * 3)};
    for (std::size_t i = 0; i < pixels_.size() / 4; ++i)
        std::copy_n(&pixels_[4 * i], 3, &picture.rgb[3 * i]);
    return picture;
}

}  // namespace plait
