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
void addKnobs(Ingredients& all, const Run& run) {
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

bool overruled(const ScheduleOptions& schedule, const World::Set& set) {
    return (set.contact ? schedule.collisionPasses : schedule.iterations) > 0;
}

// Evaluations in a substep of one of importance 1.
double partOfImportance(const Run& run) {
    return 24 / run.frameRate() / run.scene.options.schedule.substeps;
}

bool countsByImportance(const Run& run, const World::Set& set) {
    return !overruled(run.scene.options.schedule, set) && set.options.secondaryInterval == 0 &&
           set.options.importance * partOfImportance(run) > 1;
}

int partOf(int value, double part) {
    return std::clamp(static_cast<int>(part * value), 1, value - 1);
}

void addImportance(Ingredients& all, const Run& run, std::size_t s, const std::string& part,
                   double by) {
    const World::Set& set = run.scene.world.sets[s];
    if (!countsByImportance(run, set)) return;
    const int less = partOf(set.options.importance, by);
    all.push_back(
        {part,
         "importance " + std::to_string(less) + " for " + std::to_string(set.options.importance),
         [=](Run& r) { r.scene.world.sets.at(s).options.importance = less; }});
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
        addImportance(all, run, s, part, 0.5);
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

void addCounted(Ingredients& all, const std::string& part, int value, int ScheduleOptions::* place,
                double by) {
    if (value < 2) return;
    const int less = partOf(value, by);
    all.push_back({part, std::to_string(less) + " for " + std::to_string(value),
                   [=](Run& r) { r.scene.options.schedule.*place = less; }});
}

void addCounts(Ingredients& all, const ScheduleOptions& schedule, double by) {
    addCounted(all, "substeps", schedule.substeps, &ScheduleOptions::substeps, by);
    addCounted(all, "iterations", schedule.iterations, &ScheduleOptions::iterations, by);
    addCounted(all, "passes", schedule.collisionPasses, &ScheduleOptions::collisionPasses, by);
}

// An option that is not what costs least.
template <class T>
void addOption(Ingredients& all, const std::string& part, const std::string& change, const Run& run,
               T SolverOptions::* place, T least) {
    if (run.scene.options.*place == least) return;
    all.push_back({part, change, [=](Run& r) { r.scene.options.*place = least; }});
}

// What costs, and is no part of what happens.
void addCosts(Ingredients& all, const Run& run) {
    addOption(all, "integrator", "first order", run, &SolverOptions::integrator, Integrator::first);
    addOption(all, "direction", "one way", run, &SolverOptions::sweeps, Sweeps::oneWay);
    addOption(all, "base steps", "one", run, &SolverOptions::baseSteps, 1);
    addOption(all, "chebyshev", "off", run, &SolverOptions::chebyshev, 0.0);
    addOption(all, "smoothing", "off", run, &SolverOptions::smoothing, 0);
    if (run.precision == Precision::full)
        all.push_back({"precision", "float", [](Run& r) { r.precision = Precision::single; }});
}

void addOptions(Ingredients& all, const Run& run) {
    addCounts(all, run.scene.options.schedule, 0.5);
    addCosts(all, run);
    addOption(all, "damping", "off", run, &SolverOptions::damping, 0.0);
    addOption(all, "limit on acceleration", "off", run, &SolverOptions::limitAcceleration, false);
    addOption(all, "fall-back to first order", "off", run, &SolverOptions::maxAcceleration,
              std::numeric_limits<double>::infinity());
    if (run.scene.lead > 0) all.push_back({"lead", "none", [](Run& r) { r.scene.lead = 0; }});
}

}  // namespace

std::vector<Ingredient> ingredientsOf(const Run& run) {
    Ingredients all;
    addMesh(all, run);
    addKnobs(all, run);
    addSets(all, run);
    addForces(all, run);
    addOptions(all, run);
    return all;
}

std::vector<Ingredient> cheaperSettings(const Run& run) {
    Ingredients all;
    std::map<std::string, int> seen;
    const std::vector<World::Set>& sets = run.scene.world.sets;
    std::vector<std::string> names;
    for (const World::Set& set : sets) names.push_back(distinct(seen, set.options.name));
    for (const double by : {0.5, 0.75}) {
        addCounts(all, run.scene.options.schedule, by);
        for (std::size_t s = 0; s < sets.size(); ++s) addImportance(all, run, s, names[s], by);
    }
    addCosts(all, run);
    std::erase_if(all, [&](const Ingredient& i) { return isEssential(i, run.entry->essentials); });
    return all;
}

bool isEssential(const Ingredient& ingredient, const std::vector<std::string>& essentials) {
    return std::ranges::count(essentials, ingredient.part) +
               std::ranges::count(essentials, ingredient.name()) >
           0;
}

Run bySet(Run run) {
    ScheduleOptions& schedule = run.scene.options.schedule;
    const double part = partOfImportance(run);
    const auto importanceOf = [&](int evaluations) {
        const double importance = evaluations / part;
        const int whole = static_cast<int>(std::lround(importance));
        return std::fabs(importance - whole) < 1e-9 && whole <= 1000000 ? whole : 0;
    };
    const int sets = importanceOf(schedule.iterations),
              contacts = importanceOf(schedule.collisionPasses);
    for (World::Set& set : run.scene.world.sets)
        if (const int importance = set.contact ? contacts : sets; importance > 0)
            set.options.importance = importance;
    if (sets > 0) schedule.iterations = 0;
    if (contacts > 0) schedule.collisionPasses = 0;
    return run;
}

Run without(Run run, std::span<const Ingredient> taken) {
    for (const Ingredient& ingredient : taken) ingredient.take(run);
    run.scene.world.sweepOut();
    return run;
}

}  // namespace plait
