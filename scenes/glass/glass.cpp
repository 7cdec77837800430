#include "glass.h"

#include "../parts/measures.h"
#include "../parts/views.h"
#include "setting.h"
#include "shards.h"

#include <plait/complex/solid_shapes.h>
#include <plait/forces/gravity.h>
#include <plait/fracture/welds.h>
#include <plait/patterns/pattern.h>
#include <plait/pieces/piece.h>

#include <algorithm>
#include <array>

namespace plait {
namespace {

constexpr double side = 0.6, thickness = 0.004, low = 0.09;  // m, of the pane, and its lower edge
constexpr double bar = 0.03, depth = 0.04;                   // m, of the frame
constexpr double radius = 0.02;                              // m, of the ball
constexpr PlanePoint struck{0.35, 0.33};                     // m, in the pane
constexpr double ahead = 0.2;   // m, of the pane, where the ball begins
constexpr double skin = 8e-6;   // m: two are within the kerf
constexpr double bevel = 3e-4;  // m
constexpr double steel = 7850;  // kg/m^3

// What the frame stands on, two corners.
constexpr double wide = side / 2 + 2 * bar;
constexpr std::array<Vec<double>, 2> foot{{{-wide, 1e-4, -depth}, {wide, low - bar - 1e-4, depth}}};

// Below, right, above, left of the pane.
std::array<int, 4> addFrame(World& world, double kerf) {
    const double l = side / 2 + kerf, b = low - kerf, t = low + side + kerf, d = depth / 2;
    return {addPinned(world, boxSurface({-l - bar, b - bar, -d}, {l + bar, b, d})),
            addPinned(world, boxSurface({l, b, -d}, {l + bar, t, d})),
            addPinned(world, boxSurface({-l - bar, t, -d}, {l + bar, t + bar, d})),
            addPinned(world, boxSurface({-l - bar, b, -d}, {-l, t, d}))};
}

Pattern patternOf(const Knobs& knobs) {
    const Pane pane{.width = side,
                    .height = side,
                    .thickness = thickness,
                    .leastCell = knobs.byQuality(60e-6, 16e-6, 6e-6)};
    const int cells = knobs.byQuality(170, 620, 3150);
    return cut(pane, starSites(pane, {.centre = struck}, cells, knobs.seed));
}

View viewOf(const World& world, const std::vector<int>& cells, int ball) {
    constexpr int spare = 4;
    const Range& round = world.pieces[ball];
    View view;
    view.looks = {lookOf({round.first, round.last - spare}, Material::steel, radius),
                  {.object = {world.pieces[cells.front()].first, world.pieces[cells.back()].last},
                   .material = Material::glass,
                   .color = {0.25, 0.5, 0.45}}};
    const double l = side / 2, t = low + side, d = depth / 2;
    constexpr double lip = 0.001;  // m, by which the frame hides the pane's own edge
    const std::array<std::array<Vec<double>, 2>, 5> bars{
        {{{{-l - bar, low - bar, -d}, {l + bar, low + lip, d}}},
         {{{l - lip, low, -d}, {l + bar, t, d}}},
         {{{-l - bar, t - lip, -d}, {l + bar, t + bar, d}}},
         {{{-l - bar, low, -d}, {-l + lip, t, d}}},
         foot}};
    for (const auto& [from, to] : bars)
        view.props.push_back(
            {block({.width = to.x - from.x, .height = to.y - from.y, .depth = to.z - from.z},
                   {.origin = from}),
             Material::matte,
             {0.012, 0.013, 0.016}});
    view.cameras = {{.eye = {-0.72, 0.6, 1.5}, .target = {0.03, 0.34, 0}, .focalLength = 40}};
    view.groundSize = 1.3;
    view.glowCenter = {0, 0.4, 0};
    view.glow = 0.7;
    return view;
}

Metric speedOf(const World& world, int piece) {
    return {.name = "ball",
            .unit = "m/s",
            .measure = [v = world.pieces[piece].first](const Snapshot& at) {
                return length(at.velocities[v]);
            }};
}

// Through the break at a twentieth, while the camera goes around, and as it was.
std::vector<Take> takesOf(const Camera& left, double seconds) {
    constexpr double picture = 1.0 / 480, from = 6 * picture, to = 0.16;
    Camera start = left, right = left;
    start.time = from;
    right.time = to;
    right.eye = {0.6, 0.5, 1.5};
    return {
        {.from = from, .to = to, .slow = 20, .words = "20 times slower", .cameras = {start, right}},
        {.from = 0, .to = seconds}};
}

}  // namespace

Scene glass(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const Pattern pattern = patternOf(knobs);
    const Vec<double> corner{-side / 2, low, 0};
    std::vector<int> cells;
    for (const Cell& cell : pattern.cells) {
        Shape shape = prismOf(cell, thickness, bevel);
        for (Vec<double>& x : shape.positions) x += corner;
        cells.push_back(addShard(world, shape));
    }
    const std::array<int, 4> frame = addFrame(world, pattern.pane.kerf);
    addPinned(world, boxSurface(foot[0], foot[1]));
    addPinned(world, boxSurface({-6, -0.2, -6}, {6, 0, 12}));
    addPiece(world, sphere({.subdivisions = 2, .radius = radius}),
             {.density = steel,
              .shift = corner + Vec<double>{struck.x, struck.y, -ahead},
              .velocity = {0, 0, knobs.number("speed")}},
             "ball");
    const int ball = static_cast<int>(world.pieces.size()) - 1;
    const std::vector<Weld> welds = weldsOf(pattern, corner, cells, frame);
    weldPieces(world, welds,
               {.matter = {.seed = knobs.seed, .plate = thickness, .density = glassDensity}});
    meetAll(world, skin, {0.4});
    world.act<Gravity>(GravityOptions{});

    // Slow motion with another substep would break another pane: a picture each at 1/20.
    scene.options.schedule = {.substeps = 1, .frameRate = {480, 1}, .collisionPasses = 1};
    scene.seconds = 1.2;
    const Shards shards(world, welds, cells);
    scene.metrics = {shards.count({knobs.byQuality(25.0, 120.0, 300.0), double(cells.size()), 0.2}),
                     shards.hanging({50, 98, 0.2}), speedOf(world, ball), lowestOf(world, cells),
                     contactFailures()};
    scene.view = viewOf(world, cells, ball);
    scene.view.takes = takesOf(scene.view.cameras[0], scene.seconds);
    return scene;
}

}  // namespace plait
