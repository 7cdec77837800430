// Who wears the dress: the ballerina, or a character of the user's own.
#pragma once

#include "parts/seam.h"
#include "parts/staging.h"
#include "scene.h"

namespace plait {

struct Wearer {
    Shape shape;                                    // at time 0
    MovingSurface surface;                          // by the time of the film, s
    Frame waist;                                    // at time 0
    std::function<Vec<double>(double t)> followed;  // by the camera
    double seconds = 0;
    Look look;
    Staging staging = {};
    std::vector<std::string> warnings = {};
};

// The silk of skirt and bodice, linear.
inline constexpr std::array vermilion{0.578, 0.032, 0.014};

Wearer ballerina();

// A character of the user's own (knobs `body`, `rate`, `waist`), in metres, y up, on the floor
// y = 0. Throws MeshFileError, and std::invalid_argument for one that cannot be worn.
Wearer wearerOf(const Knobs& knobs);

}  // namespace plait
