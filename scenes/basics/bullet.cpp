#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "basics.h"

#include <plait/contacts/search/nearest.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/sheets/inextensible.h>
#include <plait/stencils.h>

#include <array>
#include <cmath>
#include <vector>

namespace plait {
namespace {

constexpr double radius = 0.02;  // m

// In m: from the middle of the ball to the sheet; below 0 where it is behind.
Metric clearance(int ball, const std::vector<int>& triangles, double least) {
    const auto measure = [=](const Snapshot& at) {
        double found = infinity;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const Pairing pair{{ball, triangles[i], triangles[i + 1], triangles[i + 2]}, 1, 3};
            std::array<Vec<double>, 4> x;
            for (std::size_t n = 0; n < 4; ++n) x[n] = at.positions[pair.vertices[n]];
            const Nearest now = nearest(pair, x);
            const double distance = length(now.apart);
            if (distance >= std::fabs(found)) continue;
            // Past the sheet's edge it may lie on either side.
            const bool over = now.weight[1] < 0 && now.weight[2] < 0 && now.weight[3] < 0;
            const bool behind = over && dot(now.apart, cross(x[2] - x[1], x[3] - x[1])) < 0;
            found = behind ? -distance : distance;
        }
        return found;
    };
    return {.name = "clearance",
            .unit = "m",
            .measure = measure,
            .low = least,
            .high = infinity,
            .caption = true};
}

}  // namespace

// A ball of 2.7 g, as in table tennis, flies 5 cm a substep against a curtain (S figure 14).
Scene bullet(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    constexpr int n = 33;
    constexpr double side = 0.8;
    const Range sheet = world.add(
        grid({.columns = n, .rows = n, .width = side, .height = side}, {.origin = {0, -side, 0}}),
        {.density = 0.2});
    const Range ball =
        world.add({SimplicialComplex(1), {{0.47 * side, -0.53 * side, knobs.number("distance")}}},
                  {.density = 0.0027, .velocity = {{0, 0, -knobs.number("speed")}}});
    const std::vector<int> pins = pointStencils({n * (n - 1), n * n});
    world.pin(pins);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet, {.strands = false, .aggregates = true, .mending = 0});
    const bool path = knobs.text("detection") == "path";
    const auto surface = [](Range vertices, double thickness) {
        return Surface{.vertices = vertices,
                       .thickness = thickness,
                       .staticFriction = 0,
                       .dynamicFriction = 0,
                       .self = Self::none};
    };
    meet(world, {surface(sheet, 0), surface(ball, radius)},
         {.detection = path ? Detection::path : Detection::end, .order = 3});
    constexpr double floor = -1.05;
    addGround(world, ball, floor, radius, 4);
    scene.options.schedule = {.substeps = 8, .iterations = 20, .collisionPasses = 20};
    scene.seconds = 1;
    scene.metrics = {clearance(ball.first, triangleStencils(world.complex, sheet),
                               path ? 0.9 * radius : -infinity),
                     greatestStrain(world, sheet, {0, 10}), contactFailures()};
    View& view = scene.view;
    view = viewOf({sheet, ball}, {0.5 * side, -0.55 * side, 0}, 1.4, Material::cotton,
                  {1.6, 0.35, 1.6});
    view.looks[1] = lookOf(ball, Material::brass, radius);
    view.groundHeight = floor;
    addBar(view, {-0.1, 0.01, 0}, {side + 0.1, 0.01, 0}, 0.012, Material::steel);
    for (const double x : {-0.1, side + 0.1})
        addBar(view, {x, view.groundHeight, 0}, {x, 0.03, 0}, 0.015, Material::matte);
    return scene;
}

}  // namespace plait
