#include "measures.h"

#include <plait/measure/energy.h>
#include <plait/measure/strain.h>
#include <plait/measure/surfaces/gap.h>
#include <plait/measure/surfaces/geometry.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/measure/surfaces/penetration.h>
#include <plait/numbers/arctangent.h>
#include <plait/stencils.h>

#include <cmath>
#include <memory>
#include <utility>

namespace plait {
namespace {

Metric metricOf(const std::string& name, const std::string& unit, Band band,
                std::function<double(const Snapshot&)> measure) {
    return {name, unit, std::move(measure), band.low, band.high, band.from, false};
}

// Strain of links, two vertices each, ready to be measured.
std::function<StrainSummary(const Snapshot&)> strainOf(const World& world,
                                                       const std::vector<int>& links) {
    std::vector<std::array<int, 2>> edges;
    std::vector<double> rest;
    for (std::size_t i = 0; i < links.size(); i += 2) {
        edges.push_back({links[i], links[i + 1]});
        rest.push_back(length(world.rest[static_cast<std::size_t>(links[i + 1])] -
                              world.rest[static_cast<std::size_t>(links[i])]));
    }
    return [=](const Snapshot& at) { return summarizeStrain(at.positions, edges, rest); };
}

// rad, between the facets beside an edge.
double dihedralAngle(const std::vector<Vec<double>>& x, const std::array<int, 4>& hinge) {
    const auto corner = [&](std::size_t i) { return x[static_cast<std::size_t>(hinge[i])]; };
    const Vec<double> edge = corner(1) - corner(0);
    const Vec<double> left = cross(edge, corner(2) - corner(0)),
                      right = cross(corner(3) - corner(0), edge);
    return arctangent2(length(cross(left, right)), dot(left, right));
}

}  // namespace

Metric greatestStrain(const World& world, const std::vector<int>& links, Band band) {
    const auto strain = strainOf(world, links);
    Metric metric =
        metricOf("strain", "%", band, [=](const Snapshot& at) { return 100 * strain(at).maximum; });
    metric.caption = true;
    return metric;
}

Metric commonStrain(const World& world, const std::vector<int>& links, Band band) {
    const auto strain = strainOf(world, links);
    return metricOf("strain99", "%", band,
                    [=](const Snapshot& at) { return 100 * strain(at).percentile99; });
}

Metric greatestStrain(const World& world, Range range, Band band) {
    return greatestStrain(world, edgeStencils(world.complex, range), band);
}

Metric commonStrain(const World& world, Range range, Band band) {
    return commonStrain(world, edgeStencils(world.complex, range), band);
}

Metric folds(const World& world, Range range, Band band) {
    std::vector<std::pair<std::array<int, 4>, double>> hinges;  // and angles at rest
    const std::vector<int> stencils = hingeStencils(world.complex, range);
    for (std::size_t i = 0; i < stencils.size(); i += 4) {
        const std::array<int, 4> hinge{stencils[i], stencils[i + 1], stencils[i + 2],
                                       stencils[i + 3]};
        hinges.emplace_back(hinge, dihedralAngle(world.rest, hinge));
    }
    return metricOf("folds", "degrees", band, [=](const Snapshot& at) {
        double sum = 0;
        for (const auto& [hinge, rest] : hinges)
            sum += std::fabs(dihedralAngle(at.positions, hinge) - rest);
        return 180 / pi * sum / static_cast<double>(hinges.size());
    });
}

namespace {

struct Mesh {
    std::vector<std::array<int, 2>> edges;
    std::vector<std::array<int, 3>> triangles;
};

Mesh meshOf(const SimplicialComplex& complex, Range range) {
    const auto inside = [&](int v) { return v >= range.first && v < range.last; };
    Mesh mesh;
    for (int i = 0; i < complex.count(1); ++i)
        if (const auto edge = complex.edge(i); inside(edge[0]) && inside(edge[1]))
            mesh.edges.push_back(edge);
    for (int i = 0; i < complex.count(2); ++i)
        if (const auto triangle = complex.triangle(i); inside(triangle[0]))
            mesh.triangles.push_back(triangle);
    return mesh;
}

}  // namespace

Metric selfIntersections(const World& world, Range range, Band band) {
    return metricOf("crossings", "", band,
                    [range, whole = meshOf(world.complex, range),
                     uncut = std::make_shared<const Cuts>(world.uncut())](const Snapshot& at) {
                        const auto count = [&](const Mesh& mesh) {
                            return static_cast<double>(
                                countIntersections(at.positions, mesh.edges, mesh.triangles));
                        };
                        if (at.cuts.empty()) return count(whole);
                        Cuts cuts = *uncut;
                        for (const int entry : at.cuts) cuts.take(entry);
                        return count(meshOf(cuts.torn(), range));
                    });
}

Metric tornLength(const World& world, Band band) {
    std::vector<double> lengths;
    for (int i = 0; i < world.complex.count(1); ++i) {
        const auto ends = world.complex.vertices(1, i);
        lengths.push_back(length(world.rest[ends[1]] - world.rest[ends[0]]));
    }
    return metricOf("torn", "mm", band, [=](const Snapshot& at) {
        double sum = 0;
        for (const int entry : at.cuts) sum += entry < 0 ? 0 : lengths[entry];
        return 1000 * sum;
    });
}

Metric contactFailures() {
    return metricOf("failures", "", {0, 0},
                    [](const Snapshot& at) { return static_cast<double>(at.failures); });
}

Metric insideOf(const World& world, Range range, Range body, Band band) {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < world.complex.count(2); ++i)
        if (const auto [a, b, c] = world.complex.triangle(i); a >= body.first && a < body.last)
            triangles.push_back({a - body.first, b - body.first, c - body.first});
    return metricOf("inside", "", band, [=](const Snapshot& at) {
        const std::span all(at.positions);
        return static_cast<double>(findInside(all.subspan(range.first, range.size()),
                                              all.subspan(body.first, body.size()), triangles)
                                       .size());
    });
}

Metric leastGap(const World& world, Range range, double within, Band band) {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < world.complex.count(2); ++i)
        if (const auto triangle = world.complex.triangle(i);
            triangle[0] >= range.first && triangle[0] < range.last)
            triangles.push_back(triangle);
    return metricOf("gap", "mm", band, [=](const Snapshot& at) {
        return 1000 * leastGap(at.positions, triangles, within / 1000);
    });
}

Metric energyGain(const World& world, const Vec<double>& g, double scale, Band band) {
    std::vector<double> mass = world.mass;
    for (std::size_t i = 0; i < mass.size(); ++i)
        if (world.pinned[i]) mass[i] = 0;
    const auto energy = [=](const std::vector<Vec<double>>& x, const std::vector<Vec<double>>& v) {
        return kineticEnergy(mass, v) + gravitationalEnergy(mass, x, g);
    };
    const double start = energy(world.start, world.velocity);
    return metricOf("energy", "%", band, [=](const Snapshot& at) {
        return 100 * (energy(at.positions, at.velocities) - start) / scale;
    });
}

Metric height(const std::string& name, int vertex, Band band) {
    return metricOf(name, "m", band, [=](const Snapshot& at) {
        return at.positions[static_cast<std::size_t>(vertex)].y;
    });
}

Metric sway(const std::string& name, int vertex, Band band) {
    return metricOf(name, "m", band, [=](const Snapshot& at) {
        return at.positions[static_cast<std::size_t>(vertex)].z;
    });
}

Metric lowestHeight(Band band) {
    return metricOf("lowest", "m", band,
                    [](const Snapshot& at) { return lowestPoint(at.positions, {0, 1, 0}).y; });
}

}  // namespace plait
