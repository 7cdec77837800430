// The last passes: bloom, exposure, vignette, Khronos PBR Neutral, sRGB, dither, and reading back.
#pragma once

#include "render/gl/gpu.h"
#include "render/pictures/picture.h"

namespace plait {

class Grade {
public:
    Grade() = default;
    Grade(int width, int height);

    // `scene` is linear light of the same size; `vignette` is the part that is lost at the middle
    // of an edge.
    Picture apply(const Texture& scene, float vignette, const VertexArray& empty);

private:
    Program bright_, bloom_, grade_;
    Target small_, across_, result_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace plait
