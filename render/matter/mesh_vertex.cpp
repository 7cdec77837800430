#include "mesh_vertex.h"

#include <cstddef>

namespace plait {
namespace {

void attribute(GLuint index, int numbers, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, numbers, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                          reinterpret_cast<const void*>(offset));  // NOLINT: as OpenGL has it
}

}  // namespace

void bindVertices(const Buffer& buffer) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    attribute(0, 3, offsetof(MeshVertex, position));
    attribute(1, 3, offsetof(MeshVertex, normal));
    attribute(2, 3, offsetof(MeshVertex, tangent));
    attribute(3, 2, offsetof(MeshVertex, uv));
    attribute(4, 3, offsetof(MeshVertex, tint));
    attribute(5, 1, offsetof(MeshVertex, cavity));
    attribute(6, 1, offsetof(MeshVertex, satin));
}

void uploadVertices(const Buffer& buffer, std::span<const MeshVertex> vertices) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
                 GL_STREAM_DRAW);
}

void uploadTriangles(const Buffer& buffer, std::span<const std::array<int, 3>> triangles,
                     GLenum usage) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()),
                 triangles.data(), usage);
}

}  // namespace plait
