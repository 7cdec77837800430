#include "context.h"

#include "gl.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <latch>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace plait {
namespace {

using Function = void (*)();

// A shared library that stays loaded: Mesa leaves threads behind that run its code.
class Library {
public:
    Library(std::initializer_list<const char*> names) {
        for (const char* name : names)
            if (!handle_) handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    }
    explicit operator bool() const { return handle_; }

    template <class F>
    void get(F& function, const char* name) const {
        function = reinterpret_cast<F>(dlsym(handle_, name));
        if (!function) throw std::runtime_error(std::string(name) + " is missing in this Mesa");
    }

private:
    void* handle_ = nullptr;
};

// Mesa waits for ever for threads of its own that the system did not start: where as many as it
// takes, one a processor and one that keeps its shaders, do not, it is to draw without.
void spareThreads() {
    std::latch all(1);
    std::vector<std::jthread> threads;
    try {
        while (threads.size() <= std::thread::hardware_concurrency())
            threads.emplace_back([&] { all.wait(); });
    } catch (const std::system_error&) {
        setenv("LP_NUM_THREADS", "0", 0);
    }
    all.count_down();
}

class OsMesa : public Context::Backend {
public:
    explicit OsMesa(const Library& library) {
        library.get(create_, "OSMesaCreateContextAttribs");
        library.get(destroy_, "OSMesaDestroyContext");
        library.get(makeCurrent_, "OSMesaMakeCurrent");
        Function (*find)(const char*);
        library.get(find, "OSMesaGetProcAddress");
        // OSMESA_FORMAT RGBA, DEPTH_BITS 0, PROFILE core, version 3.3.
        spareThreads();
        const std::array attributes{0x22, 0x1908, 0x30, 0, 0x33, 0x34, 0x36, 3, 0x37, 3, 0};
        context_ = create_(attributes.data(), nullptr);
        if (!context_) throw std::runtime_error("OSMesa makes no context of OpenGL 3.3");
        makeCurrent();
        loadFunctions(find);
    }
    OsMesa(const OsMesa&) = delete;
    OsMesa& operator=(const OsMesa&) = delete;
    ~OsMesa() override { destroy_(context_); }

    void makeCurrent() override {
        if (!makeCurrent_(context_, pixels_.data(), GL_UNSIGNED_BYTE, size, size))
            throw std::runtime_error("OSMesa does not make its context current");
    }

private:
    static constexpr int size = 8;  // of a buffer nobody draws to
    void* (*create_)(const int*, void*) = nullptr;
    void (*destroy_)(void*) = nullptr;
    unsigned char (*makeCurrent_)(void*, void*, unsigned, int, int) = nullptr;
    void* context_ = nullptr;
    std::array<unsigned char, 4 * size * size> pixels_{};
};

class Egl : public Context::Backend {
public:
    explicit Egl(const Library& library) {
        void* (*platformDisplay)(unsigned, void*, const std::intptr_t*);
        unsigned (*initialize)(void*, int*, int*);
        unsigned (*bindApi)(unsigned);
        void* (*create)(void*, void*, void*, const int*);
        Function (*find)(const char*);
        library.get(platformDisplay, "eglGetPlatformDisplay");
        library.get(initialize, "eglInitialize");
        library.get(bindApi, "eglBindAPI");
        library.get(create, "eglCreateContext");
        library.get(destroy_, "eglDestroyContext");
        library.get(makeCurrent_, "eglMakeCurrent");
        library.get(find, "eglGetProcAddress");
        // EGL_PLATFORM_SURFACELESS_MESA, EGL_OPENGL_API; major, minor version, core profile.
        display_ = platformDisplay(0x31DD, nullptr, nullptr);
        if (!display_ || !initialize(display_, nullptr, nullptr) || !bindApi(0x30A2))
            throw std::runtime_error("EGL has no surfaceless platform");
        const std::array attributes{0x3098, 3, 0x30FB, 3, 0x30FD, 1, 0x3038};
        context_ = create(display_, nullptr, nullptr, attributes.data());
        if (!context_) throw std::runtime_error("EGL makes no context of OpenGL 3.3");
        makeCurrent();
        loadFunctions(find);
    }
    Egl(const Egl&) = delete;
    Egl& operator=(const Egl&) = delete;
    ~Egl() override { destroy_(display_, context_); }

    void makeCurrent() override {
        if (!makeCurrent_(display_, nullptr, nullptr, context_))
            throw std::runtime_error("EGL does not make its context current");
    }

private:
    unsigned (*destroy_)(void*, void*) = nullptr;
    unsigned (*makeCurrent_)(void*, void*, void*, void*) = nullptr;
    void *display_ = nullptr, *context_ = nullptr;
};

std::string text(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

}  // namespace

GlChoice glChoice(const std::string& word) {
    if (word == "auto") return GlChoice::automatic;
    if (word == "osmesa") return GlChoice::osmesa;
    if (word == "egl") return GlChoice::egl;
    throw std::invalid_argument("gl: \"" + word + "\" is not one of auto, osmesa, egl");
}

Context::Context(GlChoice choice) {
    if (choice != GlChoice::egl) {
        if (const Library library{"libOSMesa.so.8", "libOSMesa.so.6"}) {
            backend_ = std::make_unique<OsMesa>(library);
            library_ = "osmesa";
        } else if (choice == GlChoice::osmesa) {
            throw std::runtime_error("libOSMesa is missing: apt-get install libosmesa6");
        }
    }
    if (!backend_) {
        const Library library{"libEGL.so.1"};
        if (!library)
            throw std::runtime_error(
                "no offscreen OpenGL: apt-get install libosmesa6 (or libegl1 libegl-mesa0)");
        backend_ = std::make_unique<Egl>(library);
        library_ = "egl";
    }
    renderer_ = text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void Context::makeCurrent() const { backend_->makeCurrent(); }

}  // namespace plait
