#include "ingredients.h"

#include "demos/tools/words.h"

#include <plait/force.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace plait {
namespace {

using Ingredients = std::vector<Ingredient>;

// The scene built anew, solved as the run is.
void rebuild(Run& run, Quality quality, const std::string& knob = "", double value = 0) {
    Knobs knobs = Knobs::defaults(run.entry->knobs, quality);
    knobs.seed = run.knobs.seed;
    knobs.texts = run.knobs.texts;
    for (const auto& [name, number] : run.knobs.numbers)
        if (number != Knobs::defaults(run.entry->knobs, run.knobs.quality).number(name))
            knobs.numbers[name] = number;
    if (!knob.empty()) knobs.numbers[knob] = value;
    Scene scene = run.entry->build(knobs);
    scene.options = run.scene.options;
    scene.seconds = run.scene.seconds;
    run.scene = std::move(scene);
}

void addMesh(Ingredients& all, const Run& run) {
    if (run.knobs.quality == Quality::draft) return;
    const auto coarser = static_cast<Quality>(static_cast<int>(run.knobs.quality) - 1);
    all.push_back({"mesh", "that of " + qualityNames()[static_cast<std::size_t>(coarser)],
                   [=](Run& r) { rebuild(r, coarser); }});
}

// A knob that is half as large, and with it the scene: it counts something.
void addCounts(Ingredients& all, const Run& run) {
    for (const Knob& knob : run.entry->knobs) {
        if (!knob.isNumber()) continue;
        const double value = run.knobs.number(knob.name);
        const double half = std::max(knob.low, std::floor(value / 2));
        if (value != std::floor(value) || half >= value) continue;
        const auto take = [quality = run.knobs.quality, name = knob.name, half](Run& r) {
            rebuild(r, quality, name, half);
        };
        Run fewer = run;
        take(fewer);
        if (fewer.scene.world.start.size() < run.scene.world.start.size())
            all.push_back({knob.name, text(half) + " for " + text(value), take});
    }
}

// One of World::sets or World::forces: `recipeIn` finds its recipe.
template <class Recipe, class Find>
void addRecipe(Ingredients& all, const std::string& part, const Recipe& recipe,
               const Find& recipeIn) {
    all.push_back({part, "left out", [=](Run& r) { recipeIn(r) = {}; }});
    for (std::size_t f = 0; f < recipe.lesser.size(); ++f)
        all.push_back({part, recipe.lesser[f].less, [=](Run& r) {
                           auto& there = recipeIn(r);
                           // Copied first: it is a part of what it replaces.
                           if (f < there.lesser.size()) there = Recipe(there.lesser[f]);
                       }});
}

// "contacts", "contacts 2": a name of its own for each.
std::string distinct(std::map<std::string, int>& seen, const std::string& name) {
    const int n = ++seen[name];
    return n == 1 ? name : name + " " + std::to_string(n);
}

bool countsByImportance(const Run& run, const World::Set& set) {
    const ScheduleOptions& schedule = run.scene.options.schedule;
    const bool overruled = set.contact ? schedule.collisionPasses > 0 : schedule.iterations > 0;
    const double aSubstep = set.options.importance * 24 / run.frameRate() / schedule.substeps;
    return !overruled && set.options.secondaryInterval == 0 && aSubstep > 1;
}

void addSets(Ingredients& all, const Run& run) {
    std::map<std::string, int> seen;
    const std::vector<World::Set>& sets = run.scene.world.sets;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const std::string part = distinct(seen, sets[s].options.name);
        addRecipe(all, part, sets[s].recipe,
                  [s](Run& r) -> auto& { return r.scene.world.sets.at(s).recipe; });
        if (sets[s].options.damping > 0)
            all.push_back({part, "without damping",
                           [s](Run& r) { r.scene.world.sets.at(s).options.damping = 0; }});
        if (!countsByImportance(run, sets[s])) continue;
        const int half = std::max(1, sets[s].options.importance / 2);
        all.push_back({part,
                       "importance " + std::to_string(half) + " for " +
                           std::to_string(sets[s].options.importance),
                       [=](Run& r) { r.scene.world.sets.at(s).options.importance = half; }});
    }
}

void addForces(Ingredients& all, const Run& run) {
    std::map<std::string, int> seen;
    const World& world = run.scene.world;
    for (std::size_t f = 0; f < world.forces.size(); ++f) {
        const auto force = world.forces[f].make<double>(world, run.scene.options.kernels);
        addRecipe(all, distinct(seen, force->name()), world.forces[f],
                  [f](Run& r) -> auto& { return r.scene.world.forces.at(f); });
    }
}

void addCounted(Ingredients& all, const std::string& part, int value,
                int ScheduleOptions::* place) {
    if (value < 2) return;
    const int half = value / 2;
    all.push_back({part, std::to_string(half) + " for " + std::to_string(value),
                   [=](Run& r) { r.scene.options.schedule.*place = half; }});
}

// An option that is not what costs least.
template <class T>
void addOption(Ingredients& all, const std::string& part, const std::string& change, const Run& run,
               T SolverOptions::* place, T least) {
    if (run.scene.options.*place == least) return;
    all.push_back({part, change, [=](Run& r) { r.scene.options.*place = least; }});
}

void addOptions(Ingredients& all, const Run& run) {
    const ScheduleOptions& schedule = run.scene.options.schedule;
    addCounted(all, "substeps", schedule.substeps, &ScheduleOptions::substeps);
    addCounted(all, "iterations", schedule.iterations, &ScheduleOptions::iterations);
    addCounted(all, "passes", schedule.collisionPasses, &ScheduleOptions::collisionPasses);
    addOption(all, "integrator", "first order", run, &SolverOptions::integrator, Integrator::first);
    addOption(all, "direction", "one way", run, &SolverOptions::sweeps, Sweeps::oneWay);
    addOption(all, "base steps", "one", run, &SolverOptions::baseSteps, 1);
    addOption(all, "chebyshev", "off", run, &SolverOptions::chebyshev, 0.0);
    addOption(all, "smoothing", "off", run, &SolverOptions::smoothing, 0);
    addOption(all, "damping", "off", run, &SolverOptions::damping, 0.0);
    addOption(all, "limit on acceleration", "off", run, &SolverOptions::limitAcceleration, false);
    addOption(all, "fall-back to first order", "off", run, &SolverOptions::maxAcceleration,
              std::numeric_limits<double>::infinity());
    if (run.precision == Precision::full)
        all.push_back({"precision", "float", [](Run& r) { r.precision = Precision::single; }});
    if (run.scene.lead > 0) all.push_back({"lead", "none", [](Run& r) { r.scene.lead = 0; }});
}

// What has no recipe any more is gone.
void sweepOut(World& world) {
    int clusters = -1, kept = 0;
    for (std::size_t s = 0; s < world.sets.size(); ++s) {
        if (!world.sets[s].recipe.single) continue;
        if (static_cast<int>(s) == world.clusters) clusters = kept;
        ++kept;
    }
    world.clusters = clusters;
    std::erase_if(world.sets, [](const World::Set& set) { return !set.recipe.single; });
    std::erase_if(world.forces, [](const Recipe<Force>& force) { return !force.single; });
}

}  // namespace

std::vector<Ingredient> ingredientsOf(const Run& run) {
    Ingredients all;
    addMesh(all, run);
    addCounts(all, run);
    addSets(all, run);
    addForces(all, run);
    addOptions(all, run);
    return all;
}

Run without(Run run, std::span<const Ingredient> taken) {
    for (const Ingredient& ingredient : taken) ingredient.take(run);
    sweepOut(run.scene.world);
    return run;
}

}  // namespace plait
