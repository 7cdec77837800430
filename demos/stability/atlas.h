// The failure atlas: a map worked out, as files, and held to what is stored.
#pragma once

#include "map.h"
#include "render/charts/chart.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plait {

struct Atlas {
    std::vector<double> x, y;                // of the cells
    std::vector<std::vector<int>> outcomes;  // by panel, x.size() * y.size(), first row at y[0]
    std::vector<Boundary> boundaries;        // by panel, then by x
};

// `cells` along each axis, on `jobs` threads. Throws Interrupted: what is done by then is in the
// file `done`, from where the next one goes on that is asked for as many cells of the same map.
Atlas workOut(const StabilityMap& map, int cells, int jobs, bool quiet,
              const std::filesystem::path& done);

// Some of the boundaries: of these panels (all where there are none) at the first `most` of x.
std::vector<Boundary> traceBoundaries(const StabilityMap& map,
                                      const std::vector<std::string>& panels, std::size_t most);

// As large as a map's panels want it, its charts still to come.
Figure emptyFigure(const StabilityMap& map);

// Into `folder`: cells.csv, boundaries.csv, chart.svg, chart.png and index.html.
void writeAtlas(const StabilityMap& map, const Atlas& atlas, const std::filesystem::path& folder,
                const std::string& command);

// The boundaries beside theory's, as lines.
std::string boundaryText(const StabilityMap& map, std::span<const Boundary> boundaries);

}  // namespace plait
