// Vertices at one place.
#pragma once

#include "../complex/shapes.h"

#include <array>
#include <vector>

namespace plait {

struct Weld {
    std::vector<int> into;                  // by vertex: the lowest of those at its place
    std::vector<std::array<int, 2>> apart;  // pairs that nearly are at one place, the lower first
};

// Only vertices on open edges are welded with each other, which seams of exporters leave: within a
// ten-thousandth of the mesh's size and a twentieth of its mean edge; nearly at one place are those
// within a tenth of that edge. And the ends of an edge that has no length, to a millionth of the
// size.
Weld weldOf(const Shape& mesh);

}  // namespace plait
