// Woven cloth: threads that do not stretch, each solved whole, and a bias that gives way.
#pragma once

#include <plait/world.h>

#include <functional>
#include <string>

namespace plait {

// A gather holds only against extension: cloth that folds finer than its mesh.
enum class Thread { warp, weft, gather, bias, none };

// The thread that an edge lies on, by its vertices, counted from the cloth's first.
using ThreadOf = std::function<Thread(int a, int b)>;

// Of a grid with so many columns (shapes.h).
ThreadOf gridThreads(int columns);

// Adds the sets `mending` (of threads and gathers, to this part of their length; 0: none), `warp`,
// `weft`, `gathers` where there are any and `bias`, their names led by `name`. Shear stiffness in
// N/m. Returns warp, weft and gathers, two vertices a link.
std::vector<int> weave(World& world, Range cloth, const ThreadOf& threadOf, double shearStiffness,
                       const std::string& name = "", double mending = 0);

}  // namespace plait
