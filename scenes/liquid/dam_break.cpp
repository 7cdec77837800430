// A column of water, twice as high as it is wide, whose dam is gone from one moment to the next
// (Martin, Moyce, An experimental study of the collapse of liquid columns on a rigid horizontal
// plane, 1952).
#include "../parts/measures.h"
#include "../parts/views.h"
#include "liquid.h"

#include <plait/forces/gravity.h>
#include <plait/particles/liquid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace plait {
namespace {

constexpr double width = 1, filled = 2, depth = 1, tank = 5;  // m
constexpr double gravity = 9.81;                              // m/s^2
constexpr double opens = 0.75;                                // s

// Of columns 2.25 in wide: time in sqrt(width / 2 g), place of the front in widths. Their gate took
// a quarter of that unit to be out of the way.
const std::vector<std::array<double, 2>> front1952{{0.832, 1.217}, {1.219, 1.474}, {1.997, 2.292},
                                                   {2.547, 2.995}, {3.345, 4.134}, {4.034, 4.944}};

Collider wallAt(const Vec<double>& at, const Vec<double>& up, const Vec<double>& across) {
    Collider wall{.solid = Solid::plane(), .frame = {at, across, up}};
    wall.staticFriction = wall.dynamicFriction = 0;
    return wall;
}

// The dam is a wall that leaves faster than water falls.
std::vector<Collider> tankWithDam() {
    std::vector<Collider> walls{
        wallAt({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), wallAt({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
        wallAt({tank, 0, 0}, {-1, 0, 0}, {0, 1, 0}), wallAt({0, 0, 0}, {0, 0, 1}, {1, 0, 0}),
        wallAt({0, 0, depth}, {0, 0, -1}, {1, 0, 0})};
    Collider dam = wallAt({width, 0, 0}, {-1, 0, 0}, {0, 1, 0});
    dam.motion = [frame = dam.frame](double t) {
        Frame at = frame;
        at.origin.x += 100 * std::clamp((t - opens) / 0.1, 0.0, 1.0);
        return at;
    };
    walls.push_back(dam);
    return walls;
}

// A lattice, a little farther from walls than half a spacing, as settled water is, shaken by a
// thousandth so that it does not stay one.
Shape column(int across, double spacing) {
    const double margin = 0.62 * spacing, apart = (width - 2 * margin) / (across - 1);
    const double rise = 1.015 * spacing * spacing * spacing / (apart * apart);
    Shape shape;
    for (int k = 0; k < across; ++k)
        for (int j = 0; j < 2 * across; ++j)
            for (int i = 0; i < across; ++i) {
                const auto shaken = [&](int n, int by) {
                    return n + 1e-3 * ((7 * i + 13 * j + by * k) % 3 - 1);
                };
                shape.positions.push_back({margin + shaken(i, 5) * apart,
                                           margin + shaken(j, 11) * rise,
                                           margin + shaken(k, 17) * apart});
            }
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()));
    return shape;
}

// In widths of the column: the end of the last slice that is joined to the rest, of slices a
// spacing long and half a layer thick.
double frontOf(const std::vector<Vec<double>>& x, double spacing) {
    std::vector<int> slices(static_cast<std::size_t>(tank / spacing) + 2);
    for (const Vec<double>& p : x)
        ++slices[static_cast<std::size_t>(std::clamp(p.x, 0.0, tank) / spacing)];
    std::size_t front = 0;
    while (2 * slices[front] * spacing >= depth) ++front;
    return std::min(static_cast<double>(front) * spacing / width, tank / width);
}

std::vector<Metric> metricsOf(const Liquid& liquid) {
    const auto compression = [=](bool largest) {
        return [=](const Snapshot& at) {
            double most = 0, sum = 0;
            const std::vector<double> ratios = densityRatios(liquid, at.positions, at.time);
            for (const double ratio : ratios) {
                most = std::max(most, ratio - 1);
                sum += std::max(ratio - 1, 0.0);
            }
            return 100 * (largest ? most : sum / static_cast<double>(ratios.size()));
        };
    };
    const auto outside = [](const Snapshot& at) {
        return static_cast<double>(std::ranges::count_if(at.positions, [](const Vec<double>& p) {
            return p.x < 0 || p.x > tank || p.y < 0 || p.z < 0 || p.z > depth;
        }));
    };
    const auto reducedTime = [](const Snapshot& at) {
        return std::max(at.time - opens, 0.0) / std::sqrt(width / (2 * gravity));
    };
    return {{.name = "reduced time", .unit = "", .measure = reducedTime},
            {.name = "front",
             .unit = "widths",
             .measure = [=](const Snapshot& at) { return frontOf(at.positions, liquid.spacing); },
             .low = 0.9,
             .high = tank / width,
             .caption = true},
            {.name = "largest compression",
             .unit = "%",
             .measure = compression(true),
             .low = 0,
             .high = 8,
             .from = opens - 0.2,
             .caption = true},
            {.name = "mean compression",
             .unit = "%",
             .measure = compression(false),
             .low = 0,
             .high = 0.8,
             .from = opens - 0.2},
            {.name = "outside", .unit = "", .measure = outside, .low = 0, .high = 0},
            contactFailures()};
}

View viewOf(const Range& water, double spacing) {
    View view = plait::viewOf({water}, {tank / 2, 1.05, depth / 2}, tank, Material::water,
                              {0.2, 0.27, 1.3});
    view.looks[0].radius = 0.5 * spacing;
    view.looks[0].color = {0.03, 0.15, 0.27};
    view.looks[0].wall = {.thickness = 0, .clear = 1 / 1.8};
    view.looks[0].panes = {{{0, 0, 0}, {0, -1, 0}},
                           {{0, 0, 0}, {-1, 0, 0}},
                           {{tank, 0, 0}, {1, 0, 0}},
                           {{0, 0, 0}, {0, 0, -1}},
                           {{0, 0, depth}, {0, 0, 1}}};
    view.groundHeight = 0;
    view.inset = Inset{.x = "reduced time", .y = "front", .curve = front1952};
    constexpr double rail = 0.012;
    for (const double z : {0.0, depth}) {
        addBar(view, {0, filled, z}, {tank, filled, z}, rail, Material::steel);
        for (const double x : {0.0, tank})
            addBar(view, {x, 0, z}, {x, filled, z}, rail, Material::steel);
    }
    for (const double x : {0.0, tank})
        addBar(view, {x, filled, 0}, {x, filled, depth}, rail, Material::steel);
    return view;
}

}  // namespace

Scene damBreak(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int across = knobs.byQuality(10, 24, 37);
    Liquid liquid{.particles = {}, .spacing = width / across, .walls = tankWithDam()};
    liquid.particles =
        world.add(column(across, liquid.spacing), {.density = 1000 * std::pow(liquid.spacing, 3)});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -gravity, 0}});
    holdDensity(world, liquid, {.name = "density"});
    collide(world, liquid.walls, {surfaceOf(liquid)}, {.name = "tank", .order = 1});

    // As many substeps as leave it compressed by that much at rest.
    const double percent = knobs.number("compression");
    const double h = std::sqrt(percent / 100 / restCompression(liquid, filled, gravity, 1));
    const int substeps = static_cast<int>(std::ceil(1 / (24 * h)));
    scene.options.schedule = {.substeps = substeps, .iterations = 1, .collisionPasses = 1};
    scene.seconds = 4.5;
    scene.metrics = metricsOf(liquid);
    char fact[160];
    std::snprintf(
        fact, sizeof fact,
        "%d particles, %d substeps a frame; at rest compressed by %.2f %% at most, %.2f %% "
        "in the mean",
        liquid.particles.size(), substeps, percent, 0.45 * percent);
    scene.facts = {fact};
    scene.view = viewOf(liquid.particles, liquid.spacing);
    return scene;
}

}  // namespace plait
