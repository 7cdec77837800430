// Two balloons on one tube: what is larger has less pressure, and takes the other's air.
#include "../parts/views.h"
#include "balloon.h"
#include "party_balloon.h"

#include <plait/forces/gravity.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plait {
namespace {

constexpr double air = 101325;    // Pa
constexpr double nozzle = 0.5;    // m, height of the tube's ends
constexpr double apart = 0.19;    // m, of each from the middle
constexpr double inside = 0.018;  // m, how far a neck is drawn over the tube
constexpr double full = 2.5;      // s, until all the gas is in
constexpr double settled = 3.2;   // s, when neither changes any more

Metric stretchOf(const std::string& name, const Enclosure& enclosure, double rest, double low,
                 double high) {
    return {
        .name = name,
        .unit = "",
        .measure =
            [=](const Snapshot& at) { return std::cbrt(volume(enclosure, at.positions) / rest); },
        .low = low,
        .high = high,
        .from = settled,
        .caption = true};
}

View viewOf(const std::array<Range, 2>& skins) {
    View view =
        plait::viewOf({skins[0], skins[1]}, {0, 0.36, 0}, 0.6, Material::latex, {0.1, 0.1, 2.4});
    view.ground = false;
    for (const double x : {-apart, apart})
        addBar(view, {x, nozzle, 0}, {x, nozzle + 0.06, 0}, 0.0075, Material::brass);
    addBar(view, {-apart, nozzle + 0.06, 0}, {apart, nozzle + 0.06, 0}, 0.0075, Material::brass);
    addBar(view, {0, nozzle + 0.06, 0}, {0, nozzle + 0.5, 0}, 0.0075, Material::brass);
    return view;
}

}  // namespace

Scene twoBalloons(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const PartyBalloon party;
    const int subdivisions = knobs.byQuality(3, 4, 5);
    std::array<Range, 2> skins;
    std::array<Enclosure, 2> each;
    Membrane membrane;
    for (int b = 0; b < 2; ++b) {
        skins[b] = addBalloon(world, party, subdivisions, {b ? apart : -apart, nozzle + inside, 0});
        world.pin(world.select(skins[b], [](const Vec<double>& x) { return x.y > nozzle; }));
        each[b] = enclose(world, {skins[b]});
        // The second is as much thicker as balloons are unlike each other.
        membrane.rubber.push_back(
            rubberOf(each[b], party, party.wall * (b ? 1 + knobs.number("thicker") : 1)));
    }
    const Enclosure both = enclose(world, {skins[0], skins[1]}, {.name = "balloons"});
    const double rest = volume(each[0], world.rest);
    // In the end as much as two want that are stretched alike.
    const auto amount = [=, stretch = knobs.number("stretch")](double t) {
        const double from = 2 * air * rest, to = 2 * amountFor(party, rest, stretch);
        return from + (to - from) * std::min(1.0, t / full);
    };
    membrane.gases.push_back({both, {.amount = amount(0)}, amount});
    world.act<Gravity>(GravityOptions{});
    holdMembrane(world, membrane, {.name = "rubber"});

    scene.options.schedule = {.substeps = 10, .iterations = 1};
    scene.options.damping = 0.05;
    scene.seconds = 4;
    scene.metrics = {stretchOf("left", each[0], rest, 3.65, 3.85),
                     stretchOf("right", each[1], rest, 1.0, 1.15),
                     {.name = "gauge pressure",
                      .unit = "kPa",
                      .measure =
                          [=](const Snapshot& at) {
                              return (amount(at.time) / volume(both, at.positions) - air) / 1000;
                          },
                      .low = 1.2,
                      .high = 1.5,
                      .from = settled,
                      .caption = true}};
    scene.view = viewOf(skins);
    return scene;
}

}  // namespace plait
