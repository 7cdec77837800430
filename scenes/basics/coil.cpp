// A coil that hangs by its top turn.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "basics.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/rods/rod.h>

namespace plait {
namespace {

constexpr int turns = 30, links = 24;
constexpr double radius = 0.034;  // m
constexpr Wire steel{.poisson = 0.27, .along = 2.5e-3, .across = 0.62e-3};

// From below upwards, its top turn at y = 0.
Rod addCoil(World& world) {
    const Shape curve =
        helix({.links = turns * links, .radius = radius, .turns = turns, .pitch = steel.across},
              {.origin = {0, -turns * steel.across, 0}});
    std::vector<Vec<double>> outward;
    for (int e = 0; e < turns * links; ++e) {
        const auto i = static_cast<std::size_t>(e);
        const Vec<double> middle = 0.5 * (curve.positions[i] + curve.positions[i + 1]);
        outward.push_back({middle.x, 0, middle.z});
    }
    return addRod(world, curve, {.wire = steel, .toward = outward}, {.name = "wire"});
}

// In mm, of the middle of the lowest turn.
Metric sag(const Rod& rod, Band band) {
    return {.name = "sag",
            .unit = "mm",
            .measure =
                [first = rod.points.first](const Snapshot& at) {
                    double sum = 0;
                    for (int i = 0; i < links; ++i) sum += at.positions[first + i].y;
                    return -1000 * (sum / links + (turns - 0.5) * steel.across);
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

}  // namespace

// A flat wire of steel, let go as a stack: it sags by m g / 2 k, k = C / 2 pi n R^3 (Wahl,
// "Mechanical springs"), a little less where its turns are no longer level.
Scene coil(const Knobs&) {
    Scene scene;
    World& world = scene.world;
    const Rod rod = addCoil(world);
    std::vector<int> held;
    for (int i = 0; i <= links; ++i) held.push_back(rod.points.last - 1 - i);
    for (int i = 0; i < links; ++i) held.push_back(rod.directors.last - 1 - i);
    world.pin(held);
    world.act<Gravity>(GravityOptions{});
    scene.options.schedule = {.substeps = 24, .iterations = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.options.damping = 0.1;
    scene.seconds = 5;
    double mass = 0;
    for (const double m : world.mass) mass += m;
    const double free = turns - 1,
                 stiffness = steel.twisting() / (2 * pi * free * radius * radius * radius),
                 expected = 1000 * mass * free / turns * 9.81 / (2 * stiffness);
    scene.metrics = {sag(rod, {0.95 * expected, 1.0 * expected, 4})};

    View& view = scene.view;
    view = viewOf({rod.points}, {0, -0.17, 0}, 0.38, Material::brushed, {0.7, 0.35, 2.6});
    Look& look = view.looks[0];
    look.color = {0.46, 0.49, 0.52};
    look.section = {.along = steel.along, .across = steel.across};
    look.directors = rod.directors;
    addBar(view, {-0.06, 0.006, 0}, {0.06, 0.006, 0}, 0.005, Material::brass);
    return scene;
}

}  // namespace plait
