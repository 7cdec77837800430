// The first breath is the hardest: what a balloon of rubber has against being blown up is most
// where it is a third larger than at rest, and falls until it is four times as large.
#include "balloon.h"

#include "../parts/measures.h"
#include "../parts/views.h"
#include "party_balloon.h"

#include <plait/air/air.h>
#include <plait/constraints/constants.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace plait {
namespace {

constexpr double air = 101325;               // Pa
constexpr double limp = 0.6;                 // part of its volume at rest that is left
constexpr double sinks = 0.8;                // s, until it is limp
constexpr double full = 5.5;                 // s, until it is full
constexpr double tied = 6;                   // s
constexpr double nozzle = 0.5;               // m, height of its end
constexpr double inside = 0.018;             // m, how far the neck is drawn over it
constexpr double flexuralRigidity = 2.2e-6;  // N m, E t^3 / 12 (1 - nu^2) of the wall
constexpr int substeps = 20;

// J, of the gas at time t (s): as a sphere wants it that grows steadily.
double amountAt(const PartyBalloon& balloon, double rest, double stretch, double t) {
    if (t < sinks) return air * rest * (1 - (1 - limp) * t / sinks);
    const double from = std::cbrt(limp),
                 to = from + (stretch - from) * std::min(1.0, (t - sinks) / (full - sinks));
    return to < 1 ? air * rest * to * to * to : amountFor(balloon, rest, to);
}

double volumeOf(const Enclosure& enclosure, const Snapshot& at) {
    return volume(enclosure, at.positions);
}

void look(View& view, Range skin, const PartyBalloon& balloon, double stretch) {
    view = viewOf({skin}, {0, 0.25, 0}, 0.56, Material::latex, {0.5, 0.1, 2.4});
    view.groundHeight = 0;
    view.groundSize = 0.8;
    addBar(view, {0, nozzle, 0}, {0, nozzle + 0.4, 0}, 0.0075, Material::brass);
    view.inset = Inset{.x = "stretch", .y = "gauge pressure", .curve = {}};
    for (double l = 0.8; l <= stretch + 0.4; l += 0.01)
        view.inset->curve.push_back({l, l < 1 ? 0 : balloon.pressure(l) / 1000});
}

using Measure = std::function<double(const Snapshot&)>;

// `pressure` is in kPa.
std::vector<Metric> metricsOf(const World& world, Range skin, const PartyBalloon& party,
                              const Measure& pressure, const Measure& stretched) {
    return {{.name = "gauge pressure",
             .unit = "kPa",
             .measure = pressure,
             .low = -0.3,
             .high = 3.5,  // a sphere has 3.05 at most
             .caption = true},
            {.name = "stretch", .unit = "", .measure = stretched, .caption = true},
            selfIntersections(world, skin, {0, 0}),
            lowestHeight({0, 1}),
            contactFailures(),
            folds(world, skin, {}),
            {.name = "pressed",
             .unit = "kPa",
             .measure =
                 [=](const Snapshot& at) {
                     return pressure(at) - party.pressure(stretched(at)) / 1000;
                 },
             .low = 0,
             .high = 0.1,  // 0.03 as a sphere it is not, the rest is the floor's
             .from = 8}};
}

}  // namespace

Scene balloon(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const PartyBalloon party;
    const double stretch = knobs.number("stretch");
    const Range skin = addBalloon(world, party, knobs.byQuality(3, 4, 5), {0, nozzle + inside, 0});
    const Enclosure enclosure = enclose(world, {skin}, {.name = "balloon"});
    const double rest = volume(enclosure, world.rest);
    const std::vector<int> mouth =
        world.select(skin, [&](const Vec<double>& x) { return x.y > nozzle; });
    world.pin(mouth);
    world.letGo(mouth, tied);

    world.act<Gravity>(GravityOptions{});
    actAir(world, {.density = 1.2, .drag = 1, .objects = {skin}});
    Membrane membrane;
    membrane.rubber.push_back(rubberOf(enclosure, party, party.wall));
    const auto amount = [=](double t) { return amountAt(party, rest, stretch, t); };
    membrane.gases.push_back({enclosure, {.amount = amount(0)}, amount});
    // With one column a substep rubber and bending push each other about, until what is limp flies
    // up at its nozzle.
    holdMembrane(world, membrane, {.name = "rubber", .importance = 2 * substeps});
    world.constrain(bendRows(world.complex, skin, world.rest, flexuralRigidity),
                    {.name = "bend", .order = 1, .importance = 22});
    const Surface surface{.vertices = skin, .staticFriction = 0.5, .dynamicFriction = 0.5};
    meet(world, {surface}, {.order = 2, .importance = substeps});
    collide(world, {{.solid = Solid::plane(), .staticFriction = 0.5, .dynamicFriction = 0.5}},
            {surface}, {.order = 3, .importance = 30});

    scene.options.schedule = {.substeps = substeps};
    scene.options.sweeps = Sweeps::oneWay;
    scene.options.damping = 0.02;
    scene.seconds = 9;
    scene.metrics = metricsOf(
        world, skin, party,
        [=](const Snapshot& at) {
            return (amount(at.time) / volumeOf(enclosure, at) - air) / 1000;
        },
        [=](const Snapshot& at) { return std::cbrt(volumeOf(enclosure, at) / rest); });
    look(scene.view, skin, party, stretch);
    return scene;
}

}  // namespace plait
