// The scenes that a test may take through many runs: all but those whose frames take a second, of
// which the dress has tests of its own, and the liquid's work is the dam's.
#pragma once

#include "scenes/scene.h"

#include <algorithm>
#include <vector>

namespace plait::test {

inline std::vector<SceneEntry> smallScenes() {
    std::vector<SceneEntry> small;
    for (const SceneEntry& entry : scenes())
        if (entry.name != "dress" && entry.name != "liquid") small.push_back(entry);
    return small;
}

// Contacts of matter with matter come and go: neither their work nor their memory is known ahead.
inline bool matterMeets(const Scene& scene) {
    return std::ranges::any_of(
        scene.world.sets, [](const World::Set& set) { return set.options.name == "contacts"; });
}

}  // namespace plait::test
