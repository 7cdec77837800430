// A liquid as it is seen: no mesh, but the depths of its particles as balls, smoothed on the
// screen.
#pragma once

#include "render/gl/gpu.h"
#include "scenes/view.h"

#include <glm/glm.hpp>

#include <span>
#include <string>
#include <vector>

namespace plait {

// From where it is seen.
struct WaterLens {
    glm::vec3 eye, forward;
    glm::mat4 camera;   // world to clip
    float fieldOfView;  // vertical, rad
};

class Water {
public:
    // `prologue`: version and stage of shaders. Of a picture of this size, pixels. Throws
    // std::invalid_argument for more panes than six.
    Water(const Look& look, const std::string& prologue, int width, int height);

    // Positions (m) and ages (s; below 0: not there) of the whole world; no ages: all are there.
    void update(std::span<const Vec<double>> positions, std::span<const double> ages = {});
    std::span<const glm::vec3> points() const { return points_; }
    // m, of a ball: those of neighbours overlap.
    float radius() const { return radius_; }

    // Into depth alone, seen from a light: `perMetre` pixels each.
    void drawShadow(const glm::mat4& matrix, float perMetre) const;
    // Finds the surface; whatever target was bound is no more.
    void find(const WaterLens& lens, const VertexArray& empty) const;
    // m along the camera's axis, of what was found; 0: none.
    const Texture& depths() const { return smoothed_.texture; }
    // The program that draws what was found over what is there, which is `behind`; the stage is for
    // the caller to set, who then calls drawScreen() with depths tested.
    const Program& use(const WaterLens& lens, const Texture& behind) const;

private:
    void setDrops(const Program& program, const WaterLens& lens, const Target& target) const;
    void blur(const WaterLens& lens, const VertexArray& empty) const;
    void smooth(const Target& from, const Target& to, const glm::vec2& step,
                const VertexArray& empty) const;
    float pixels(const WaterLens& lens) const;

    Range range_;
    float spacing_, radius_;
    glm::vec3 color_, swallow_;
    std::vector<glm::vec4> panes_;
    float beyond_;  // m, from the water to what is seen through it
    int height_;
    Program depth_, thickness_, shadow_, smooth_, blur_, surface_;
    Target depths_, across_, smoothed_, thicknesses_, blurred_;
    VertexArray array_;
    Buffer buffer_;
    std::vector<glm::vec3> points_;
    glm::vec3 middle_{0};  // of the points
};

}  // namespace plait
