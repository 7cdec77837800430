// An OpenGL core profile without a window: by OSMesa, or by EGL without a surface where a Mesa has
// no OSMesa any more (from 25.1 on). Loaded at run time, so that neither is needed to link.
#pragma once

#include <memory>
#include <string>

namespace plait {

enum class GlChoice { automatic, osmesa, egl };

// "auto", "osmesa", "egl". Throws std::invalid_argument for another word.
GlChoice glChoice(const std::string& word);

class Context {
public:
    // Leaves the new context current in this thread. Automatic is OSMesa, then EGL. Throws
    // std::runtime_error, one line that names the package to install.
    explicit Context(GlChoice choice = GlChoice::automatic);

    // To be called by each thread before it draws; one thread at a time.
    void makeCurrent() const;

    const std::string& library() const { return library_; }    // "osmesa" or "egl"
    const std::string& renderer() const { return renderer_; }  // GL_RENDERER and GL_VERSION

    struct Backend {
        virtual ~Backend() = default;
        virtual void makeCurrent() = 0;
    };

private:
    std::unique_ptr<Backend> backend_;
    std::string library_, renderer_;
};

}  // namespace plait
