// Curves: edges strung together, and round tubes around them.
#pragma once

#include "mesh_vertex.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

struct Polyline {
    std::vector<int> vertices;
    bool closed = false;  // the last vertex is joined to the first
};

// Every edge in exactly one polyline; where more than two meet, polylines end.
std::vector<Polyline> polylines(std::span<const std::array<int, 2>> edges, int vertexCount);

// Appends a tube of `radius` with round ends along a smooth curve (Catmull-Rom) through the points,
// to vertices and triangles. `tints` are by point. The number of vertices depends on the number of
// points alone.
void appendTube(std::span<const glm::vec3> points, std::span<const glm::vec3> tints, bool closed,
                float radius, std::vector<MeshVertex>& vertices,
                std::vector<std::array<int, 3>>& triangles);

}  // namespace plait
