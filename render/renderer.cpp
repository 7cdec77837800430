#include "renderer.h"

#include "emblem.h"
#include "finish.h"
#include "shaders/backdrop.h"
#include "shaders/cloth.h"
#include "shaders/shadow.h"
#include "shaders/stage.h"
#include "shaders/surface.h"
#include "weave.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

constexpr const char* version = "#version 330 core\n";
// Sizes of the subject, from its middle to where the ground ends.
constexpr float groundReach = 3.5f;

glm::vec3 toGlm(const Vec<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Azimuth from the direction towards the camera, + is right; degrees.
glm::vec3 lightDirection(const CameraPose& pose, float azimuth, float elevation) {
    const glm::vec3 f = pose.forward();
    const float l = std::hypot(f.x, f.z);
    const glm::vec3 back = l > 1e-6f ? glm::vec3(-f.x / l, 0, -f.z / l) : glm::vec3(0, 0, 1);
    const glm::vec3 right(back.z, 0, -back.x);
    const float a = glm::radians(azimuth), e = glm::radians(elevation);
    return std::cos(e) * (std::cos(a) * back + std::sin(a) * right) + glm::vec3(0, std::sin(e), 0);
}

const View& checked(const Scene& scene, const RenderOptions& options) {
    if (options.width < 16 || options.height < 16)
        throw std::invalid_argument("size: a picture has at least 16 by 16 pixels");
    if (scene.view.cameras.empty()) throw std::invalid_argument("view: has no camera");
    return scene.view;
}

void attribute(GLuint index, int numbers, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, numbers, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          reinterpret_cast<const void*>(offset));  // NOLINT: as OpenGL has it
}

}  // namespace

Renderer::Renderer(const Scene& scene, const RenderOptions& options)
    : view_(checked(scene, options)),
      options_(options),
      context_(options.gl),
      depth_(depthVertexShader, depthShader),
      backdrop_(screenVertexShader, version + std::string(stageShader) + backdropShader),
      weave_(makeWeave()),
      plain_(makeTexture(1, 1, GL_RG8, GL_RG, GL_UNSIGNED_BYTE, "\xff\xff")),
      keyShadow_({.size = 512}),
      keyBlur_({.size = 384, .spacing = 1.0f, .wideSpacing = 2.6f}),
      skyShadow_({.size = 256, .spacing = 1.5f, .wideSpacing = 5.0f}),
      canvas_(makeMultisampledTarget(options.width, options.height, options.samples)),
      resolved_(makeTarget(options.width, options.height, GL_RGBA16F)),
      grade_(options.width, options.height),
      empty_(makeVertexArray()) {
    if (view_.ground)
        ground_ = Program(screenVertexShader,
                          version + std::string("#define GROUND\n") + stageShader + backdropShader);
    const CameraPose pose = poseAt(view_.cameras, view_.cameras[0].time);
    key_ = lightDirection(pose, -50, 42);
    fill_ = lightDirection(pose, 65, 18);
    rim_ = lightDirection(pose, 150, 38);
    for (const Look& look : view_.looks)
        addSkin(Skin(scene.world.complex, scene.world.rest, look, pixelAt(pose)));
    for (const Coil& coil : view_.coils) addSkin(Skin(scene.world.rest, coil));
    for (const Prop& prop : view_.props) addSkin(Skin(prop));
}

Renderer::~Renderer() { context_.makeCurrent(); }

void Renderer::addSkin(Skin skin) {
    GpuMesh mesh{makeVertexArray(), makeBuffer(), makeBuffer(), 0, {}, 1};
    glBindVertexArray(mesh.array);
    glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
    attribute(0, 3, offsetof(MeshVertex, position));
    attribute(1, 3, offsetof(MeshVertex, normal));
    attribute(2, 3, offsetof(MeshVertex, tangent));
    attribute(3, 2, offsetof(MeshVertex, uv));
    attribute(4, 3, offsetof(MeshVertex, tint));
    attribute(5, 1, offsetof(MeshVertex, cavity));
    const auto& triangles = skin.triangles();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(triangles.size() * sizeof(triangles[0])), triangles.data(),
                 GL_STATIC_DRAW);
    mesh.corners = static_cast<int>(3 * triangles.size());
    if (skin.printed()) {
        const Emblem emblem = makeEmblem(skin.size().x / skin.size().y);
        mesh.period = emblem.period * skin.size().y;
        mesh.emblem = makeTexture(emblem.width, emblem.height, GL_RG16, GL_RG, GL_UNSIGNED_SHORT,
                                  emblem.texels.data(), {.wrap = GL_REPEAT});
    }
    skins_.push_back(std::move(skin));
    meshes_.push_back(std::move(mesh));
    upload(skins_.size() - 1);
}

void Renderer::upload(std::size_t i) {
    const auto& vertices = skins_[i].vertices();
    glBindBuffer(GL_ARRAY_BUFFER, meshes_[i].vertices);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(MeshVertex)),
                 vertices.data(), GL_STREAM_DRAW);
}

// A sphere around all that casts a shadow, in steps, so that the shadow's texels keep still.
void Renderer::findSubject() {
    glm::vec3 low(1e30f), high(-1e30f);
    for (const Skin& skin : skins_)
        for (const MeshVertex& v : skin.vertices()) {
            low = glm::min(low, v.position);
            high = glm::max(high, v.position);
        }
    if (low.x > high.x) low = high = glm::vec3(0);
    const float radius = std::max(0.5f * glm::length(high - low), 1e-3f);
    radius_ = std::exp2(std::ceil(4 * std::log2(radius)) / 4);
    const float step = radius_ / 16;
    subject_ = glm::round(0.5f * (low + high) / step) * step;
    radius_ += step;
}

Picture Renderer::draw(std::span<const Vec<double>> positions, double t, const Overlay* overlay,
                       const CameraPose* chosen) {
    context_.makeCurrent();
    const CameraPose pose = chosen ? *chosen : poseAt(view_.cameras, t);
    std::vector<glm::vec3> tints;
    if (overlay)
        for (const float value : overlay->values) tints.push_back(overlayColor(*overlay, value));
    for (std::size_t i = 0; i < view_.looks.size() + view_.coils.size(); ++i) {
        skins_[i].update(positions, tints);
        upload(i);
    }
    findSubject();
    const auto casters = [&](const glm::mat4& matrix) { drawCasters(matrix); };
    keyShadow_.render(key_, subject_, radius_, casters, empty_);
    if (view_.ground) keyBlur_.render(key_, subject_, radius_, casters, empty_);
    skyShadow_.render({0, 1, 0}, subject_, radius_, casters, empty_);

    const glm::mat4 camera =
        pose.matrix(static_cast<float>(options_.width) / static_cast<float>(options_.height));
    canvas_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawSkins(camera, pose, overlay);
    drawBackdrop(camera, pose);

    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas_.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
    glBlitFramebuffer(0, 0, options_.width, options_.height, 0, 0, options_.width, options_.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return grade_.apply(resolved_.texture, empty_);
}

void Renderer::drawCasters(const glm::mat4& matrix) {
    depth_.use();
    depth_.set("matrix", matrix);
    for (const GpuMesh& mesh : meshes_) {
        glBindVertexArray(mesh.array);
        glDrawElements(GL_TRIANGLES, mesh.corners, GL_UNSIGNED_INT, nullptr);
    }
}

void Renderer::drawSkins(const glm::mat4& camera, const CameraPose& pose, bool overlay) {
    for (std::size_t i = 0; i < skins_.size(); ++i) {
        const Skin& skin = skins_[i];
        const GpuMesh& mesh = meshes_[i];
        const Finish finish = finishOf(skin.material());
        const Program& program = surfaceProgram(i, pose, overlay);
        program.use();
        setStage(program, pose);
        program.set("camera", camera);
        program.set("thickness", finish.family == Family::cloth ? 0.0005f : 0.0f);
        program.set("color", skin.color());
        program.set("finish", finish.numbers);
        program.set("wrap", finish.wrap);
        program.set("gloss", finish.gloss);
        program.set("facet", skin.facet());
        program.set("print", glm::vec3(mesh.period, skin.size().y, skin.size().x));
        program.set("emblem", 4, skin.printed() ? mesh.emblem : plain_);
        program.set("weave", 5, weave_);
        glBindVertexArray(mesh.array);
        glDrawElements(GL_TRIANGLES, mesh.corners, GL_UNSIGNED_INT, nullptr);
    }
}

const Program& Renderer::surfaceProgram(std::size_t i, const CameraPose& pose, bool overlay) {
    const Skin& skin = skins_[i];
    const bool prop = i >= view_.looks.size();  // or a coil
    const Family family = finishOf(skin.material()).family;
    std::string defines;
    if (!prop) defines += "#define FINE\n";
    if (overlay && !prop) defines += "#define OVERLAY\n";
    std::string light;
    bool small = false;
    if (family == Family::cloth) {
        light = clothLightShader;
        if (skin.printed() && !overlay) defines += "#define PRINT\n";
        // Threads that are finer than a pixel cost and show nothing.
        if (pixelAt(pose) < weavePitch) defines += "#define WEAVE\n";
        small = skin.facet() > 0;
        if (small) defines += "#define SMALL\n";
    }
    const auto text = family == Family::cloth   ? clothShader
                      : family == Family::metal ? metalShader
                                                : coatShader;
    Program& program = surfaces_[defines + text];
    if (!program) {
        const std::string stage = version + defines + stageShader + reflectionShader;
        program = Program(stage + (small ? light : "") + surfaceVertexShader,
                          stage + (small ? "" : light) + surfaceShader + text);
    }
    return program;
}

// m, that a pixel shows where the camera looks.
float Renderer::pixelAt(const CameraPose& pose) const {
    return glm::length(pose.target - pose.eye) * pose.fieldOfView /
           static_cast<float>(options_.height);
}

void Renderer::drawBackdrop(const glm::mat4& camera, const CameraPose& pose) {
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_SCISSOR_TEST);
    const int rows = view_.ground ? groundRows(camera, pose) : 0;
    if (rows > 0) drawRows(ground_, 0, rows, camera, pose);
    if (rows < options_.height) drawRows(backdrop_, rows, options_.height, camera, pose);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
}

// Rows from the bottom below which all of the ground lies.
int Renderer::groundRows(const glm::mat4& camera, const CameraPose& pose) const {
    const glm::vec3 forward = pose.forward();
    const float level = std::hypot(forward.x, forward.z);
    if (level < 0.1f) return options_.height;
    const auto reach = static_cast<float>(groundReach * view_.groundSize);
    const glm::vec3 rim = toGlm(view_.glowCenter) + reach / level * forward;
    const glm::vec4 seen = camera * glm::vec4(rim.x, view_.groundHeight, rim.z, 1);
    if (seen.w <= 0) return 0;
    const float height = (0.5f + 0.5f * seen.y / seen.w) * static_cast<float>(options_.height);
    return std::clamp(static_cast<int>(std::ceil(height)) + 1, 0, options_.height);
}

void Renderer::drawRows(const Program& program, int first, int last, const glm::mat4& camera,
                        const CameraPose& pose) {
    glScissor(0, first, options_.width, last - first);
    program.use();
    setStage(program, pose);
    program.set("unproject", glm::inverse(camera));
    const float size = static_cast<float>(view_.groundSize);
    program.set("ground", glm::vec3(view_.groundHeight, 1.2f * size, groundReach * size));
    program.set("groundColor", glm::vec3(0.254f, 0.216f, 0.188f));
    program.set("groundCenter", glm::vec2(view_.glowCenter.x, view_.glowCenter.z));
    drawScreen(empty_);
}

void Renderer::setStage(const Program& program, const CameraPose& pose) const {
    program.set("eye", pose.eye);
    program.set("lens", glm::vec2(std::asin(pose.forward().y), pose.fieldOfView));
    program.set("glowDirection", glm::normalize(toGlm(view_.glowCenter) - pose.eye));
    program.set("glow", glm::vec2(view_.glow, 2600.0f / glm::degrees(pose.fieldOfView)));
    program.set("keyDirection", key_);
    program.set("fillDirection", fill_);
    program.set("rimDirection", rim_);
    program.set("keyMatrix", keyShadow_.matrix());
    program.set("skyMatrix", skyShadow_.matrix());
    program.set("keyDepth", 6, keyShadow_.depth());
    program.set("keyTexel", keyShadow_.texel());
    program.set("keyNarrow", 0, keyBlur_.narrow());
    program.set("keyWide", 1, keyBlur_.wide());
    program.set("skyNarrow", 2, skyShadow_.narrow());
    program.set("skyWide", 3, skyShadow_.wide());
}

}  // namespace plait
