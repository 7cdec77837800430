// A hand that takes hold of matter while it moves, carries it about and lets go (M 2.4, 3.1.3)
// [AT1].
#pragma once

#include "../contacts/solids/placement.h"
#include "../world.h"

#include <limits>

namespace plait {

// Where a vertex is in the hand when it is taken, there it stays in the hand. A hand has no mass:
// it gives what it takes, and what is pinned it leaves alone. Seconds; `hand` is asked at both ends
// of a base step, and goes straight and steadily between, as pins do.
struct Grip {
    std::vector<int> vertices;
    Posing hand;
    double from = 0;  // it takes hold at the end of the first substep that ends here or later
    double to = std::numeric_limits<double>::infinity();  // and lets go likewise
};

// As a set of the world. Throws std::invalid_argument for no hand, times that are not in order, or
// a vertex that is not there or is named twice.
void addGrip(World& world, const Grip& grip, SetOptions options = {.name = "grip"});

}  // namespace plait
