// Two hands pull at the hem of a vest where a stitch is missing: it tears as far as they pull, and
// no further when they let go.
#include "tearing.h"

#include "../parts/measures.h"
#include "../parts/views.h"

#include <plait/air/air.h>
#include <plait/attachments/grip.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>
#include <plait/tearing/tearing.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace plait {
namespace {

constexpr double wide = 0.19, deep = 0.11, tall = 0.56;       // m, half axes and height
constexpr double hem = 0.3;                                   // m above the ground
constexpr double thickness = 0.5e-3;                          // m
constexpr double grasp = 0.04, reach = 0.022;                 // m, of the hands
constexpr double begins = 0.4, pulled = 2.6, released = 3.1;  // s

double eased(double t, double from, double to) {
    const double s = std::clamp((t - from) / (to - from), 0.0, 1.0);
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

// A tube with an oval section; its front is at z = deep.
Shape vest(int around, int rows) {
    Shape shape = tube({.segments = around, .rings = rows, .radius = 1, .height = tall});
    for (Vec<double>& x : shape.positions) x = {wide * x.x, hem + x.y, deep * x.z};
    return shape;
}

// Away from its own side of the missing stitch, a little to the front and down; it gives way before
// it lets go.
Posing handOf(double side, double pull) {
    return [=](double t) {
        const double way = pull * (eased(t, begins, pulled) - 0.5 * eased(t, pulled, released));
        return Frame{{side * (grasp + way), hem + 0.01 - 0.15 * way, deep + 0.35 * way}};
    };
}

// Vertices that have come apart since the hands let go.
Metric tornOn(Range cloth) {
    return {.name = "torn on",
            .unit = "",
            .measure =
                [=](const Snapshot& at) {
                    double sum = 0;
                    if (at.ages.empty() || at.time <= released) return sum;
                    for (int v = cloth.first; v < cloth.last; ++v)
                        sum += at.isHere(v) &&
                               at.ages[static_cast<std::size_t>(v)] < at.time - released - 1e-9;
                    return sum;
                },
            .low = 0,
            .high = 3};
}

void addHand(World& world, Range cloth, double side, double pull) {
    const std::vector<int> held = world.select(cloth, [&](const Vec<double>& x) {
        return std::hypot(x.x - side * grasp, x.y - hem - 0.01) < reach && x.z > 0;
    });
    addGrip(world, {.vertices = held, .hand = handOf(side, pull), .from = 0, .to = released},
            {.name = side < 0 ? "left hand" : "right hand"});
}

void look(View& view, Range cloth, double pull) {
    view = viewOf({cloth}, {0, hem + 0.4 * tall, 0}, 0.8, Material::cotton, {0.35, 0.12, 2.6});
    view.looks[0].color = {0.36, 0.42, 0.5};
    view.groundHeight = 0;
    for (const double side : {-1.0, 1.0}) {
        const std::size_t first = view.props.size();
        addBar(view, {0, 0, -0.01}, {0, 0, 0.03}, 0.012, Material::brass);
        for (std::size_t p = first; p < view.props.size(); ++p)
            view.props[p].motion = [hand = handOf(side, pull)](double t) {
                Frame frame = hand(std::min(t, released));
                if (t > released) frame.origin.z += 0.5 * (t - released) * (t - released);
                return frame;
            };
    }
    addBar(view, {-0.24, hem + tall, 0}, {0.24, hem + tall, 0}, 0.006, Material::brass);
}

}  // namespace

Scene tornVest(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int rows = knobs.byQuality(27, 41, 61), around = 2 * (rows - 1);
    const Range cloth = world.add(vest(around, rows), {.density = 0.2, .spare = 6 * rows});
    std::vector<int> shoulders = world.select(cloth, [](const Vec<double>& x) {
        return x.y > hem + tall - 1e-6 && std::fabs(x.x) > 0.42 * wide &&
               std::fabs(x.x) < 0.9 * wide;
    });
    world.pin(shoulders);
    const double pull = knobs.number("pull");
    for (const double side : {-1.0, 1.0}) addHand(world, cloth, side, pull);

    Membrane membrane;
    membrane.rubber.push_back({.triangles = triangleStencils(world.complex, cloth),
                               .thickness = {thickness},
                               .law = neoHookean(4e6),
                               .relaxed = true});
    holdTearing(world, membrane,
                {.cloth = cloth,
                 .strength = 10e6,
                 .toughness = 1000 * knobs.number("toughness"),
                 .map =
                     [](const Vec<double>& x) {
                         return std::fabs(x.x) < 0.01 && x.y < hem + 0.01 && x.z > 0 ? 0.03 : 1;
                     },
                 .scatter = 0.1},
                {.name = "jersey", .importance = 24});
    world.constrain(bendRows(world.complex, cloth, world.rest, 4e-6), {.name = "bend", .order = 1});
    meet(world,
         {{.vertices = cloth, .thickness = 1e-3, .staticFriction = 0.4, .dynamicFriction = 0.4}},
         {.order = 2});
    world.act<Gravity>(GravityOptions{});
    actAir(world, {.objects = {cloth}});

    scene.options.schedule = {.substeps = 24, .iterations = 1, .collisionPasses = 2};
    scene.options.damping = 0.02;
    scene.seconds = 5;
    // Fresh lips may close over each other by a quarter of an edge, until they have parted.
    scene.metrics = {tornLength(world, {}), tornOn(cloth), selfIntersections(world, cloth, {0, 10}),
                     contactFailures()};

    look(scene.view, cloth, pull);
    return scene;
}

}  // namespace plait
