// Solids with sharp edges that were one until they came apart: what of their faces is seen.
#pragma once

#include "mesh_vertex.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

// Every triangle has corners of its own. Those that had another solid right beside them are where
// it came apart, and are seen by how far what was nearest to them at rest is away (satin 0 to 1);
// the others are its outside (satin -1).
class Facets {
public:
    Facets() = default;
    // Positions at rest, m.
    Facets(std::span<const glm::vec3> rest, std::vector<std::array<int, 3>> triangles);

    bool empty() const { return triangles_.empty(); }
    int corners() const { return static_cast<int>(3 * triangles_.size()); }
    // Overwrites position, normal and satin of so many.
    void update(std::span<const glm::vec3> positions, std::span<MeshVertex> vertices) const;

private:
    std::vector<std::array<int, 3>> triangles_;
    std::vector<unsigned char> outside_;  // by triangle
    std::vector<int> near_;               // by vertex, of another solid; -1: none
    std::vector<float> apart_;            // m, from it at rest
};

}  // namespace plait
