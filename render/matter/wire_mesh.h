// The mesh of a section that is swept along a wire.
#pragma once

#include "mesh_vertex.h"
#include "scenes/view.h"
#include "wire_path.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

// A point of a section's outline: x along the director, y across.
struct OutlinePoint {
    glm::vec2 sharp;     // m, where it would be without bevels
    glm::vec2 rounding;  // m, from there to where it is
    glm::vec2 normal;    // of length 1
};

// Anticlockwise as seen against the tangent; finer for a wire that is more pixels wide. A polygon
// for a circle has the mean width of that.
std::vector<OutlinePoint> outlineOf(const Section& section, float pixels);

// How a wire is drawn at a point of its path.
struct WireLook {
    float scale = 1;    // of its section
    float cover = 1;    // part of what lies behind that it hides
    float relief = 1;   // part of its roundings and of the grooves between its turns that is seen
    glm::vec3 tint{0};  // of an overlay
};

// Appends the vertices, a ring for each point of the path, and two caps unless it is closed.
void appendWireVertices(std::span<const WirePoint> path, std::span<const WireLook> looks,
                        std::span<const OutlinePoint> outline, bool closed,
                        std::vector<MeshVertex>& vertices);

// Appends the triangles, front to the outside, of a wire whose vertices begin at `first`; they
// depend on the numbers of rings and of corners alone.
void appendWireTriangles(int first, int rings, int corners, bool closed,
                         std::vector<std::array<int, 3>>& triangles);

}  // namespace plait
