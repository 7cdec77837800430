#include "render/shaders/backdrop.h"
#include "render/shaders/shadow.h"
#include "renderer.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// Sizes of the subject, from its middle to where the ground ends.
constexpr float groundReach = 3.5f;

glm::vec3 toGlm(const Vec<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

void Renderer::prepareGround() {
    keyCover_ =
        ShadowBlur({coverShader, GL_RG16F, 256, 0.67f, 1.73f, view_.stage.spot > 0 ? 3.0f : 0.0f});
    skyCover_ =
        ShadowBlur({coverShader, GL_RG16F, 128, 0.75f, 2.5f, view_.stage.spot > 0 ? 3.0f : 0.0f});
    std::string defines = "#define GROUND\n";
    if (view_.stage.mirror > 0) {
        defines += "#define MIRROR\n";
        mirror_.emplace(options_.width, options_.height);
    }
    ground_ = Program(screenVertexShader, prologue_ + defines + backdropShader);
}

// A sphere around all that is seen or casts its shadow where it is seen, in steps, so that the
// shadow's texels keep still.
void Renderer::findSubject(const Shot& shot) {
    const float farthest = 2 * glm::length(shot.pose.target - shot.pose.eye);
    const auto seen = [&](const glm::vec3& p) {
        const glm::vec4 c = shot.camera * glm::vec4(p, 1);
        const float side = 1.1f * c.w;
        return c.w > 0 && c.w < farthest && std::abs(c.x) < side && std::abs(c.y) < side;
    };
    const auto shadow = [&](const glm::vec3& p) {
        return p - (p.y - static_cast<float>(view_.groundHeight)) / key_.y * key_;
    };
    glm::vec3 low(1e30f), high(-1e30f);
    const auto add = [&](const glm::vec3& p) {
        if (!seen(p) && !(view_.ground && seen(shadow(p)))) return;
        low = glm::min(low, p);
        high = glm::max(high, p);
    };
    for (const Skin& skin : skins_)
        for (const MeshVertex& v : skin.vertices()) add(v.position);
    if (water_)
        for (const glm::vec3& p : water_->points()) add(p);
    if (low.x > high.x) low = high = glm::vec3(0);
    const float radius = std::max(0.5f * glm::length(high - low), 1e-3f);
    radius_ = std::exp2(std::ceil(4 * std::log2(radius)) / 4);
    const float step = radius_ / 16;
    subject_ = glm::round(0.5f * (low + high) / step) * step;
    radius_ += step;
}

void Renderer::renderShadows() {
    // A map is as wide as the subject, and as many texels as these.
    const auto casters = [&](float texels) {
        return [this, texels](const glm::mat4& matrix) {
            drawCasters(matrix, texels / (2 * radius_));
        };
    };
    const auto height = static_cast<float>(view_.groundHeight);
    keyShadow_.render(key_, subject_, radius_, casters(512));
    skyShadow_.render({0, 1, 0}, subject_, radius_, casters(256));
    if (view_.ground) {
        keyCover_.render(keyShadow_, height, empty_);
        skyCover_.render(skyShadow_, height, empty_);
    }
    skyMoments_.render(skyShadow_, height, empty_);
    keyShadow_.compare();
}

void Renderer::drawCasters(const glm::mat4& matrix, float perMetre) {
    depth_.use();
    depth_.set("matrix", matrix);
    const auto draw = [](const GpuMesh& mesh) {
        glBindVertexArray(mesh.array);
        glDrawElements(GL_TRIANGLES, mesh.corners, GL_UNSIGNED_INT, nullptr);
    };
    for (std::size_t i = 0; i < skins_.size(); ++i)
        if (!isTranslucent(skins_[i]) && finishOf(skins_[i].material()).family != Family::spark)
            draw(meshes_[i]);
    if (water_) water_->drawShadow(matrix, perMetre);
    if (!netDepth_) return;
    netDepth_.use();
    netDepth_.set("matrix", matrix);
    for (std::size_t i = 0; i < skins_.size(); ++i) {
        if (!isTranslucent(skins_[i])) continue;
        netDepth_.set("cover", finishOf(skins_[i].material()).numbers.x);
        netDepth_.set("layer", static_cast<int>(i));
        draw(meshes_[i]);
    }
}

// What stands on the floor, seen from the eye's own mirror image.
void Renderer::drawMirror(const Shot& shot) {
    if (!mirror_) return;
    FloorMirror& mirror = *mirror_;
    const auto height = static_cast<float>(view_.groundHeight);
    Shot image = shot;
    image.lowest = height;
    image.pose.eye.y = 2 * height - shot.pose.eye.y;
    image.pose.target.y = 2 * height - shot.pose.target.y;
    glm::mat4 upsideDown(1);
    upsideDown[1][1] = -1;
    upsideDown[3][1] = 2 * height;
    image.camera = shot.camera * upsideDown;
    mirror.begin();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, options_.width, groundRows(shot) / 2 + 1);
    drawSkins(image);
    drawFaint(image);
    drawGlass(image, -1);
    drawVeils(image);
    glDisable(GL_SCISSOR_TEST);
    mirror.end(empty_);
}

void Renderer::drawBackdrop(const Shot& shot) {
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_SCISSOR_TEST);
    const int rows = view_.ground ? groundRows(shot) : 0;
    if (rows > 0) drawRows(ground_, 0, rows, shot);
    if (rows < options_.height) drawRows(backdrop_, rows, options_.height, shot);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
}

glm::vec3 Renderer::groundCenter() const {
    return toGlm(view_.glowCenter) + static_cast<float>(view_.follow.ground) * way_;
}

// Rows from the bottom below which all of the ground lies.
int Renderer::groundRows(const Shot& shot) const {
    const glm::vec3 forward = shot.pose.forward();
    const float level = std::hypot(forward.x, forward.z);
    if (level < 0.1f) return options_.height;
    const auto reach = static_cast<float>(groundReach * view_.groundSize);
    const glm::vec3 rim = groundCenter() + reach / level * forward;
    const glm::vec4 seen = shot.camera * glm::vec4(rim.x, view_.groundHeight, rim.z, 1);
    if (seen.w <= 0) return 0;
    const float height = (0.5f + 0.5f * seen.y / seen.w) * static_cast<float>(options_.height);
    return std::clamp(static_cast<int>(std::ceil(height)) + 1, 0, options_.height);
}

void Renderer::drawRows(const Program& program, int first, int last, const Shot& shot) {
    glScissor(0, first, options_.width, last - first);
    program.use();
    setStage(program, shot.pose);
    program.set("unproject", glm::inverse(shot.camera));
    const float size = static_cast<float>(view_.groundSize);
    program.set("ground", glm::vec3(view_.groundHeight, 1.2f * size, groundReach * size));
    const Stage& stage = view_.stage;
    program.set("groundColor", glm::vec3(stage.floor[0], stage.floor[1], stage.floor[2]));
    const glm::vec3 center = groundCenter();
    program.set("groundCenter", glm::vec2(center.x, center.z));
    if (mirror_) {
        program.set("mirror", glm::vec2(stage.mirror, stage.mirrorFades));
        program.set("subject", glm::vec2(shot.pose.target.x, shot.pose.target.z));
        program.set("mirrorNear", 8, mirror_->near());
        program.set("mirrorFar", 9, mirror_->far());
    }
    drawScreen(empty_);
}

void Renderer::setStage(const Program& program, const CameraPose& pose) const {
    program.set("eye", pose.eye);
    program.set("lens", glm::vec2(std::asin(pose.forward().y), pose.fieldOfView));
    const glm::vec3 center = toGlm(view_.glowCenter) + toGlm(view_.follow.target) * way_;
    program.set("glowDirection", glm::normalize(center - pose.eye));
    program.set("glow", glm::vec2(view_.glow, 2600.0f / glm::degrees(pose.fieldOfView)));
    program.set("bright", static_cast<float>(1 - view_.stage.dim));
    // Half as high as the subject's middle: body and shadow lie in the pool alike.
    const float middle = 0.5f * (center.y + static_cast<float>(view_.groundHeight));
    program.set("spot", glm::vec4(center.x, middle, center.z, view_.stage.spot));
    program.set("keyDirection", key_);
    program.set("fillDirection", fill_);
    program.set("rimDirection", rim_);
    program.set("keyMatrix", keyShadow_.matrix());
    program.set("skyMatrix", skyShadow_.matrix());
    program.set("keyDepth", 6, keyShadow_.depth());
    program.set("keyTexel", keyShadow_.texel());
    program.set("keyNarrow", 0, keyCover_.narrow());
    program.set("keyWide", 1, keyCover_.wide());
    program.set("keyFar", 10, keyCover_.far());
    program.set("skyNarrow", 2, skyCover_.narrow());
    program.set("skyWide", 3, skyCover_.wide());
    program.set("skyFar", 11, skyCover_.far());
    program.set("skyMoments", 7, skyMoments_.wide());
}

}  // namespace plait
