// A scene's state to a picture.
#pragma once

#include "camera.h"
#include "finish.h"
#include "overlay.h"
#include "render/gl/context.h"
#include "render/gl/gpu.h"
#include "render/matter/moment.h"
#include "render/matter/skin.h"
#include "render/matter/veils.h"
#include "render/pictures/picture.h"
#include "render/stage/floor_mirror.h"
#include "render/stage/grade.h"
#include "render/stage/shadow.h"
#include "render/water/water.h"
#include "scenes/scene.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plait {

struct RenderOptions {
    int width = 1280, height = 720;
    int samples = 4;  // a pixel; software Mesa knows 1 and 4
    GlChoice gl = GlChoice::automatic;
};

// Owns its context. Any thread may draw, one at a time. The same moment and overlay give the same
// bits, whatever was drawn before and however many threads Mesa uses.
class Renderer {
public:
    // Throws std::invalid_argument for a size below 16 by 16 and for a view without camera or with
    // looks that do not fit the world; std::runtime_error where there is no OpenGL to draw with.
    explicit Renderer(const Scene& scene, const RenderOptions& options = {});
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    ~Renderer();

    // The camera is where the view puts it at the time, or `chosen`. The overlay has a value for
    // each vertex.
    Picture draw(const Moment& moment, const Overlay* overlay = nullptr,
                 const CameraPose* chosen = nullptr);
    Picture draw(std::span<const Vec<double>> positions, double t, const Overlay* overlay = nullptr,
                 const CameraPose* chosen = nullptr) {
        return draw(Moment{positions, t}, overlay, chosen);
    }

    // The mean light of some moments, as a film that is exposed to all of them takes it; edges
    // are smoother, since each is taken a part of a pixel aside.
    Picture draw(std::span<const Moment> exposure, const Overlay* overlay = nullptr,
                 const CameraPose* chosen = nullptr);

    const Context& context() const { return context_; }

private:
    struct GpuMesh {
        VertexArray array;
        Buffer vertices, triangles;
        int corners = 0;
        Texture emblem;
        float period = 1;
    };

    // What a picture is of: from where, and in which colours.
    struct Shot {
        CameraPose pose;
        glm::mat4 camera;  // world to clip
        bool overlay;
        float lowest = -1e9f;  // m, where what is drawn is cut off
    };

    float aspect() const;
    // Light of one moment to resolved_; `aside` is in pixels.
    void expose(const Moment& moment, const Overlay* overlay, const CameraPose* chosen,
                const glm::vec2& aside);
    void addSkin(Skin skin);
    static void showTriangles(GpuMesh& mesh, const Skin& skin);
    void prepareTears(const Scene& scene);
    // Makes anew the skins of what has come apart by other cuts than they are made of.
    void tear(std::span<const std::int32_t> cuts);
    void prepareGround();
    void update(const Moment& moment, const Overlay* overlay, const Shot& shot);
    void findSubject(const Shot& shot);
    void renderShadows();
    void drawCasters(const glm::mat4& matrix, float perMetre);
    void drawSkins(const Shot& shot);
    void drawMesh(std::size_t i) const;
    void drawFaint(const Shot& shot);
    void drawVeils(const Shot& shot);
    void drawWater(const Shot& shot);
    void copyCanvas() const;
    // What of it is on that side of the water: 1 before it, 0 all else; -1 all of it.
    void drawGlass(const Shot& shot, int side);
    void findWater(const Shot& shot);
    void useSurface(std::size_t i, const Shot& shot);
    const Program& surfaceProgram(std::size_t i, const Shot& shot);
    float pixelAt(const CameraPose& pose) const;
    void drawMirror(const Shot& shot);
    void drawBackdrop(const Shot& shot);
    void drawRows(const Program& program, int first, int last, const Shot& shot);
    glm::vec3 groundCenter() const;
    int groundRows(const Shot& shot) const;
    void setStage(const Program& program, const CameraPose& pose) const;
    static bool isVeil(const Skin& skin);
    static bool isGlass(const Skin& skin);
    static bool isTranslucent(const Skin& skin) { return isVeil(skin) || isGlass(skin); }
    static const char* familyShader(Family family);

    View view_;
    RenderOptions options_;
    Context context_;
    std::vector<Skin> skins_;  // looks first, then props
    std::vector<GpuMesh> meshes_;
    std::optional<World> whole_;      // none: nothing in it may tear
    std::vector<std::int32_t> cuts_;  // that skins are made of
    float pixel_ = 0;                 // m, that it shows where the view's first camera looks
    std::map<std::string, Program> surfaces_;  // by #defines and family, made when first needed
    std::string prologue_;                     // of every shader that knows the stage
    Program depth_, netDepth_, backdrop_, ground_;
    Texture weave_, plain_;
    ShadowMap keyShadow_, skyShadow_;
    ShadowBlur keyCover_, skyCover_, skyMoments_;
    Veils veils_;
    std::optional<Water> water_;
    std::optional<FloorMirror> mirror_;
    Target canvas_, resolved_, sum_;
    Program share_;
    Grade grade_;
    VertexArray empty_;
    Buffer sorted_;  // triangles of what is faint
    glm::vec3 key_{0}, fill_{0}, rim_{0};
    glm::vec3 subject_{0};  // what casts shadows, and how far around it, m
    float radius_ = 1;
    glm::vec3 way_{0};  // of what the camera follows, m
};

}  // namespace plait
