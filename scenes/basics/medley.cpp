// Points, edges and triangles in one world (S figure 21).
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"
#include "basics.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace plait {
namespace {

constexpr double side = 1, sag = 0.2;  // m, of the cloth; of its middle at the start
constexpr double span = 0.915;         // m, between the pins
constexpr double clothThickness = 0.002, ropeRadius = 0.009, beadRadius = 0.019;  // m

// A cloth that hangs from its corners like a hammock.
Range addHammock(World& world, int n) {
    const Shape shape = grid({.columns = n, .rows = n, .width = side, .height = side},
                             {.origin = {-0.5 * side, 0, 0.5 * side}, .up = {0, 0, -1}});
    Matter matter{.density = 0.2};
    for (const Vec<double>& x : shape.positions) {
        const double u = 2 * x.x / side, v = 2 * x.z / side;
        matter.start.push_back(
            {span / side * x.x, -0.5 * sag * (2 - u * u - v * v), span / side * x.z});
    }
    const Range cloth = world.add(shape, matter);
    world.pin({cloth.first, cloth.first + n - 1, cloth.last - n, cloth.last - 1});
    return cloth;
}

// Straight ropes one above the other, each turned on the one below.
std::vector<Range> addRopes(World& world, int links) {
    std::vector<Range> ropes;
    for (int i = 0; i < 3; ++i) {
        const double turn = 0.4 + i * pi / 3, y = 0.06 + 0.05 * i;
        const Vec<double> half{0.32 * cosine(turn), 0, 0.32 * sine(turn)};
        const Vec<double> middle{0, y, 0};
        ropes.push_back(
            world.add(chain({.links = links, .from = middle - half, .to = middle + half}),
                      {.density = 0.05}));
    }
    return ropes;
}

// Beads that fall one after the other, in a spiral of the golden angle.
Range addBeads(World& world, int count) {
    std::vector<Vec<double>> middles;
    for (int i = 0; i < count; ++i) {
        const double turn = 2.399963 * i, out = 0.12 * std::sqrt((i % 12 + 0.5) / 12);
        middles.push_back({out * cosine(turn), 0.25 + 0.025 * i, out * sine(turn)});
    }
    return world.add({SimplicialComplex(count), middles}, {.density = 0.004});
}

// How many beads are below all of the cloth.
Metric fallen(Range beads, Range cloth) {
    return {.name = "fallen",
            .unit = "",
            .measure =
                [=](const Snapshot& at) {
                    const auto lower = [](const Vec<double>& a, const Vec<double>& b) {
                        return a.y < b.y;
                    };
                    const auto all = at.positions.begin();
                    const double lowest =
                        std::min_element(all + cloth.first, all + cloth.last, lower)->y;
                    return static_cast<double>(
                        std::count_if(all + beads.first, all + beads.last,
                                      [&](const Vec<double>& x) { return x.y < lowest; }));
                },
            .low = 0,
            .high = 0};
}

View viewOf(Range cloth, const std::vector<Range>& ropes, Range beads) {
    View view = plait::viewOf({cloth}, {0, -0.1, 0}, 1.0, Material::cotton, {0.5, 1.05, 1.75});
    for (const Range rope : ropes) {
        view.looks.push_back(lookOf(rope, Material::rubber, ropeRadius));
        view.looks.back().color = {0.880, 0.791, 0.658};
    }
    view.looks.push_back(lookOf(beads, Material::brass, beadRadius));
    view.groundHeight = -0.6;
    for (const double x : {-0.5 * span, 0.5 * span})
        for (const double z : {-0.5 * span, 0.5 * span})
            addBar(view, {1.03 * x, view.groundHeight, 1.03 * z}, {x, 0.02, z}, 0.012,
                   Material::steel);
    return view;
}

}  // namespace

Scene medley(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int n = knobs.byQuality(21, 41, 81);
    const double friction = knobs.number("friction");
    const Range cloth = addHammock(world, n);
    const std::vector<Range> ropes = addRopes(world, knobs.byQuality(24, 36, 48));
    const Range beads = addBeads(world, static_cast<int>(knobs.number("beads")));

    world.act<Gravity>(GravityOptions{});
    std::vector<int> links = weave(world, cloth, gridThreads(n), 15, "", 0.01);
    world.constrain(bendRows(world.complex, cloth, world.rest, 1e-5), {.name = "bend", .order = 3});
    const Range strings{ropes.front().first, ropes.back().last};
    const std::vector<int> ropeLinks = edgeStencils(world.complex, strings);
    links.insert(links.end(), ropeLinks.begin(), ropeLinks.end());
    world.constrain(restRows<Stretch>(ropeLinks, world.rest),
                    {.name = "ropes", .order = 4, .direct = true});
    world.constrain(curveBendRows(world.complex, strings, world.rest, 1e-4),
                    {.name = "rope bend", .order = 5});
    meet(world,
         {roughSurface(cloth, clothThickness, friction),
          roughSurface(strings, ropeRadius, friction), roughSurface(beads, beadRadius, friction)},
         {.order = 6});
    scene.options.schedule = {
        .substeps = knobs.byQuality(20, 40, 80), .iterations = 3, .collisionPasses = 3};
    scene.options.damping = 0.05;
    scene.seconds = 3;
    scene.metrics = {greatestStrain(world, links, {-2, 2}),
                     selfIntersections(world, {cloth.first, beads.last}, {0, 0}),
                     fallen(beads, cloth), contactFailures()};
    scene.view = viewOf(cloth, ropes, beads);
    return scene;
}

}  // namespace plait
