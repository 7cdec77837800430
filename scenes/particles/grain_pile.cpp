// Grains run out of a funnel's mouth onto a table and stand there as a cone.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "particles.h"
#include "sand.h"

#include <plait/numbers/elementary.h>
#include <plait/sources/source.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double mouth = 0.22;  // m
constexpr double pours = 5;     // s

struct Cone {
    double height, slope;  // m, degrees
};

// By volume, seen from the side: the height is that of the highest grain of a hundred; the slope
// that of a cone whose surface lies as far out as the grains' do, ring by ring.
Cone coneOf(const Snapshot& at, Range grains, double radius) {
    std::vector<std::array<double, 2>> tops;  // by ring
    constexpr int rings = 24;
    const double width = 0.004 + radius;
    tops.resize(rings, {0, 0});
    for (int v = grains.first; v < grains.last; ++v) {
        const Vec<double>& p = at.positions[v];
        if (!at.isHere(v) || at.velocities[v].y < -0.3) continue;
        const auto ring = static_cast<std::size_t>(std::hypot(p.x, p.z) / width);
        if (ring < tops.size())
            tops[ring] = {(static_cast<double>(ring) + 0.5) * width, std::max(tops[ring][1], p.y)};
    }
    // A straight line through the flank: from two rings off the top to where it is two grains high.
    double n = 0, r = 0, y = 0, rr = 0, ry = 0, height = 0;
    for (std::size_t i = 0; i < tops.size(); ++i) {
        height = std::max(height, tops[i][1]);
        if (i < 2 || tops[i][1] < 4 * radius) continue;
        ++n, r += tops[i][0], y += tops[i][1];
        rr += tops[i][0] * tops[i][0], ry += tops[i][0] * tops[i][1];
    }
    const double fall = n < 3 ? 0 : -(n * ry - r * y) / (n * rr - r * r);
    return {height, 180 / pi * std::atan(fall)};
}

std::vector<Metric> metricsOf(const Grains& sand) {
    const auto fastest = [sand](const Snapshot& at) {
        double most = 0;
        for (int v = sand.vertices.first; v < sand.vertices.last; ++v)
            most = std::max(most, length(at.velocities[v]));
        return 1000 * most;
    };
    const auto cone = [sand](const Snapshot& at) { return coneOf(at, sand.vertices, sand.radius); };
    return {countThere("grains", 0, sand.vertices.size()),
            {.name = "height",
             .unit = "mm",
             .measure = [cone](const Snapshot& at) { return 1000 * cone(at).height; },
             .low = 0,
             .high = 1000 * mouth},
            {.name = "slope",
             .unit = "degrees",
             .measure = [cone](const Snapshot& at) { return cone(at).slope; },
             .low = 25,
             .high = 46,
             .from = 6.5,
             .caption = true},
            {.name = "fastest", .unit = "mm/s", .measure = fastest, .low = 0, .high = 3000},
            inTheTable(sand),
            contactFailures()};
}

}  // namespace

Scene grainPile(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double radius = knobs.byQuality(5e-3, 3.4e-3, 2.4e-3);
    // Four abreast, each a little higher than the last, so that none comes in a ring.
    std::vector<Vec<double>> nozzle;
    for (int i = 0; i < 4; ++i)
        nozzle.push_back({2.2 * radius * cosine(pi / 2 * i), mouth + 0.6 * radius * i,
                          2.2 * radius * sine(pi / 2 * i)});
    const double speed = 1.2, every = 2.5 * radius / speed;
    const int volleys = static_cast<int>(pours / every);
    const Range spare =
        world.add({SimplicialComplex(0), {}}, {.density = sandMass(radius), .spare = 4 * volleys});
    Grains sand = sandOf(spare, radius, knobs.number("friction"));
    for (int i = 0; i < sand.vertices.size(); ++i)
        sand.radii.push_back(radius * (0.8 + 0.4 * numberOf(i, knobs.seed, 5)));
    for (Vec<double>& x : world.start) x = {0, mouth + 0.05, 0};
    world.rest = world.start;
    world.act<Source>(SourceOptions{.name = "funnel",
                                    .spare = sand.vertices,
                                    .nozzle = nozzle,
                                    .velocity = {0, -speed, 0},
                                    .every = every,
                                    .until = (volleys - 0.5) * every,
                                    .scatter = 0.5 * radius,
                                    .scatterVelocity = 0.1,
                                    .seed = knobs.seed});
    addSand(scene, sand);
    scene.seconds = 7;

    scene.metrics = metricsOf(sand);
    char fact[120];
    std::snprintf(fact, sizeof fact, "%d grains of %.1f mm", sand.vertices.size(), 2e3 * radius);
    scene.facts = {fact};
    scene.view = viewOf({sand.vertices}, {0, 0.07, 0}, 0.3, Material::matte, {0.4, 0.45, 2.2});
    scene.view.looks[0].point = [radii = sand.radii, seed = knobs.seed](std::int32_t id, double) {
        const double pale = numberOf(id, seed, 6);
        return PointLook{radii[static_cast<std::size_t>(id)],
                         {0.5 + 0.3 * pale, 0.27 + 0.25 * pale, 0.08 + 0.14 * pale}};
    };
    scene.view.groundHeight = 0;
    return scene;
}

}  // namespace plait
