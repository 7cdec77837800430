// Metrics that many scenes share, measured by core/measure alone: independent of the solver.
#pragma once

#include "../metric.h"

#include <plait/world.h>

#include <string>
#include <vector>

namespace plait {

// The band of a metric; {} has no bounds.
struct Band {
    double low = -infinity, high = infinity;
    double from = 0;  // s
};

// In %: the greatest extension of any link (two vertices each), or edge of `range`; and what 99 %
// of them do not exceed, either way. The world is read now and not kept, here and below.
Metric greatestStrain(const World& world, const std::vector<int>& links, Band band);
Metric commonStrain(const World& world, const std::vector<int>& links, Band band);
Metric greatestStrain(const World& world, Range range, Band band);
Metric commonStrain(const World& world, Range range, Band band);

// In degrees: by how much neighbouring facets of `range` are turned against each other more than as
// it is made, in the mean.
Metric folds(const World& world, Range range, Band band);

// Pairs of an edge, of a sheet or a curve, and a triangle of `range` that go through each other.
Metric selfIntersections(const World& world, Range range, Band band);

// In mm, at rest: of the edges that have come apart.
Metric tornLength(const World& world, Band band);

// What contacts could not hold since the frame before: 0, a scene's whole budget for failures.
Metric contactFailures();

// Vertices of `range` that are in a body, all of whose triangles together are closed.
Metric insideOf(const World& world, Range range, Range body, Band band);

// In mm: the least distance within and between the sheets of `range`; `within` (mm) if it is
// larger.
Metric leastGap(const World& world, Range range, double within, Band band);

// In % of `scale` (J): kinetic energy and that of gravity g, less what the world starts with.
Metric energyGain(const World& world, const Vec<double>& g, double scale, Band band);

// In m: y of a vertex, and its z.
Metric height(const std::string& name, int vertex, Band band);
Metric sway(const std::string& name, int vertex, Band band);
Metric lowestHeight(Band band);

}  // namespace plait
