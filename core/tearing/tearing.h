// When sheets tear. README.md tells how it is done.
#pragma once

#include "../membranes/membrane.h"
#include "../world.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace plait {

// When it is asked whether something tears (V) [BR5].
enum class Tears { never, perFrame, perSubstep };

struct Tearing {
    std::string name = "tearing";
    Range cloth{};  // as World::add gave it, spare vertices and all: each copy is one of these
    // Pa: the greatest principal force on an area at rest that is borne where there is no tear.
    double strength = std::numeric_limits<double>::infinity();
    // J/m^2 of torn section, length times thickness at rest; 0: a tear runs on by strength alone.
    double toughness = 0;
    // Times what it costs, beyond which the end of a tear splits in two; two need 2 at least.
    double branching = std::numeric_limits<double>::infinity();
    // What multiplies both at a place of the rest shape (m); none: 1 (M 8) [AT17].
    std::function<double(const Vec<double>& rest)> map{};
    double scatter = 0;  // of the strength from vertex to vertex, in parts of it, 0 to below 1
    std::uint64_t seed = 1;
    Tears asked = Tears::perSubstep;
    // Where the tip of a needle is (m) at a time (s): what it pierces tears; none: there is none.
    std::function<Vec<double>(double t)> needle{};
};

// Adds a membrane to a world whose rubber, all of it of that cloth, may tear. What is pinned never
// comes apart. Throws std::invalid_argument, naming the tearing, for cloth without spare vertices,
// triangles that are not among its own, and numbers out of range, and what holdMembrane does.
void holdTearing(World& world, Membrane membrane, Tearing tearing, SetOptions options);

}  // namespace plait
