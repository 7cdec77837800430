// A scene: a world, how it is best taken through time, how it should be looked at, what is
// measured, and the one thing that it teaches. Plain numbers and no pixels; this folder knows the
// core and nothing else.
#pragma once

#include "knob.h"
#include "metric.h"
#include "view.h"

#include <plait/solver_options.h>
#include <plait/world.h>

#include <span>
#include <string>
#include <vector>

namespace plait {

struct Scene {
    World world;
    SolverOptions options;
    double seconds = 10;
    double lead = 0;  // s that pass before the first frame: what falls, settles
    View view;
    std::vector<Metric> metrics;
    std::vector<std::string> facts = {};  // what closed forms say of it: lines of `describe`
};

struct SceneEntry {
    std::string name;
    std::string title;   // of the caption strip
    std::string lesson;  // one sentence
    std::vector<std::string> ingredients;
    std::vector<std::string> omissions;  // what it leaves out, and why
    // Parts of the world (sets, forces, options; "contacts", or "contacts: without friction")
    // without which it would be another scene: that no metric needs them is no reason to leave them
    // out (plait ablate), or to have less of them (plait tune).
    std::vector<std::string> essentials = {};
    bool demo = false;  // rendered by demos/run without a name
    std::vector<Knob> knobs = {};
    Scene (*build)(const Knobs&);
};

// Every scene there is, by name.
std::span<const SceneEntry> scenes();

// Throws std::invalid_argument for a name that is not there.
const SceneEntry& findScene(const std::string& name);

// The scene with its defaults.
Scene build(const SceneEntry& entry, Quality quality = Quality::preview);

}  // namespace plait
