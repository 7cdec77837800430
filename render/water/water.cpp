#include "water.h"

#include "render/shaders/shadow.h"
#include "render/shaders/water.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

glm::vec3 toGlm(const Vec<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

constexpr float farthest = 1000;  // m, that depths are tested to
constexpr std::size_t mostPanes = 6;

}  // namespace

// Balls of 0.75 spacings leave no holes where water lies still.
Water::Water(const Look& look, const std::string& prologue, int width, int height)
    : range_(look.object),
      spacing_(static_cast<float>(look.radius) / 0.5f),
      radius_(0.75f * spacing_),
      color_(static_cast<float>(look.color[0]), static_cast<float>(look.color[1]),
             static_cast<float>(look.color[2])),
      beyond_(static_cast<float>(look.wall.thickness)),
      height_(height),
      depth_(dropVertexShader, std::string(dropShader) + dropDepthShader),
      thickness_(dropVertexShader, std::string(dropShader) + dropThicknessShader),
      shadow_(dropShadowVertexShader, dropShadowShader),
      smooth_(waterVertexShader, narrowShader),
      blur_(blurVertexShader, blurShader),
      surface_(waterVertexShader, prologue + waterShader),
      depths_(makeSceneTarget(width, height, GL_R32F)),
      across_(makeTarget(width, height, GL_R32F)),
      smoothed_(makeTarget(width, height, GL_R32F)),
      thicknesses_(makeTarget(std::max(width / 2, 1), std::max(height / 2, 1), GL_R32F)),
      blurred_(makeTarget(thicknesses_.width, thicknesses_.height, GL_R32F)),
      array_(makeVertexArray()),
      buffer_(makeBuffer()) {
    if (look.panes.size() > mostPanes) throw std::invalid_argument("look: has more than six panes");
    // By which a metre of it swallows light, by channel: all but what it looks like.
    swallow_ = (1.0f - color_ / std::max({color_.r, color_.g, color_.b, 1e-6f})) /
               static_cast<float>(look.wall.clear);
    for (const GlassPane& pane : look.panes)
        panes_.emplace_back(toGlm(pane.normal), static_cast<float>(dot(pane.normal, pane.point)));
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
}

void Water::update(std::span<const Vec<double>> positions, std::span<const double> ages) {
    points_.clear();
    for (int i = range_.first; i < range_.last; ++i)
        if (ages.empty() || ages[i] >= 0) points_.push_back(toGlm(positions[i]));
    middle_ = glm::vec3(0);
    for (const glm::vec3& p : points_) middle_ += p / static_cast<float>(points_.size());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points_.size() * sizeof(glm::vec3)),
                 points_.data(), GL_STREAM_DRAW);
}

float Water::pixels(const WaterLens& lens) const {
    return 0.5f * static_cast<float>(height_) / std::tan(0.5f * lens.fieldOfView);
}

void Water::drawShadow(const glm::mat4& matrix, float perMetre) const {
    shadow_.use();
    shadow_.set("matrix", matrix);
    shadow_.set("pixels", 2 * radius_ * perMetre);
    shadow_.set("cover", 0.4f);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points_.size()));
    glDisable(GL_PROGRAM_POINT_SIZE);
}

void Water::setDrops(const Program& program, const WaterLens& lens, const Target& target) const {
    const float scale = static_cast<float>(target.height) / static_cast<float>(height_);
    program.use();
    program.set("camera", lens.camera);
    program.set("unproject", glm::inverse(lens.camera));
    program.set("size", glm::vec2(target.width, target.height));
    program.set("eye", lens.eye);
    program.set("forward", lens.forward);
    program.set("radius", radius_);
    program.set("pixels", scale * pixels(lens));
    program.set("farthest", farthest);
    program.set("paneCount", static_cast<int>(panes_.size()));
    for (std::size_t i = 0; i < panes_.size(); ++i)
        program.set(("panes[" + std::to_string(i) + "]").c_str(), panes_[i]);
}

void Water::find(const WaterLens& lens, const VertexArray& empty) const {
    const auto count = static_cast<GLsizei>(points_.size());
    glEnable(GL_PROGRAM_POINT_SIZE);
    glClearColor(0, 0, 0, 0);
    depths_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    setDrops(depth_, lens, depths_);
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, count);
    glDisable(GL_DEPTH_TEST);

    thicknesses_.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    setDrops(thickness_, lens, thicknesses_);
    const float ball = 4.18879f * radius_ * radius_ * radius_;
    thickness_.set("share", spacing_ * spacing_ * spacing_ / ball);
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, count);
    glDisable(GL_BLEND);
    glDisable(GL_PROGRAM_POINT_SIZE);
    blur(lens, empty);

    smooth_.use();
    smooth_.set("pixels", pixels(lens));
    smooth_.set("range", 1.5f * spacing_);
    const glm::vec2 pixel = 1.0f / glm::vec2(depths_.width, depths_.height);
    smooth_.set("reach", 0.8f * spacing_);
    smooth(depths_, across_, {pixel.x, 0}, empty);
    smooth(across_, smoothed_, {0, pixel.y}, empty);
    smooth(smoothed_, across_, {pixel.x, 0}, empty);
    smooth(across_, smoothed_, {0, pixel.y}, empty);
}

// Along a ray balls are as many as chance has them.
void Water::blur(const WaterLens& lens, const VertexArray& empty) const {
    const float away = std::max(glm::dot(middle_ - lens.eye, lens.forward), spacing_);
    const glm::vec2 pixel = 1.0f / glm::vec2(thicknesses_.width, thicknesses_.height);
    const float step = std::min(0.25f * spacing_ * pixels(lens) / away, 3.0f);
    blur_.use();
    const auto along = [&](const Target& from, const Target& to, const glm::vec2& by) {
        to.bind();
        blur_.set("source", 0, from.texture);
        blur_.set("step", by);
        drawScreen(empty);
    };
    along(thicknesses_, blurred_, {step * pixel.x, 0});
    along(blurred_, thicknesses_, {0, step * pixel.y});
}

void Water::smooth(const Target& from, const Target& to, const glm::vec2& step,
                   const VertexArray& empty) const {
    to.bind();
    smooth_.set("source", 0, from.texture);
    smooth_.set("step", step);
    drawScreen(empty);
}

const Program& Water::use(const WaterLens& lens, const Texture& behind) const {
    surface_.use();
    surface_.set("camera", lens.camera);
    surface_.set("unproject", glm::inverse(lens.camera));
    surface_.set("forward", lens.forward);
    surface_.set("swallow", swallow_);
    surface_.set("beyond", beyond_);
    surface_.set("color", color_);
    surface_.set("spacing", spacing_);
    surface_.set("depths", 12, smoothed_.texture);
    surface_.set("thicknesses", 13, thicknesses_.texture);
    surface_.set("behind", 14, behind);
    return surface_;
}

}  // namespace plait
