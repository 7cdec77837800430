#include "floor_mirror.h"

#include "render/shaders/shadow.h"

#include <algorithm>

namespace plait {

FloorMirror::FloorMirror(int width, int height)
    : blur_(blurVertexShader, blurShader),
      image_(makeSceneTarget(width / 2, height / 2)),
      across_(makeTarget(width / 2, height / 2, GL_RGBA16F)),
      near_(makeTarget(width / 2, height / 2, GL_RGBA16F)),
      far_(makeTarget(std::max(width / 8, 1), std::max(height / 8, 1), GL_RGBA16F)) {}

void FloorMirror::begin() {
    image_.bind();
    glDepthMask(GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFrontFace(GL_CW);
    glEnable(GL_CLIP_DISTANCE0);
}

// Rough floors draw images out towards the eye: the blur is wider upright.
void FloorMirror::end(const VertexArray& empty) {
    glDisable(GL_CLIP_DISTANCE0);
    glFrontFace(GL_CCW);
    glDisable(GL_DEPTH_TEST);
    blur_.use();
    const glm::vec2 pixel = 1.0f / glm::vec2(image_.width, image_.height);
    const float unit = static_cast<float>(image_.height) / 360;
    blur(image_, across_, {0.5f * unit * pixel.x, 0}, empty);
    blur(across_, near_, {0, 0.8f * unit * pixel.y}, empty);
    blur(near_, across_, {1.5f * unit * pixel.x, 0}, empty);
    blur(across_, far_, {0, 3.5f * unit * pixel.y}, empty);
}

void FloorMirror::blur(const Target& from, const Target& to, const glm::vec2& step,
                       const VertexArray& empty) const {
    to.bind();
    blur_.set("source", 0, from.texture);
    blur_.set("step", step);
    drawScreen(empty);
}

}  // namespace plait
