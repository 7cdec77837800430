// Five shells rise over a lake and burst: light that lives for a second or two.
#include "../parts/measures.h"
#include "particles.h"
#include "sand.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/sources/expression.h>
#include <plait/sources/source.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

using Color = std::array<double, 3>;

constexpr double gravity = 9.81;    // m/s^2
constexpr double shots = 240;       // 1/s: sparks of a tail
constexpr double tailLives = 0.55;  // s, more or less half of it
constexpr double perMetre = 0.055;  // 1/m: of its speed that a spark loses to the air
constexpr double burns = 2.0;       // s, more or less a third of it
constexpr double lead = 2.2;        // s, before the film
constexpr int substeps = 10;

struct Shell {
    double lit;     // s
    double aside;   // m
    double height;  // m, where it stands still and bursts
    double speed;   // m/s, of its fastest stars
    Color color;
};
constexpr std::array shells{
    Shell{0, -6, 54, 62, {1, 0.16, 0.05}}, Shell{0.9, 26, 42, 50, {1, 0.62, 0.18}},
    Shell{1.5, -32, 46, 54, {0.25, 0.5, 1}}, Shell{2.2, 12, 58, 66, {0.3, 1, 0.38}},
    Shell{2.9, -10, 44, 76, {1, 0.78, 0.45}}};

double rises(const Shell& shell) { return squareRoot(2 * shell.height / gravity); }
double bursts(const Shell& shell) { return shell.lit + rises(shell); }

// Of what goes up, at a time (s).
Frame tailAt(const Shell& shell, double t) {
    const double left = bursts(shell) - t;
    return {.origin = {shell.aside, shell.height - gravity / 2 * left * left, 0}};
}

// White-hot, then in its own colour, then an ember; some flicker as they go out.
PointLook starAt(const Color& color, double age, double life, double number, double size) {
    const double part = std::clamp(age / life, 0.0, 1.0), hot = std::max(0.0, 1 - 6 * part);
    const double flicker = part > 0.6 && std::fmod(17 * number + 24 * age, 1.0) > 0.6 ? 0.15 : 1;
    const double light = flicker * 14 * (1 - part) * (1 - part);
    PointLook look{size * (0.6 + 0.4 * (1 - part)), {}, 0.05};
    for (int c = 0; c < 3; ++c)
        look.color[c] = light * (hot + (1 - hot) * color[c]) + 0.15 * (1 - part) * (c == 0);
    return look;
}

// Adds a source, and how what it brings is seen.
void addSparks(Scene& scene, SourceOptions source, int spare, const Color& color, double size) {
    World& world = scene.world;
    source.spare = world.add({SimplicialComplex(0), {}}, {.density = 1e-3, .spare = spare});
    world.act<Source>(source);
    Look look{.object = source.spare, .material = Material::spark, .radius = size};
    look.point = [=](std::int32_t id, double age) {
        return starAt(color, age, lifespanOf(source, id), numberOf(id, source.seed, 9), size);
    };
    scene.view.looks.push_back(std::move(look));
}

void addShell(Scene& scene, const Shell& shell, int stars, std::uint64_t seed) {
    const std::string number = std::to_string(scene.view.looks.size() / 2 + 1);
    addSparks(scene,
              {.name = "tail " + number,
               .nozzle = {{0, 0, 0}},
               .velocity = {0, -4, 0},
               .motion = [shell](double t) { return tailAt(shell, t); },
               .every = 1 / shots,
               .from = shell.lit,
               .until = bursts(shell),
               .scatter = 0.2,
               .scatterVelocity = 2.5,
               .lifespan = tailLives,
               .lifespanSpread = tailLives / 2,
               .seed = seed + 100},
              static_cast<int>(1.5 * tailLives * shots) + 2, {1, 0.55, 0.2}, 0.13);
    addSparks(scene,
              {.name = "burst " + number,
               .nozzle = std::vector<Vec<double>>(static_cast<std::size_t>(stars)),
               .motion = [shell](double) { return tailAt(shell, bursts(shell)); },
               .every = 100,
               .from = bursts(shell),
               .scatter = 0.3,
               .scatterVelocity = shell.speed,
               .lifespan = burns,
               .lifespanSpread = burns / 3,
               .seed = seed},
              stars, shell.color, 0.26);
}

// Drag of the air on a spark, after the solve: v' = -c |v| v, to the end of a substep.
void slowDown(World& world, double h) {
    const int count = static_cast<int>(world.start.size());
    express(
        world, {0, count},
        [h](Point& p, double) { p.v = (1 / (1 + h * perMetre * length(p.v))) * p.v; }, "drag");
}

View viewOf() {
    View view;
    view.cameras = {{.eye = {4, 6, 212}, .target = {0, 29, 0}, .focalLength = 42}};
    view.groundSize = 60;
    view.glowCenter = {0, 0, -40};
    view.glow = 0;
    view.stage = {.dim = 0.97,
                  .mirror = 0.5,
                  .mirrorFades = 60,
                  .vignette = 0.15,
                  .floor = {0.01, 0.014, 0.022}};
    return view;
}

}  // namespace

Scene fireworks(const Knobs& knobs) {
    Scene scene;
    scene.view = viewOf();
    const int stars = knobs.byQuality(500, 1200, 3000);
    for (std::size_t i = 0; i < shells.size(); ++i)
        addShell(scene, shells[i], stars, knobs.seed + i);
    World& world = scene.world;
    world.act<Gravity>(GravityOptions{.acceleration = {0, -gravity, 0}});
    slowDown(world, 1.0 / (24 * substeps));
    scene.options.schedule = {.substeps = substeps, .iterations = 1};
    scene.lead = lead;
    scene.seconds = 6.1;

    const auto oldest = [](const Snapshot& at) {
        double most = 0;
        for (std::size_t v = 0; v < at.positions.size(); ++v)
            if (at.isHere(static_cast<int>(v))) most = std::max(most, at.ages[v]);
        return most;
    };
    scene.metrics = {countThere("alight", 0, static_cast<double>(world.start.size())),
                     {.name = "oldest",
                      .unit = "s",
                      .measure = oldest,
                      .low = 0,
                      .high = burns * 4 / 3 + 1.0 / 24},
                     contactFailures()};
    char fact[120];
    std::snprintf(fact, sizeof fact, "%zu shells of %d stars; none is there before its burst",
                  shells.size(), stars);
    scene.facts = {fact};
    return scene;
}

}  // namespace plait
