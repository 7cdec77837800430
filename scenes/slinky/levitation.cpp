// Hung and let go: its last turn does not know that it falls until the others have reached it.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "slinky.h"

#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double letGoAt = 0.25, seconds = 0.68;

// Mean height of the vertices of the rod by mass, m.
double middleOf(const std::vector<double>& mass, const Rod& rod,
                const std::vector<Vec<double>>& positions) {
    double moment = 0, sum = 0;
    for (int v = rod.points.first; v < rod.directors.last; ++v) {
        moment += mass[v] * positions[v].y;
        sum += mass[v];
    }
    return moment / sum;
}

double lastTurnOf(const Slinky& slinky, const Rod& rod, const std::vector<Vec<double>>& positions) {
    double sum = 0;
    for (int i = 0; i < slinky.links; ++i) sum += positions[rod.points.first + i].y;
    return sum / slinky.links;
}

// Until the last turn moves, the middle of all comes nearer to it as a stone falls; then all has
// met, and they come no nearer. So the time that their distance tells stops.
Metric clockOf(const World& world, const Slinky& slinky, const Rod& rod, const Band& band) {
    const double apart =
        middleOf(world.mass, rod, world.start) - lastTurnOf(slinky, rod, world.start);
    return {.name = "last turn hangs",
            .unit = "s",
            .measure =
                [=, mass = world.mass](const Snapshot& at) {
                    const double now =
                        middleOf(mass, rod, at.positions) - lastTurnOf(slinky, rod, at.positions);
                    return std::sqrt(std::max(0.0, apart - now) * 2 / 9.81);
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

// In % of the extension, until it is reached.
Metric lastTurnMoves(const World& world, const Slinky& slinky, const Rod& rod, const Band& band) {
    return {.name = "last turn moves",
            .unit = "%",
            .measure =
                [=, before = lastTurnOf(slinky, rod, world.start)](const Snapshot& at) {
                    if (at.time > letGoAt + 0.97 * slinky.collapse()) return 0.0;
                    return 100 * std::fabs(lastTurnOf(slinky, rod, at.positions) - before) /
                           slinky.extension();
                },
            .low = band.low,
            .high = band.high};
}

// In mm: how far the middle of all is from the mark that fell beside it.
Metric besideMark(const World& world, const Rod& rod, int mark, const Band& band) {
    return {.name = "middle off the mark",
            .unit = "mm",
            .measure =
                [=, mass = world.mass](const Snapshot& at) {
                    return 1000 *
                           std::fabs(middleOf(mass, rod, at.positions) - at.positions[mark].y);
                },
            .low = band.low,
            .high = band.high};
}

// In %: by how much it is shorter than its turns laid on each other. Where nothing keeps them apart
// they fall through each other.
Metric pressed(const Slinky& slinky, const Rod& rod, const Band& band) {
    return {.name = "pressed",
            .unit = "%",
            .measure =
                [=, upper = Rod{{rod.points.last - slinky.links, rod.points.last}, {}}](
                    const Snapshot& at) {
                    const double closed = (slinky.turns - 1) * slinky.wire.across,
                                 now = lastTurnOf(slinky, upper, at.positions) -
                                       lastTurnOf(slinky, rod, at.positions);
                    return std::max(0.0, 100 * (1 - now / closed));
                },
            .low = band.low,
            .high = band.high};
}

// Brass, a long line each 0.5 m and a short one each 0.1 m, from 0 down.
void addRuler(View& view, double x, double length) {
    for (int i = 0; 0.1 * i < length + 0.05; ++i)
        addBar(view, {x, -0.1 * i, 0}, {x - (i % 5 ? 0.025 : 0.06), -0.1 * i, 0},
               i % 5 ? 0.0015 : 0.0025, Material::brass);
    addBar(view, {x, 0.02, 0}, {x, -length - 0.02, 0}, 0.003, Material::brass);
}

// Beside a ruler: as fast as it is, then slowly, and nearer to its end as that begins to fall.
void film(View& view, const Slinky& slinky, const Rod& rod, Range mark) {
    view.looks = {lookOf(slinky, rod),
                  {.object = mark,
                   .material = Material::brass,
                   .color = {0.584, 0.305, 0.050},
                   .radius = 0.014}};
    const auto camera = [](double time, double right, double middle, double height) {
        const double away = height * 50 / 20.25;
        return Camera{
            .time = time, .eye = {right, middle + 0.06 * away, away}, .target = {right, middle, 0}};
    };
    const double lowest = -slinky.turns * slinky.wire.across - slinky.extension();
    view.cameras = {camera(0, 0.12, -0.93, 2.15)};
    view.ground = false;
    view.glowCenter = {0, -0.6, -1};
    view.glow = 0.12;
    addRuler(view, -0.09, 1.7);
    addBar(view, {-0.045, 0.012, 0}, {0.045, 0.012, 0}, 0.008, Material::steel);
    const std::string which = "Which end falls first?";
    view.takes = {{.from = 0, .to = letGoAt, .slow = 10, .words = which},
                  {.from = letGoAt, .to = seconds},
                  {.from = letGoAt - 0.05,
                   .to = seconds,
                   .slow = 10,
                   .words = "10 times slower",
                   .cameras = {camera(letGoAt, 0.12, -0.93, 2.15),
                               camera(letGoAt + 0.8 * slinky.collapse(), 0.02, lowest, 0.5)}}};
}

}  // namespace

Scene levitation(const Knobs& knobs) {
    const Slinky slinky{.links = static_cast<int>(std::lround(knobs.number("links")))};
    Scene scene;
    World& world = scene.world;
    const double closed = slinky.turns * slinky.wire.across;
    const Rod rod = addSlinky(world, slinky, {0, -closed, 0});
    world.pin(upperTurns(slinky, rod, 1));
    world.act<Gravity>(GravityOptions{});
    hang(world, slinky, rod);
    const Range mark =
        world.add({SimplicialComplex(1), {{0.075, middleOf(world.mass, rod, world.start), 0}}},
                  {.density = 0.01});
    world.pin({mark.first});
    // Turns that meet stay together: no restitution, and what fell too near parts slowly. By 0.5
    // m/s a pair the closed stack opens again in mid-air, and its wire flies apart.
    Surface skin = skinOf(slinky, rod);
    skin.staticFriction = skin.dynamicFriction = 0;  // nothing slides
    meet(world, {skin}, {.recovery = 0.05});
    std::vector<int> held = upperTurns(slinky, rod, 1);
    held.push_back(mark.first);
    world.letGo(held, letGoAt);

    // Frames that a film can show ten times slower than they were.
    scene.options.schedule = {.substeps = 5, .frameRate = {240, 1}, .iterations = 1};
    // A blow on a stack of turns must reach its other end: with no sweeps of contacts of their own
    // it is pressed to a quarter of its length as it closes.
    scene.options.schedule.collisionPasses = 45;
    scene.options.sweeps = Sweeps::oneWay;
    scene.seconds = seconds;
    scene.metrics = {clockOf(world, slinky, rod, {0, 1.03 * slinky.collapse()}),
                     lastTurnMoves(world, slinky, rod, {0, 0.5}),
                     besideMark(world, rod, mark.first, {0, 1}),
                     greatestStrain(world, rod.points, {0, 1}),
                     ridingOff(slinky, rod, {0, 0}),
                     contactFailures(),
                     pressed(slinky, rod, {0, 10})};
    scene.facts = factsOf(slinky);

    film(scene.view, slinky, rod, mark);
    return scene;
}

}  // namespace plait
