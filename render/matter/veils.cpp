#include "veils.h"

#include <algorithm>

namespace plait {
void Veils::update(std::span<const Skin* const> skins, bool overlay) {
    if (!array_) {
        array_ = makeVertexArray();
        vertexBuffer_ = makeBuffer();
        triangleBuffer_ = makeBuffer();
        glBindVertexArray(array_);
        bindVertices(vertexBuffer_);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangleBuffer_);
    }
    vertices_.clear();
    triangles_.clear();
    for (const Skin* skin : skins) {
        const int first = static_cast<int>(vertices_.size());
        for (MeshVertex v : skin->vertices()) {
            if (!skin->colored() && !overlay) v.tint = skin->color();
            vertices_.push_back(v);
        }
        for (const auto& [a, b, c] : skin->triangles())
            triangles_.push_back({first + a, first + b, first + c});
    }
    uploadVertices(vertexBuffer_, vertices_);
}

// By counting: what is nearer than a 65,536th of the whole keeps its order.
void Veils::sort(const glm::vec3& eye) {
    constexpr int steps = 65536;
    distance_.clear();
    for (const auto& [a, b, c] : triangles_)
        distance_.push_back(glm::length(vertices_[a].position + vertices_[b].position +
                                        vertices_[c].position - 3.0f * eye));
    const auto [low, high] = std::ranges::minmax(distance_);
    const float scale = static_cast<float>(steps - 1) / std::max(high - low, 1e-6f);
    std::vector<int> start(steps + 1);
    const auto step = [&](std::size_t i) {
        return static_cast<int>((high - distance_[i]) * scale);
    };
    for (std::size_t i = 0; i < triangles_.size(); ++i) ++start[step(i) + 1];
    for (int i = 0; i < steps; ++i) start[i + 1] += start[i];
    sorted_.resize(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); ++i) sorted_[start[step(i)]++] = triangles_[i];
}

void Veils::draw(const glm::vec3& eye) {
    if (triangles_.empty()) return;
    sort(eye);
    glBindVertexArray(array_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(sorted_.size() * sizeof(sorted_[0])), sorted_.data(),
                 GL_STREAM_DRAW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * sorted_.size()), GL_UNSIGNED_INT,
                   nullptr);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace plait
