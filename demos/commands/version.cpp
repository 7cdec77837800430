#include "commands.h"
#include "demos/tools/machine.h"
#include "render/gl/context.h"

#include <exception>

namespace plait {

std::string versionText() {
    const Machine machine = thisMachine();
    std::string gl;
    try {
        const Context context;
        gl = context.library() + ", " + context.renderer();
    } catch (const std::exception& error) {
        gl = std::string("none: ") + error.what();
    }
    return "plait " PLAIT_VERSION "\ncompiler " PLAIT_COMPILER "\nkernels " + machine.kernels +
           ", " + std::to_string(machine.lanes) + " lanes\nOpenGL " + gl + "\n";
}

}  // namespace plait
