// Drops of rain on a waxed leaf: they land, draw themselves together, and roll off.
#include "../parts/measures.h"
#include "liquid.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/particles/liquid.h>
#include <plait/particles/tension.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double leaf = 0.1, dropRadius = 2.2e-3;  // m: the radius of its curve, of a drop
constexpr double sound = 4;                        // m/s, in the water
constexpr double slow = 10;                        // times, the film

// Of a drop: how far off the top, from where on the compass, and how high over the skin.
struct Drop {
    double off, from, high;  // degrees, degrees, m
};
constexpr std::array drops{Drop{1.5, 200, 0.5e-3}, Drop{5, 60, 2e-3},    Drop{6.5, 150, 4e-3},
                           Drop{5.5, 265, 6e-3},   Drop{8, 20, 8e-3},    Drop{3, 330, 11e-3},
                           Drop{7.5, 215, 14e-3},  Drop{8.5, 100, 17e-3}};

Vec<double> middleOf(const Drop& drop) {
    const double off = pi / 180 * drop.off, from = pi / 180 * drop.from;
    const double r = leaf + dropRadius;
    return {r * sine(off) * cosine(from), r * cosine(off) - leaf + drop.high,
            r * sine(off) * sine(from)};
}

constexpr Vec<double> middle{0, -leaf, 0};

Collider skin() {
    Collider wall{.solid = Solid::sphere(leaf), .frame = {.origin = middle}};
    wall.staticFriction = wall.dynamicFriction = 0;
    return wall;
}

// Balls of a lattice that is shaken by a twentieth.
Shape water(double spacing) {
    Shape shape;
    const int most = static_cast<int>(dropRadius / spacing) + 1;
    for (const Drop& drop : drops)
        for (int i = -most; i <= most; ++i)
            for (int j = -most; j <= most; ++j)
                for (int k = -most; k <= most; ++k) {
                    const auto shaken = [&](int n, int by) {
                        return (n + 0.025 * ((7 * i + 13 * j + by * k) % 5 - 2)) * spacing;
                    };
                    const Vec<double> p{shaken(i, 5), shaken(j, 11), shaken(k, 17)};
                    if (length(p) < dropRadius) shape.positions.push_back(middleOf(drop) + p);
                }
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()));
    return shape;
}

std::vector<Metric> metricsOf(const Liquid& liquid) {
    const auto above = [](const Vec<double>& p) { return length(p - middle) - leaf; };
    const auto inside = [=](const Snapshot& at) {
        return static_cast<double>(std::ranges::count_if(
            at.positions, [=](const Vec<double>& p) { return above(p) < 0; }));
    };
    const auto onIt = [=](const Snapshot& at) {
        return 100.0 *
               static_cast<double>(std::ranges::count_if(
                   at.positions, [=](const Vec<double>& p) { return above(p) < 2 * dropRadius; })) /
               static_cast<double>(at.positions.size());
    };
    const auto compression = [=](const Snapshot& at) {
        return 100 * (std::ranges::max(densityRatios(liquid, at.positions, at.time)) - 1);
    };
    return {
        {.name = "in the leaf", .unit = "", .measure = inside, .low = 0, .high = 0},
        {.name = "on the leaf",
         .unit = "%",
         .measure = onIt,
         .low = 0,
         .high = 100,
         .caption = true},
        {.name = "largest compression", .unit = "%", .measure = compression, .low = 0, .high = 25},
        contactFailures()};
}

View viewOf(const Liquid& liquid) {
    View view;
    view.looks = {{.object = liquid.particles,
                   .material = Material::water,
                   .color = {0.25, 0.45, 0.55},
                   .radius = 0.7 * liquid.spacing,
                   .wall = {.thickness = 0.05, .clear = 0.05}}};
    view.props = {{.shape = sphere({.subdivisions = 6, .radius = leaf}, {.origin = middle}),
                   .material = Material::matte,
                   .color = {0.03, 0.075, 0.03}}};
    view.ground = false;
    view.cameras = {{.eye = {0.01, 0.052, 0.066}, .target = {0, 0, 0.001}, .focalLength = 62}};
    view.glowCenter = {0, 0.02, -0.1};
    view.takes = {{.from = 0, .to = 0.24, .slow = slow, .words = "ten times slower"}};
    return view;
}

}  // namespace

Scene droplets(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double spacing = knobs.byQuality(0.42e-3, 0.32e-3, 0.22e-3);
    Liquid liquid{.particles = {}, .spacing = spacing, .walls = {skin()}};
    liquid.particles = world.add(water(spacing), {.density = 1000 * std::pow(spacing, 3)});
    world.act<Gravity>(GravityOptions{});
    actTension(
        world, liquid,
        {.tension = knobs.number("tension") / 1000, .angle = knobs.number("angle"), .interval = 4});
    holdDensity(world, liquid, {.name = "density"});
    collide(world, liquid.walls, {surfaceOf(liquid)}, {.name = "leaf", .order = 1});
    const double h = std::sqrt(2 * liquid.relaxation) * spacing / sound;
    const int substeps = static_cast<int>(std::ceil(1 / (240 * h)));
    scene.options.schedule = {
        .substeps = substeps, .frameRate = {240, 1}, .iterations = 1, .collisionPasses = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.seconds = 0.24;
    scene.metrics = metricsOf(liquid);
    char fact[160];
    std::snprintf(fact, sizeof fact, "%zu drops of %.1f mm, %d particles, %d substeps in 1/240 s",
                  drops.size(), 2e3 * dropRadius, liquid.particles.size(), substeps);
    scene.facts = {fact};
    scene.view = viewOf(liquid);
    return scene;
}

}  // namespace plait
