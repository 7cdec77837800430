// How a command ends: design.md section 9 in one place. Every error is one line.
#pragma once

#include "render/pictures/whole_file.h"  // FileError

#include <stdexcept>

namespace plait {

// Exit statuses.
enum Exit {
    exitOk = 0,
    exitFailed = 1,    // a check or a comparison
    exitUsage = 2,     // a bad option, scene or knob
    exitScene = 3,     // the scene cannot be built
    exitDiverged = 4,  // a number is not finite
    exitFiles = 5,     // cannot read or write, or a folder holds something else
    exitInterrupted = 130
};

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// SIGINT or SIGTERM came; everything written is whole.
struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace plait
