// What is translucent: the triangles of several skins as one mesh, in the order in which they cover
// each other.
#pragma once

#include "skin.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

class Veils {
public:
    // The vertices of a frame, with the colours of their skins unless an overlay tinted them.
    void update(std::span<const Skin* const> skins, bool overlay);
    // Draws from back to front, as seen from `eye`. The program is in use.
    void draw(const glm::vec3& eye);

private:
    VertexArray array_;
    Buffer vertexBuffer_, triangleBuffer_;
    std::vector<MeshVertex> vertices_;
    std::vector<std::array<int, 3>> triangles_;
};

}  // namespace plait
