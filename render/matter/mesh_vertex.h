// A vertex as the shaders see it.
#pragma once

#include "render/gl/gpu.h"

#include <glm/glm.hpp>

#include <array>
#include <span>

namespace plait {

struct MeshVertex {
    glm::vec3 position{0};  // m
    glm::vec3 normal{0};    // of length 1
    glm::vec3 tangent{0};   // along the warp or the wire
    glm::vec2 uv{0};        // m across the cloth, from its lower left corner
    glm::vec3 tint{0};      // linear colour of an overlay, or its own
    float cavity = 0;       // bend towards the normal, 1/m: how hollow the front is; of a wire the
                            // part of the light from around that arrives
    float satin = 0;        // 0 .. 1, how much of it skin wears; of a wire how much it covers; of
                            // latex the factor by which its area has grown
};

// Describes the vertices in `buffer` to the vertex array that is bound.
void bindVertices(const Buffer& buffer);
void uploadVertices(const Buffer& buffer, std::span<const MeshVertex> vertices);
// To the vertex array that is bound.
void uploadTriangles(const Buffer& buffer, std::span<const std::array<int, 3>> triangles,
                     GLenum usage);

}  // namespace plait
