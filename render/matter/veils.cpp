#include "veils.h"

#include "back_to_front.h"

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

void Veils::draw(const glm::vec3& eye) {
    if (triangles_.empty()) return;
    const auto sorted = backToFront(triangles_, vertices_, eye);
    glBindVertexArray(array_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(sorted.size() * sizeof(sorted[0])), sorted.data(),
                 GL_STREAM_DRAW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * sorted.size()), GL_UNSIGNED_INT, nullptr);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace plait
