// What of a wire stands about its own points: the turn beside, and the coil around.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace plait {

// A point of one of several wires.
struct WireStation {
    glm::vec3 place{0};    // m
    glm::vec3 tangent{0};  // of length 1, as the next
    glm::vec3 director{0};
    float length = 0;  // m, along its wire
    float round = 0;   // m, of its whole wire if that is closed
    int wire = 0;
};

// From a point across its wire to the nearest of the other turns, and to the nearest on the side
// away from that one, m; zero where there is none within reach. Along a wire the first stays on its
// side. Where the way along the wire is not half as far again as straight across, it is the same
// turn.
using Beside = std::array<glm::vec3, 2>;
std::vector<Beside> besides(std::span<const WireStation> stations, float reach);

// Part of the light from around that arrives at a surface across the wire: of those that face along
// the director, across it, and away from both (an ambient cube, without its ends).
struct Openness {
    std::array<float, 4> sides{1, 1, 1, 1};

    // x along the director, y across; what is left of the normal's length is taken for their mean.
    float at(float x, float y) const;
};

Openness mix(const Openness& a, const Openness& b, float s);

// Of each point, from what lies farther away than some three widths: the wires become a smoke of
// the same mean shadow, `width` (m) wide, through which rays are cast, some sixty widths far, from
// a point every twelve; between these it is blended.
std::vector<Openness> opennessOf(std::span<const WireStation> stations, float width);

}  // namespace plait
