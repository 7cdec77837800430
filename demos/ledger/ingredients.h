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

// Whether it, or all of its part, is among them (SceneEntry::essentials).
bool isEssential(const Ingredient& ingredient, const std::vector<std::string>& essentials);

// Those among them that are settings of the solver, once put to half of what they are and once to
// three quarters: nothing of the scene is left out. Not what it says is essential.
std::vector<Ingredient> cheaperSettings(const Run& run);

// The same run, whose sets are each evaluated as often as before by an importance of its own.
// Where no whole number is that, as it was.
Run bySet(Run run);

// The run without these.
Run without(Run run, std::span<const Ingredient> taken);

}  // namespace plait
