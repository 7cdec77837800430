// Sheets that lie on each other.
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"
#include "basics.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <array>
#include <string>
#include <vector>

namespace plait {
namespace {

constexpr int layers = 3;
constexpr double side = 0.7, thickness = 0.002;  // m

// Adds the sheet that `place` others lie below, turned on them.
Range addLayer(World& world, int place, int n) {
    const double turn = place * pi / 6;
    const Vec<double> across{cosine(turn), 0, -sine(turn)}, up{-sine(turn), 0, -cosine(turn)};
    const Vec<double> middle{0, 0.02 + 0.03 * place, 0};
    return world.add(
        grid({.columns = n, .rows = n, .width = side, .height = side},
             {.origin = middle - 0.5 * side * (across + up), .across = across, .up = up}),
        {.density = 0.15});
}

View viewOfLayers(const std::vector<Range>& sheets, Range ball) {
    constexpr std::array<std::array<double, 3>, layers> colors{
        {{0.880, 0.791, 0.658}, {0.768, 0.376, 0.275}, {0.578, 0.032, 0.014}}};
    View view = viewOf(sheets, {0, -0.2, 0}, 0.68, Material::cotton, {1.0, 0.75, 2.2});
    for (std::size_t i = 0; i < sheets.size(); ++i) view.looks[i].color = colors[i];
    view.looks.push_back(
        {.object = ball, .material = Material::matte, .color = {0.254, 0.216, 0.188}});
    view.groundHeight = -0.62;
    addBar(view, {0, view.groundHeight, 0}, {0, -0.35, 0}, 0.03, Material::steel);
    return view;
}

}  // namespace

// Three sheets of cotton fall on a ball of 20 cm radius and on each other.
Scene layeredSheets(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int n = knobs.byQuality(17, 33, 65);
    constexpr double radius = 0.2, friction = 0.3;
    std::vector<Range> sheets;
    std::vector<Surface> surfaces;
    std::vector<int> threads;
    for (int i = 0; i < layers; ++i) {
        const Range sheet = addLayer(world, i, n);
        sheets.push_back(sheet);
        surfaces.push_back(roughSurface(sheet, thickness, friction));
        surfaces.back().layer = i + 1;
        const std::string name = std::to_string(i + 1) + " ";
        const std::vector<int> links = weave(world, sheet, gridThreads(n), 15, name, 0.01);
        threads.insert(threads.end(), links.begin(), links.end());
        world.constrain(bendRows(world.complex, sheet, world.rest, 1e-6),
                        {.name = name + "bend", .order = 3});
    }
    const Range ball =
        world.add(sphere({.subdivisions = 3, .radius = radius}, {.origin = {0, -radius, 0}}));
    world.pin(pointStencils(ball));
    surfaces.push_back(roughSurface(ball, thickness, friction));
    surfaces.back().self = Self::none;
    world.act<Gravity>(GravityOptions{});
    meet(world, surfaces, {.order = 4, .layerShock = knobs.number("shock")});
    scene.options.schedule = {
        .substeps = knobs.byQuality(16, 32, 64), .iterations = 3, .collisionPasses = 3};
    scene.options.damping = 0.05;
    scene.seconds = 2;
    scene.metrics = {greatestStrain(world, threads, {0, 2}), commonStrain(world, threads, {0, 2}),
                     selfIntersections(world, {sheets.front().first, ball.last}, {0, 0}),
                     leastGap(world, {sheets.front().first, sheets.back().last}, 2000 * thickness,
                              {1250 * thickness, infinity}),
                     contactFailures()};
    scene.view = viewOfLayers(sheets, ball);
    return scene;
}

}  // namespace plait
