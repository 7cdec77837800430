#include "renderer.h"

#include "finish.h"
#include "render/shaders/backdrop.h"
#include "render/shaders/brushed.h"
#include "render/shaders/cloth.h"
#include "render/shaders/crystal.h"
#include "render/shaders/glass.h"
#include "render/shaders/grade.h"
#include "render/shaders/latex.h"
#include "render/shaders/shadow.h"
#include "render/shaders/skin.h"
#include "render/shaders/stage.h"
#include "render/shaders/surface.h"
#include "render/shaders/tulle.h"
#include "render/stage/emblem.h"
#include "render/stage/weave.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

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

}  // namespace

Renderer::Renderer(const Scene& scene, const RenderOptions& options)
    : view_(checked(scene, options)),
      options_(options),
      context_(options.gl),
      prologue_("#version 330 core\n" + std::string(view_.stage.spot > 0 ? "#define SPOT\n" : "") +
                stageShader),
      depth_(depthVertexShader, depthShader),
      backdrop_(screenVertexShader, prologue_ + backdropShader),
      weave_(makeWeave()),
      plain_(makeTexture(1, 1, GL_RG8, GL_RG, GL_UNSIGNED_BYTE, "\xff\xff")),
      keyShadow_(512),
      skyShadow_(256),
      skyMoments_({momentsShader, GL_RGBA32F, 128, 0.75f, 2.5f}),
      canvas_(makeMultisampledTarget(options.width, options.height, options.samples)),
      resolved_(makeTarget(options.width, options.height, GL_RGBA16F)),
      grade_(options.width, options.height),
      empty_(makeVertexArray()),
      sorted_(makeBuffer()) {
    if (view_.ground) prepareGround();
    const CameraPose pose = poseAt(view_.cameras, view_.cameras[0].time).framed(aspect());
    key_ = lightDirection(pose, -50, 42);
    fill_ = lightDirection(pose, 65, 18);
    rim_ = lightDirection(pose, 150, 38);
    pixel_ = pixelAt(pose);
    prepareTears(scene);
    for (const Look& look : view_.looks) {
        if (look.material == Material::water) {
            if (water_) throw std::invalid_argument("view: more than one look is of water");
            water_.emplace(look, prologue_, options.width, options.height);
        }
        addSkin(Skin(scene.world, look, pixel_));
    }
    for (const Prop& prop : view_.props) addSkin(Skin(prop));
}

Renderer::~Renderer() { context_.makeCurrent(); }

float Renderer::aspect() const {
    return static_cast<float>(options_.width) / static_cast<float>(options_.height);
}

void Renderer::addSkin(Skin skin) {
    GpuMesh mesh{makeVertexArray(), makeBuffer(), makeBuffer(), 0, {}, 1};
    glBindVertexArray(mesh.array);
    bindVertices(mesh.vertices);
    showTriangles(mesh, skin);
    if (skin.printed()) {
        const Emblem emblem = makeEmblem(skin.size().x / skin.size().y);
        mesh.period = emblem.period * skin.size().y;
        mesh.emblem = makeTexture(emblem.width, emblem.height, GL_RG16, GL_RG, GL_UNSIGNED_SHORT,
                                  emblem.texels.data(), {.wrap = GL_REPEAT});
    }
    uploadVertices(mesh.vertices, skin.vertices());
    if (isTranslucent(skin) && !netDepth_) netDepth_ = Program(depthVertexShader, netDepthShader);
    skins_.push_back(std::move(skin));
    meshes_.push_back(std::move(mesh));
}

void Renderer::showTriangles(GpuMesh& mesh, const Skin& skin) {
    glBindVertexArray(mesh.array);
    uploadTriangles(mesh.triangles, skin.triangles(), GL_STATIC_DRAW);
    mesh.corners = static_cast<int>(3 * skin.triangles().size());
}

bool Renderer::isVeil(const Skin& skin) {
    return finishOf(skin.material()).family == Family::tulle;
}

bool Renderer::isGlass(const Skin& skin) {
    const Family family = finishOf(skin.material()).family;
    return family == Family::glass || family == Family::crystal;
}

Picture Renderer::draw(const Moment& moment, const Overlay* overlay, const CameraPose* chosen) {
    expose(moment, overlay, chosen, glm::vec2(0));
    return grade_.apply(resolved_.texture, static_cast<float>(view_.stage.vignette), empty_);
}

Picture Renderer::draw(std::span<const Moment> exposure, const Overlay* overlay,
                       const CameraPose* chosen) {
    context_.makeCurrent();
    if (!share_) {
        share_ = Program(blurVertexShader, shareShader);
        sum_ = makeTarget(options_.width, options_.height, GL_RGBA32F);
    }
    sum_.bind();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    for (std::size_t i = 0; i < exposure.size(); ++i) {
        // The plastic number's powers: any of them in a row lie evenly over a pixel.
        const glm::vec2 aside =
            glm::fract(static_cast<float>(i) * glm::vec2(0.7548777f, 0.5698403f) + 0.5f) - 0.5f;
        expose(exposure[i], overlay, chosen, aside);
        sum_.bind();
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        share_.use();
        share_.set("source", 0, resolved_.texture);
        share_.set("share", 1 / static_cast<float>(exposure.size()));
        drawScreen(empty_);
        glDisable(GL_BLEND);
    }
    return grade_.apply(sum_.texture, static_cast<float>(view_.stage.vignette), empty_);
}

void Renderer::expose(const Moment& moment, const Overlay* overlay, const CameraPose* chosen,
                      const glm::vec2& aside) {
    context_.makeCurrent();
    const double t = moment.time;
    const CameraPose pose = (chosen ? *chosen : poseOf(view_, t)).framed(aspect());
    Shot shot{pose, pose.matrix(aspect()), overlay != nullptr};
    if (aside != glm::vec2(0))
        shot.camera = glm::translate(
                          glm::mat4(1),
                          glm::vec3(2.0f * aside / glm::vec2(options_.width, options_.height), 0)) *
                      shot.camera;
    way_ = wayAt(view_.follow, t);
    update(moment, overlay, shot);
    findSubject(shot);
    renderShadows();
    drawMirror(shot);
    findWater(shot);

    canvas_.bind();
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawSkins(shot);
    drawBackdrop(shot);
    drawFaint(shot);
    if (water_) {
        copyCanvas();
        canvas_.bind();
    }
    drawGlass(shot, water_ ? 0 : -1);
    drawVeils(shot);
    drawWater(shot);
    copyCanvas();
}

void Renderer::update(const Moment& moment, const Overlay* overlay, const Shot& shot) {
    tear(moment.cuts);
    const Lens lens{shot.pose.eye, shot.pose.forward(),
                    2 * std::tan(shot.pose.fieldOfView / 2) / static_cast<float>(options_.height)};
    std::vector<glm::vec3> tints;
    if (overlay)
        for (const float value : overlay->values) tints.push_back(overlayColor(*overlay, value));
    for (std::size_t i = 0; i < view_.looks.size(); ++i) {
        skins_[i].update(moment, tints, lens);
        uploadVertices(meshes_[i].vertices, skins_[i].vertices());
    }
    for (std::size_t i = 0; i < view_.props.size(); ++i) {
        if (!view_.props[i].motion) continue;
        const std::size_t skin = view_.looks.size() + i;
        skins_[skin].place(view_.props[i].motion(moment.time));
        uploadVertices(meshes_[skin].vertices, skins_[skin].vertices());
    }
    if (water_) water_->update(moment.positions, moment.ages);
    std::vector<const Skin*> veils;
    for (const Skin& skin : skins_)
        if (isVeil(skin)) veils.push_back(&skin);
    if (!veils.empty()) veils_.update(veils, overlay != nullptr);
}

void Renderer::drawSkins(const Shot& shot) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    for (std::size_t i = 0; i < skins_.size(); ++i) {
        if (isTranslucent(skins_[i]) || skins_[i].faint()) continue;
        useSurface(i, shot);
        drawMesh(i);
    }
}

// Closed skins show their outside only.
void Renderer::drawMesh(std::size_t i) const {
    if (skins_[i].isWire()) glEnable(GL_CULL_FACE);
    glBindVertexArray(meshes_[i].array);
    glDrawElements(GL_TRIANGLES, meshes_[i].corners, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_CULL_FACE);
}

void Renderer::useSurface(std::size_t i, const Shot& shot) {
    const Skin& skin = skins_[i];
    const Finish finish = finishOf(skin.material());
    const Program& program = surfaceProgram(i, shot);
    program.use();
    setStage(program, shot.pose);
    program.set("camera", shot.camera);
    program.set("lowest", shot.lowest);
    program.set("thickness", finish.family == Family::cloth ? 0.0005f : 0.0f);
    program.set("color", skin.color());
    program.set("finish", finish.numbers);
    program.set("wrap", finish.wrap);
    program.set("gloss", finish.gloss);
    program.set("facet", skin.facet());
    program.set("depth",
                depthOf(i < view_.looks.size() ? view_.looks[i].wall : Wall{}, skin.color()));
    program.set("print", glm::vec3(meshes_[i].period, skin.size().y, skin.size().x));
    program.set("emblem", 4, skin.printed() ? meshes_[i].emblem : plain_);
    program.set("weave", 5, weave_);
}

const char* Renderer::familyShader(Family family) {
    switch (family) {
        case Family::cloth:
            return clothShader;
        case Family::metal:
            return metalShader;
        case Family::coat:
            return coatShader;
        case Family::skin:
            return skinShader;
        case Family::tulle:
            return tulleShader;
        case Family::brushed:
            return brushedShader;
        case Family::latex:
            return latexShader;
        case Family::water:
            break;
        case Family::glass:
            return glassShader;
        case Family::crystal:
            return crystalShader;
        case Family::spark:
            return sparkShader;
    }
    return coatShader;
}

const Program& Renderer::surfaceProgram(std::size_t i, const Shot& shot) {
    const Skin& skin = skins_[i];
    const bool prop = i >= view_.looks.size();
    const Family family = finishOf(skin.material()).family;
    std::string defines, vertex, light;
    if (!prop) defines += "#define FINE\n";
    if (shot.overlay && !prop) defines += "#define OVERLAY\n";
    if (skin.colored() || family == Family::tulle) defines += "#define COLORS\n";
    if (family == Family::skin) defines += "#define SKIN\n";
    if (family == Family::latex || isGlass(skin)) defines += "#define LATEX\n";
    if (skin.isWire()) defines += "#define WIRE\n";
    if (family == Family::tulle) {
        defines += "#define TULLE\n";
        vertex = tulleLightShader;
    }
    if (family == Family::brushed) {
        defines += "#define BRUSHED\n";
        vertex = brushedLightShader;
    }
    if (family == Family::cloth) {
        if (skin.printed() && !shot.overlay) defines += "#define PRINT\n";
        // Threads that are finer than a pixel cost and show nothing.
        if (pixelAt(shot.pose) < weavePitch) defines += "#define WEAVE\n";
        const bool small = skin.facet() > 0;
        if (small) defines += "#define SMALL\n";
        (small ? vertex : light) = clothLightShader;
    }
    const char* const text = familyShader(family);
    Program& program = surfaces_[defines + text];
    if (!program) {
        const std::string stage = prologue_ + defines + reflectionShader;
        program =
            Program(stage + vertex + surfaceVertexShader, stage + light + surfaceShader + text);
    }
    return program;
}

// m, that a pixel shows where the camera looks.
float Renderer::pixelAt(const CameraPose& pose) const {
    return glm::length(pose.target - pose.eye) * pose.fieldOfView /
           static_cast<float>(options_.height);
}

}  // namespace plait
