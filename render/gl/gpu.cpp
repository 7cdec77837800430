#include "gpu.h"

#include <stdexcept>
#include <vector>

namespace plait {
namespace {

GLuint compile(GLenum kind, const std::string& source) {
    const GLuint shader = glCreateShader(kind);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        std::string log(4096, '\0');
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw std::runtime_error("a shader does not compile: " + log.substr(0, log.find('\0')));
    }
    return shader;
}

GLuint generate(void (*function)(GLsizei, GLuint*)) {
    GLuint name = 0;
    function(1, &name);
    return name;
}

Framebuffer makeFramebuffer() {
    Framebuffer framebuffer(generate(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return framebuffer;
}

void requireComplete(const char* what) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error(std::string("this OpenGL cannot draw to ") + what);
}

Renderbuffer makeRenderbuffer(int width, int height, int samples, GLenum internal,
                              GLenum attachment) {
    Renderbuffer buffer(generate(glGenRenderbuffers));
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    return buffer;
}

}  // namespace

Buffer makeBuffer() { return Buffer(generate(glGenBuffers)); }
VertexArray makeVertexArray() { return VertexArray(generate(glGenVertexArrays)); }

Texture makeTexture(int width, int height, GLenum internal, GLenum format, GLenum type,
                    const void* pixels, const TextureOptions& options) {
    Texture texture(generate(glGenTextures));
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), width, height, 0, format, type,
                 pixels);
    const auto filter = static_cast<GLint>(options.filter), wrap = static_cast<GLint>(options.wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    return texture;
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
}

Target makeTarget(int width, int height, GLenum internal) {
    Target target{width, height, makeTexture(width, height, internal, GL_RGBA, GL_FLOAT, nullptr),
                  {},    {},     makeFramebuffer()};
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture, 0);
    requireComplete("a texture of floats");
    return target;
}

Target makeDepthTarget(int size) {
    Target target{size,
                  size,
                  makeTexture(size, size, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT,
                              nullptr, {.filter = GL_NEAREST}),
                  {},
                  {},
                  makeFramebuffer()};
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.texture, 0);
    requireComplete("a shadow map");
    return target;
}

Target makeSceneTarget(int width, int height, GLenum internal) {
    Target target = makeTarget(width, height, internal);
    target.depth = makeRenderbuffer(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    requireComplete("a texture with depth");
    return target;
}

Target makeMultisampledTarget(int width, int height, int samples) {
    Target target{width, height, {}, {}, {}, makeFramebuffer()};
    target.color = makeRenderbuffer(width, height, samples, GL_RGBA16F, GL_COLOR_ATTACHMENT0);
    target.depth =
        makeRenderbuffer(width, height, samples, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    requireComplete((std::to_string(samples) + " samples a pixel").c_str());
    return target;
}

Program::Program(const std::string& vertex, const std::string& fragment)
    : program_(glCreateProgram()) {
    for (const GLuint shader :
         {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program_);
    GLint good = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &good);
    if (!good) {
        std::string log(4096, '\0');
        glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw std::runtime_error("a shader does not link: " + log.substr(0, log.find('\0')));
    }
}

void Program::set(const char* name, float value) const {
    glUniform1f(glGetUniformLocation(program_, name), value);
}
void Program::set(const char* name, int value) const {
    glUniform1i(glGetUniformLocation(program_, name), value);
}
void Program::set(const char* name, const glm::vec2& v) const {
    glUniform2f(glGetUniformLocation(program_, name), v.x, v.y);
}
void Program::set(const char* name, const glm::vec3& v) const {
    glUniform3f(glGetUniformLocation(program_, name), v.x, v.y, v.z);
}
void Program::set(const char* name, const glm::vec4& v) const {
    glUniform4f(glGetUniformLocation(program_, name), v.x, v.y, v.z, v.w);
}
void Program::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(glGetUniformLocation(program_, name), 1, GL_FALSE, &value[0][0]);
}
void Program::set(const char* name, int unit, const Texture& texture) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    set(name, unit);
}

void drawScreen(const VertexArray& empty) {
    glBindVertexArray(empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace plait
