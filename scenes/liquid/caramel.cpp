// Caramel falls from a spout onto a plate, where it folds and coils (Ribe, Coiling of viscous jets,
// 2004).
#include "../parts/measures.h"
#include "../parts/views.h"
#include "liquid.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/particles/liquid.h>
#include <plait/particles/viscosity.h>
#include <plait/sources/source.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double gravity = 9.81, density = 1400;              // m/s^2, kg/m^3
constexpr double spout = 0.07, thread = 0.005, speed = 0.07;  // m, m, m/s
constexpr double flows = 5;                                   // s

// Across a spout: a square lattice in a disc, turned so that no two points lie on a ray.
std::vector<Vec<double>> discOf(double spacing) {
    std::vector<Vec<double>> points;
    const int n = static_cast<int>(thread / spacing) + 1;
    for (int i = -n; i <= n; ++i)
        for (int k = -n; k <= n; ++k) {
            const Vec<double> p{(i + 0.21) * spacing, spout, (k + 0.37) * spacing};
            if (p.x * p.x + p.z * p.z < thread * thread) points.push_back(p);
        }
    return points;
}

std::vector<Collider> plate() {
    Collider floor{.solid = Solid::plane(), .frame = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    floor.staticFriction = floor.dynamicFriction = 0;  // what holds it there is its viscosity
    return {floor};
}

std::vector<Metric> metricsOf(const Liquid& liquid, double percent) {
    const Range all = liquid.particles;
    const auto here = [=](const Snapshot& at, const auto& which) {
        std::vector<Vec<double>> found;
        for (int v = all.first; v < all.last; ++v)
            if (at.isHere(v) && which(at.positions[v])) found.push_back(at.positions[v]);
        return found;
    };
    const auto count = [=](const Snapshot& at) {
        return static_cast<double>(here(at, [](const Vec<double>&) { return true; }).size());
    };
    const auto below = [=](const Snapshot& at) {
        return static_cast<double>(
            here(at, [](const Vec<double>& p) { return !(p.y > 0); }).size());
    };
    // How far the thread is off the axis a third of the way up.
    const auto swing = [=](const Snapshot& at) {
        Vec<double> sum{0, 0, 0};
        const auto layer = here(at, [=](const Vec<double>& p) {
            return p.y > 0.3 * spout && p.y < 0.3 * spout + 2 * liquid.spacing;
        });
        for (const Vec<double>& p : layer) sum += p;
        return layer.empty() ? 0.0
                             : 1000 * std::hypot(sum.x, sum.z) / static_cast<double>(layer.size());
    };
    const auto compression = [=](const Snapshot& at) {
        if (count(at) == 0) return 0.0;
        return 100 *
               std::max(0.0,
                        std::ranges::max(densityRatios(liquid, at.positions, at.time, at.ids)) - 1);
    };
    return {{.name = "particles",
             .unit = "",
             .measure = count,
             .low = 0,
             .high = double(all.size()),
             .caption = true},
            {.name = "below the plate", .unit = "", .measure = below, .low = 0, .high = 0},
            {.name = "swing", .unit = "mm", .measure = swing, .caption = true},
            {.name = "largest compression",
             .unit = "%",
             .measure = compression,
             .low = 0,
             .high = percent},
            contactFailures()};
}

View viewOf(const Liquid& liquid) {
    View view =
        plait::viewOf({liquid.particles}, {0, 0.045, 0}, 0.2, Material::water, {0.25, 0.32, 1.3});
    view.looks[0].radius = 0.85 * liquid.spacing;
    view.looks[0].color = {0.5, 0.13, 0.004};
    view.looks[0].wall = {.thickness = 0.01, .clear = 0.005};
    view.stage.floor = {0.3, 0.27, 0.23};
    view.groundHeight = 0;
    addBar(view, {0, spout, 0}, {0, spout + 0.06, 0}, 1.25 * thread, Material::steel);
    return view;
}

}  // namespace

Scene caramel(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double spacing = knobs.byQuality(2e-3, 1.25e-3, 0.8e-3);
    const std::vector<Vec<double>> nozzle = discOf(spacing);
    const double every = spacing / speed;
    const int volleys = static_cast<int>(std::ceil(flows / every));
    Liquid liquid{.particles = {}, .spacing = spacing, .walls = plate()};
    liquid.particles =
        world.add({SimplicialComplex(0), {}}, {.density = density * std::pow(spacing, 3),
                                               .spare = volleys * static_cast<int>(nozzle.size())});
    // What is not there yet waits in the spout.
    for (Vec<double>& x : world.start) x = {0, spout + 0.03, 0};
    world.rest = world.start;
    world.act<Source>(SourceOptions{.name = "spout",
                                    .spare = liquid.particles,
                                    .nozzle = nozzle,
                                    .velocity = {0, -speed, 0},
                                    .every = every,
                                    .until = flows,
                                    .scatter = 0.15 * spacing,
                                    .hold = 2 * every});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -gravity, 0}});
    actViscosity(
        world, liquid,
        {.viscosity = knobs.number("viscosity"), .tolerance = 2e-4, .mostIterations = 1000});
    holdDensity(world, liquid, {.name = "density"});
    collide(world, liquid.walls, {surfaceOf(liquid)}, {.name = "plate", .order = 1});

    const double h = std::sqrt(0.04 / restCompression(liquid, 0.02, gravity, 1));
    const int substeps = static_cast<int>(std::ceil(1 / (24 * h)));
    scene.options.schedule = {.substeps = substeps, .iterations = 1, .collisionPasses = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.seconds = 6;
    scene.metrics = metricsOf(liquid, 20);
    char fact[160];
    std::snprintf(fact, sizeof fact, "%d particles of %.2f mm at most, %d substeps a frame",
                  liquid.particles.size(), 1e3 * spacing, substeps);
    scene.facts = {fact};
    scene.view = viewOf(liquid);
    return scene;
}

}  // namespace plait
