// The smooth curve that a wire follows, with its material frame.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace plait {

struct WirePoint {
    glm::vec3 place{0};           // m
    glm::vec3 tangent{1, 0, 0};   // of length 1
    glm::vec3 director{0, 1, 0};  // of length 1, across the tangent
    float link = 0;               // where it is, in links from the first point
};

// Cubics from point to point (Hermite; the slope at a point is that of the parabola through it and
// its neighbours by length, so that unequal links do not overshoot), `steps` to a link, an even
// number. At the middle of a link the frame points as its director does, `directors` being how far
// that is from there (one a link), and turns evenly between, by less than half a turn a link.
// Without directors it does not twist, but in a closed curve, where it turns evenly until it meets
// itself. A closed curve ends `1 / steps` links before it has come round.
std::vector<WirePoint> wirePath(std::span<const glm::vec3> points,
                                std::span<const glm::vec3> directors, bool closed, int steps);

}  // namespace plait
