#include "wine_glass.h"

#include "../parts/measures.h"
#include "../parts/views.h"
#include "goblet.h"
#include "setting.h"
#include "shards.h"

#include <plait/complex/solid_shapes.h>
#include <plait/forces/gravity.h>
#include <plait/fracture/welds.h>

namespace plait {
namespace {

constexpr double skin = 8e-6, kerf = 20e-6;   // m: two are within the kerf
constexpr double high = 0.72, back = 0.11;    // m, of the table, and from its edge to the glass
constexpr double board = 0.03, reach = 0.26;  // m, of the table
constexpr double hits = 0.77;                 // s, when it meets the floor
constexpr double broken = 0.1;                // s, shown slowly

View viewOf(const World& world, const std::vector<int>& shards) {
    View view;
    view.looks = {{.object = {world.pieces[shards.front()].first, world.pieces[shards.back()].last},
                   .material = Material::glass,
                   .color = {0.25, 0.5, 0.45}}};
    addBox(view, {-2 * reach, high - board, -reach}, {0, high, reach});
    // As it slides, as it breaks, and around it.
    view.cameras = {
        {.time = 0, .eye = {0.45, 0.95, 1.0}, .target = {-0.03, high + 0.03, 0}, .focalLength = 48},
        {.time = 0.4,
         .eye = {0.45, 0.95, 1.0},
         .target = {-0.03, high + 0.03, 0},
         .focalLength = 48},
        {.time = hits, .eye = {0.4, 0.12, 0.6}, .target = {0.15, 0.07, 0}, .focalLength = 48},
        {.time = hits + broken,
         .eye = {0.15, 0.17, 0.64},
         .target = {0.17, 0.06, 0},
         .focalLength = 44}};
    view.groundSize = 1.3;
    view.glowCenter = {0.1, 0.3, 0};
    view.glow = 0.7;
    return view;
}

}  // namespace

Scene wineGlass(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const SolidPattern pattern = cut(lumpsOf({.spacing = knobs.byQuality(0.012, 0.0075, 0.005),
                                              .seed = knobs.seed,
                                              .foot = {-back, high + 2 * skin, 0}}),
                                     kerf);
    std::vector<int> shards;
    for (const Shape& cell : pattern.cells)
        shards.push_back(addShard(world, cell, {knobs.number("speed"), 0, 0}));
    std::vector<double> friction(shards.size(), 0.4);
    addPinned(world, boxSurface({-2 * reach, high - board, -reach}, {0, high, reach}));
    friction.push_back(0.1);
    addPinned(world, boxSurface({-6, -0.2, -6}, {6, 0, 6}));
    friction.push_back(0.4);
    const std::vector<Weld> welds = weldsOf(pattern, shards);
    weldPieces(world, welds, {.matter = {.seed = knobs.seed, .density = glassDensity}});
    meetAll(world, skin, friction);
    world.act<Gravity>(GravityOptions{});

    // Slow motion with another substep would break another glass: a picture each at 1/20.
    scene.options.schedule = {.substeps = 2, .frameRate = {480, 1}, .collisionPasses = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.seconds = 2.4;
    const Shards together(world, welds, shards);
    scene.metrics = {
        together.count({knobs.byQuality(10.0, 25.0, 40.0), double(shards.size()), hits + 0.2}),
        lowestOf(world, shards), contactFailures()};
    scene.view = viewOf(world, shards);
    scene.view.takes = {{.from = 0, .to = hits},
                        {.from = hits, .to = hits + broken, .slow = 20, .words = "20 times slower"},
                        {.from = hits + broken, .to = scene.seconds}};
    return scene;
}

}  // namespace plait
