// Triangles in the order in which they cover each other.
#pragma once

#include "mesh_vertex.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

// The farthest from `eye` first, by their middles. By counting: what is nearer to each other than a
// 65,536th of the whole keeps its order. Groups of so many that follow each other stay together.
std::vector<std::array<int, 3>> backToFront(std::span<const std::array<int, 3>> triangles,
                                            std::span<const MeshVertex> vertices,
                                            const glm::vec3& eye, std::size_t group = 1);

}  // namespace plait
