// A needle pricks it, and what the skin bears tears it open: the tear is gone round before the gas
// has left.
#include "balloon.h"

#include "../parts/measures.h"
#include "../parts/views.h"
#include "party_balloon.h"

#include <plait/air/air.h>
#include <plait/constraints/constants.h>
#include <plait/contacts/surface.h>
#include <plait/relax.h>
#include <plait/stencils.h>
#include <plait/tearing/tearing.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace plait {
namespace {

constexpr double slower = 500;               // a second of film is 2 ms
constexpr double seconds = 4;                // of film
constexpr double neck = 0.9;                 // m, height of its end
constexpr double speed = 4;                  // m/s, of the needle
constexpr double pricks = 0.8e-3;            // s
constexpr double flexuralRigidity = 2.2e-6;  // N m

Membrane membraneOf(const Enclosure& enclosure, const PartyBalloon& party, double amount) {
    Membrane membrane;
    membrane.rubber.push_back(rubberOf(enclosure, party, party.wall));
    membrane.gases.push_back({.enclosure = enclosure, .gas = {.amount = amount}, .bursts = true});
    return membrane;
}

// Starts where the gas has blown it up to.
void blowUp(World& world, Range skin, Membrane membrane, double stretch) {
    const Vec<double> top{0, neck, 0};
    for (int v = skin.first; v < skin.last; ++v)
        if (!world.isSpare(v)) world.start[v] = top + stretch * (world.start[v] - top);
    World still = world;
    membrane.iterations = 100;
    holdMembrane(still, membrane, {.name = "rubber"});
    relax(still, {.schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = 1}},
          {.speed = 1e-6, .frames = 40});
    world.start = still.start;
}

}  // namespace

Scene burst(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const PartyBalloon party;
    const double stretch = knobs.number("stretch");
    const Range skin = addBalloon(world, party, knobs.byQuality(3, 4, 5), {0, neck, 0},
                                  knobs.byQuality(300, 900, 2500));
    const Enclosure enclosure = enclose(world, {skin}, {.name = "balloon"});
    const double rest = volume(enclosure, world.rest);
    const Membrane membrane = membraneOf(enclosure, party, amountFor(party, rest, stretch));
    std::vector<int> knot = world.select(
        skin, [&](const Vec<double>& x) { return x.y > neck - 0.4 * party.neckLength; });
    std::erase_if(knot, [&](int v) { return world.isSpare(v); });
    world.pin(knot);
    blowUp(world, skin, membrane, stretch);

    // The needle comes from the right, at the height where the balloon is widest.
    Vec<double> side{0, 0, 0};
    for (int v = skin.first; v < skin.last; ++v)
        if (!world.isSpare(v) && world.start[v].x > side.x) side = world.start[v];
    const auto tip = [=](double t) { return side + Vec<double>{speed * (pricks - t), 0, 0}; };

    holdTearing(world, membrane,
                {.cloth = skin,
                 .toughness = 1000 * knobs.number("toughness"),
                 .branching = knobs.number("branching"),
                 .needle = tip},
                {.name = "rubber", .importance = 1});
    world.constrain(bendRows(world.complex, skin, world.rest, flexuralRigidity),
                    {.name = "bend", .order = 1, .importance = 1});
    actAir(world, {.density = 1.2, .drag = 1.2, .objects = {skin}});
    meet(world, {{.vertices = skin, .staticFriction = 0.5, .dynamicFriction = 0.5}},
         {.order = 2, .importance = 1});

    scene.options.schedule = {.substeps = 8, .iterations = 1};
    scene.options.timeScale = 1 / slower;
    scene.seconds = seconds;
    scene.metrics = {tornLength(world, {}), selfIntersections(world, skin, {0, 0}),
                     contactFailures()};
    const double middle = neck - stretch * (party.neckLength + party.radius);
    scene.view = viewOf({skin}, {0.01, middle + 0.015, 0}, 0.46, Material::latex, {0.35, 0.1, 2.4});
    scene.view.ground = false;
    Shape needle = turned({{0, 0}, {0.0006, 0.012}, {0.0008, 0.09}, {0, 0.09}}, 24);
    for (Vec<double>& x : needle.positions) x = {x.y, x.x, x.z};
    scene.view.props.push_back({.shape = needle,
                                .material = Material::steel,
                                .motion = [=](double t) { return Frame{tip(t)}; }});
    return scene;
}

}  // namespace plait
