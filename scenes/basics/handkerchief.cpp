// A hand takes a handkerchief by its middle, lifts it, carries it and lets go.
#include "basics.h"

#include "../parts/fabrics.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"

#include <plait/air/air.h>
#include <plait/attachments/grip.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double side = 0.42, clear = 1e-3;                // m
constexpr double taken = 0.6, lifted = 2, released = 3.2;  // s
constexpr double reach = 0.018;                            // m, of the hand about the middle

double eased(double t, double from, double to) {
    const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

// It comes down, waits, lifts, swings aside, and goes up when it has let go.
Frame handAt(double t) {
    return {.origin = {0.25 * eased(t, 1.6, 2.8),
                       0.3 * (1 - eased(t, 0, 0.5)) + 0.5 * eased(t, taken + 0.1, lifted) +
                           0.2 * eased(t, released + 0.1, released + 1),
                       0}};
}

// In mm: how far what the hand has taken is from where it was in it.
Metric slip(const World& world, const std::vector<int>& vertices) {
    return {.name = "slip",
            .unit = "mm",
            .measure =
                [=, start = world.start](const Snapshot& at) {
                    double most = 0;
                    if (at.time < taken || at.time > released) return most;
                    const Vec<double> way = handAt(at.time).origin - handAt(taken).origin;
                    for (const int v : vertices) {
                        const auto i = static_cast<std::size_t>(v);
                        most = std::max(most, length(at.positions[i] - start[i] - way));
                    }
                    return 1000 * most;
                },
            .low = 0,
            .high = 1};
}

}  // namespace

Scene handkerchief(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int n = knobs.byQuality(21, 41, 71);
    const Fabric& fabric = findFabric(knobs.text("fabric"));
    const Range cloth = world.add(
        grid({.columns = n, .rows = n, .width = side, .height = side},
             {.origin = {-side / 2, clear, side / 2}, .across = {1, 0, 0}, .up = {0, 0, -1}}),
        {.density = fabric.density});
    const std::vector<int> held =
        world.select(cloth, [](const Vec<double>& x) { return std::hypot(x.x, x.z) < reach; });
    addGrip(world, {.vertices = held, .hand = handAt, .from = taken, .to = released},
            {.name = "grip"});
    const std::vector<int> threads =
        weave(world, cloth, gridThreads(n), fabric.shearStiffness, "", 0.01);
    world.constrain(bendRows(world.complex, cloth, world.rest, fabric.flexuralRigidity),
                    {.name = "bend", .order = 5});
    Surface surface = fabric.surface(cloth);
    surface.thickness = 1e-3;  // m, of a skin that a mesh of centimetres can hold
    meet(world, {surface}, {.order = 7});
    collide(world, {{.solid = Solid::plane(), .staticFriction = 0.5, .dynamicFriction = 0.5}},
            {surface}, {.order = 8});
    world.act<Gravity>(GravityOptions{});
    actAir(world, {.objects = {cloth}});
    scene.options.schedule = {.substeps = 24, .iterations = 1, .collisionPasses = 2};
    scene.seconds = 4.6;
    scene.metrics = {slip(world, held), greatestStrain(world, threads, {0, 2}),
                     selfIntersections(world, cloth, {0, 0}), contactFailures(),
                     lowestHeight({0, 1})};

    View& view = scene.view;
    view = viewOf({cloth}, {0.12, 0.22, 0}, 0.62, Material::cotton, {0.5, 0.5, 2.4});
    view.looks[0].color = {0.42, 0.47, 0.55};
    view.groundHeight = 0;
    // Its tip, where the hand's middle is.
    addBar(view, {0, 0.006, 0}, {0, 0.7, 0}, 0.006, Material::brass);
    for (Prop& prop : view.props) prop.motion = handAt;
    return scene;
}

}  // namespace plait
