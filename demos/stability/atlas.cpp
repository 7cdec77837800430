#include "atlas.h"

#include "demos/runs/run_all.h"
#include "demos/tools/progress.h"

#include <algorithm>
#include <functional>

namespace plait {

Atlas workOut(const StabilityMap& map, int cells, int jobs, bool quiet) {
    Atlas atlas{valuesOf(map.x, cells), valuesOf(map.y, cells), {}, {}};
    const std::size_t columns = atlas.x.size(), xs = map.boundaryAt.size();
    atlas.outcomes.assign(map.panels.size(), std::vector<int>(columns * atlas.y.size()));
    atlas.boundaries.resize(map.panels.size() * xs);
    std::vector<std::function<void()>> tasks;
    for (std::size_t p = 0; p < map.panels.size(); ++p) {
        const StabilityPanel& panel = map.panels[p];
        for (std::size_t i = 0; i < xs; ++i)
            tasks.emplace_back([&, p, i] {
                atlas.boundaries[p * xs + i] = traceBoundary(map, panel, map.boundaryAt[i]);
            });
        for (std::size_t i = 0; i < atlas.outcomes[p].size(); ++i)
            tasks.emplace_back([&, p, i] {
                atlas.outcomes[p][i] =
                    static_cast<int>(panel.cell(atlas.x[i % columns], atlas.y[i / columns]));
            });
    }
    const int count = static_cast<int>(tasks.size());
    Progress progress("stability " + map.name, 0, count, quiet, "cells");
    runAll(count, jobs, 0, progress, [&](int i, int) { tasks[static_cast<std::size_t>(i)](); });
    return atlas;
}

std::vector<Boundary> traceBoundaries(const StabilityMap& map,
                                      const std::vector<std::string>& panels, std::size_t most) {
    std::vector<Boundary> boundaries;
    for (const StabilityPanel& panel : map.panels) {
        if (!panels.empty() && std::find(panels.begin(), panels.end(), panel.name) == panels.end())
            continue;
        for (std::size_t i = 0; i < std::min(most, map.boundaryAt.size()); ++i)
            boundaries.push_back(traceBoundary(map, panel, map.boundaryAt[i]));
    }
    return boundaries;
}

}  // namespace plait
