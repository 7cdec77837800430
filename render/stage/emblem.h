// The emblem of the suite: a plait of three strands, two ivory and one brass.
#pragma once

#include <vector>

namespace plait {

// Signed distances to the ivory and to the brass region, negative inside, in units of the cloth's
// height: exact enough to draw a sharp edge at any size from a small table.
struct Emblem {
    static constexpr float reach = 0.05f;  // distances end at +-reach
    int width = 256, height = 320;         // texels; repeats along the width
    float period = 1;                      // in heights of the cloth
    std::vector<unsigned short> texels =
        {};  // ivory, brass: 0 .. 65535 for -reach .. reach; row 0 low
};

// For a cloth of the given width in heights; a whole number of turns fits.
Emblem makeEmblem(float aspect);

}  // namespace plait
