// The scenes that a test may take through many runs: all but the dress, whose frames take a second
// and which has tests of its own.
#pragma once

#include "scene.h"

#include <vector>

namespace plait::test {

inline std::vector<SceneEntry> smallScenes() {
    std::vector<SceneEntry> small;
    for (const SceneEntry& entry : scenes())
        if (entry.name != "dress") small.push_back(entry);
    return small;
}

}  // namespace plait::test
