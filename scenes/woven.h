// Woven cloth: threads that do not stretch, each solved whole, and a bias that gives way.
#pragma once

#include "world.h"

#include <functional>
#include <string>

namespace plait {

enum class Thread { warp, weft, bias, none };

// The thread that an edge lies on, by its vertices, counted from the cloth's first.
using ThreadOf = std::function<Thread(int a, int b)>;

// Of a grid with so many columns (shapes.h).
ThreadOf gridThreads(int columns);

// Adds the sets `mending` (of warp and weft, to this part of their length; 0: none), `warp`, `weft`
// and `bias`, in this order, their names led by `name`. Shear stiffness in N/m. Returns warp and
// weft, two vertices a link.
std::vector<int> weave(World& world, Range cloth, const ThreadOf& threadOf, double shearStiffness,
                       const std::string& name = "", double mending = 0);

}  // namespace plait
