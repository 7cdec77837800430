// What a run is made of, and how each part is taken away or put to its next cheaper form. All of it
// is read off the run: sets, forces, the solver's options, the mesh, the knobs that count things.
#pragma once

#include "demos/runs/settings.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace plait {

struct Ingredient {
    std::string part;    // the set, the force or the option that it is about
    std::string change;  // "left out", "without friction", "30 for 60"
    std::function<void(Run&)> take;

    std::string name() const { return part + ": " + change; }
};

// In the order in which they can be taken together: what builds the scene anew comes first.
std::vector<Ingredient> ingredientsOf(const Run& run);

// The run without these.
Run without(Run run, std::span<const Ingredient> taken);

}  // namespace plait
