// The picture in a floor that mirrors: at half the size, since most of it is blurred.
#pragma once

#include "render/gl/gpu.h"

namespace plait {

class FloorMirror {
public:
    FloorMirror(int width, int height);  // of the whole picture, pixels

    // What is drawn between them is mirrored: nothing is there but what is drawn, its light times
    // its alpha.
    void begin();
    void end(const VertexArray& empty);

    const Texture& near() const { return near_.texture; }  // of what touches the floor
    const Texture& far() const { return far_.texture; }    // of what is high above it

private:
    void blur(const Target& from, const Target& to, const glm::vec2& step,
              const VertexArray& empty) const;

    Program blur_;
    Target image_, across_, near_, far_;
};

}  // namespace plait
