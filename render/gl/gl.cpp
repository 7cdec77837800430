#include "gl.h"

#include <stdexcept>
#include <string>

namespace plait {
namespace {

template <class Function>
void load(Function& function, const char* name, void (*(*find)(const char*))()) {
    function = reinterpret_cast<Function>(find(name));
    if (!function)
        throw std::runtime_error(std::string("this OpenGL lacks ") + name +
                                 "; install libosmesa6 of Mesa 22 or newer");
}

}  // namespace

void loadFunctions(void (*(*find)(const char* name))()) {
#define PLAIT_LOAD(TYPE, name) load(gl##name, "gl" #name, find);
    PLAIT_GL_FUNCTIONS(PLAIT_LOAD)
#undef PLAIT_LOAD
}

}  // namespace plait
