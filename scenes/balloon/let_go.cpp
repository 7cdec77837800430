// Let go, a balloon flies where its air does not want to: the jet pushes its neck, and nothing else
// tells it where to go.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "balloon.h"
#include "party_balloon.h"

#include <plait/air/air.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double blown = 1.4, held = 0.3;  // s, that the hand takes to blow it up, and holds it
constexpr double seconds = 2.5;
constexpr double pinch = 0.024;              // m of neck between the fingers
constexpr double flexuralRigidity = 2.2e-6;  // N m, as the balloon's

// m, of the skin's vertices.
Metric middleOf(const std::string& name, Range skin, double Vec<double>::* along) {
    return {.name = name, .unit = "m", .measure = [=](const Snapshot& at) {
                double sum = 0;
                for (int v = skin.first; v < skin.last; ++v) sum += at.positions[v].*along;
                return sum / skin.size();
            }};
}

// Rubber and gas; thicker by `uneven`, in parts of the mean, on the side of `upper` (unit).
void blowUp(World& world, const PartyBalloon& party, const Enclosure& enclosure,
            const Vec<double>& middle, const Vec<double>& upper, double stretch, double uneven,
            const Vec<double>& gravity) {
    Membrane membrane;
    membrane.rubber.push_back({{}, {}, party.rubber});
    for (const auto& t : std::span(enclosure.triangles).first(enclosure.skin)) {
        membrane.rubber[0].triangles.insert(membrane.rubber[0].triangles.end(), t.begin(), t.end());
        const Vec<double> at =
            1.0 / 3 * (world.rest[t[0]] + world.rest[t[1]] + world.rest[t[2]]) - middle;
        membrane.rubber[0].thickness.push_back(party.wall *
                                               (1 + uneven * dot(at, upper) / party.radius));
    }
    const auto amount = [=, rest = volume(enclosure, world.rest)](double t) {
        const double to = 1 + (stretch - 1) * std::clamp(t / blown, 0.0, 1.0);
        return amountFor(party, rest, to);
    };
    membrane.gases.push_back({enclosure,
                              {.amount = amount(0)},
                              amount,
                              {.hole = {enclosure.caps().begin(), enclosure.caps().end()},
                               .opens = blown + held,
                               .gravity = gravity}});
    holdMembrane(world, membrane, {.name = "rubber"});
}

View viewOf(Range skin) {
    View view = plait::viewOf({skin}, {0.4, 0.6, 0}, 1.3, Material::latex, {0.35, 0.15, 2.4});
    view.groundHeight = 0;
    view.groundSize = 2.5;
    view.takes = {{.from = 0, .to = seconds},
                  {.from = held - 0.05, .to = held + 1.05, .slow = 4, .words = "4 times slower"}};
    return view;
}

}  // namespace

Scene letGo(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const PartyBalloon party;
    const Vec<double> out{-0.5, -0.5 * std::sqrt(3.0), 0}, mouth{-0.35, 0.5, 0};
    const OpenBalloon balloon = addOpenBalloon(world, party, knobs.byQuality(3, 4, 5), mouth, out);
    const Enclosure enclosure = enclose(world, {balloon.skin}, {.cap = true, .name = "balloon"});
    const double rest = volume(enclosure, world.rest);
    std::vector<int> fingers;
    for (int v = balloon.skin.first; v < balloon.skin.last; ++v)
        if (balloon.depths[v - balloon.skin.first] < pinch) fingers.push_back(v);
    world.pin(fingers);
    world.letGo(fingers, blown + held);

    const GravityOptions gravity;
    world.act<Gravity>(gravity);
    blowUp(world, party, enclosure, mouth - 0.07 * out, {-out.y, out.x, 0}, knobs.number("stretch"),
           knobs.number("uneven") / 100, gravity.acceleration);
    actAir(world, {.density = 1.2, .drag = 1, .objects = {balloon.skin}});
    world.constrain(bendRows(world.complex, balloon.skin, world.rest, flexuralRigidity),
                    {.name = "bend", .order = 1});
    const Surface surface{.vertices = balloon.skin, .staticFriction = 0.5, .dynamicFriction = 0.5};
    meet(world, {surface}, {.order = 2});
    collide(world, {{.solid = Solid::plane(), .staticFriction = 0.5, .dynamicFriction = 0.5}},
            {surface}, {.order = 3});

    scene.options.schedule = {
        .substeps = 10, .frameRate = {96, 1}, .iterations = 2, .collisionPasses = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.lead = blown;
    scene.seconds = seconds;
    scene.metrics = {
        {.name = "stretch",
         .unit = "",
         .measure =
             [=](const Snapshot& at) {
                 return std::cbrt(std::max(0.0, volume(enclosure, at.positions)) / rest);
             },
         .caption = true},
        middleOf("height", balloon.skin, &Vec<double>::y),
        middleOf("aside", balloon.skin, &Vec<double>::x),
        selfIntersections(world, balloon.skin, {0, 0}),
        lowestHeight({0, 5}),
        contactFailures()};
    scene.view = viewOf(balloon.skin);
    return scene;
}

}  // namespace plait
