// What lives in the context, each object freed with its owner. All of it belongs to the thread in
// which the context is current.
#pragma once

#include "gl.h"

#include <glm/glm.hpp>

#include <string>
#include <utility>

namespace plait {

// A name that OpenGL gave out; moves, never copies.
template <void (*release)(GLuint)>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_) release(name_);
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

inline void releaseBuffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void releaseArray(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void releaseTexture(GLuint name) { glDeleteTextures(1, &name); }
inline void releaseRenderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline void releaseFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void releaseProgram(GLuint name) { glDeleteProgram(name); }

using Buffer = Handle<releaseBuffer>;
using VertexArray = Handle<releaseArray>;
using Texture = Handle<releaseTexture>;
using Renderbuffer = Handle<releaseRenderbuffer>;
using Framebuffer = Handle<releaseFramebuffer>;

Buffer makeBuffer();
VertexArray makeVertexArray();

struct TextureOptions {
    GLenum filter = GL_LINEAR;  // of both directions; mipmaps are added by the caller
    GLenum wrap = GL_CLAMP_TO_EDGE;
};
// `pixels` of `format` and `type`, or null for a texture to draw to.
Texture makeTexture(int width, int height, GLenum internal, GLenum format, GLenum type,
                    const void* pixels, const TextureOptions& options = {});

// Where a pass draws to: a texture, or a depth texture alone, or a multisampled pair of colour
// (RGBA16F) and depth. Throws std::runtime_error where the driver cannot.
struct Target {
    int width = 0, height = 0;
    Texture texture;
    Renderbuffer color, depth;
    Framebuffer framebuffer;

    void bind() const;
};
Target makeTarget(int width, int height, GLenum internal);
Target makeDepthTarget(int size);
Target makeSceneTarget(int width, int height,  // a texture of colour, and depth
                       GLenum internal = GL_RGBA16F);
Target makeMultisampledTarget(int width, int height, int samples);

// A program of a vertex and a fragment shader; uniforms are set by name.
class Program {
public:
    Program() = default;
    // Throws std::runtime_error with the compiler's log.
    Program(const std::string& vertex, const std::string& fragment);

    explicit operator bool() const { return program_ != 0; }
    void use() const { glUseProgram(program_); }
    // On the program in use. A name that the compiler dropped is ignored.
    void set(const char* name, float value) const;
    void set(const char* name, int value) const;
    void set(const char* name, const glm::vec2& value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, int unit, const Texture& texture) const;

private:
    Handle<releaseProgram> program_;
};

// One triangle that covers the target; the vertex array has no attributes.
void drawScreen(const VertexArray& empty);

}  // namespace plait
