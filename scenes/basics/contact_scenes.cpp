// Cloth that lies, hangs and slides on things and on itself.
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"
#include "basics.h"

#include <plait/contacts/solids/collider.h>
#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <vector>

namespace plait {
namespace {

constexpr double ballRadius = 0.25;  // m

// A ball needs no mesh to be met: its vertices and edges would be contacts by the thousand that a
// formula has none of. What is drawn, and what crossings are asked of, is the mesh in any case.
void layOn(World& world, Range cloth, Range ball, const Knobs& knobs) {
    const double friction = knobs.number("friction"), thickness = knobs.number("thickness");
    const Surface sheet = roughSurface(cloth, thickness, friction);
    Surface mesh = roughSurface(ball, thickness, friction);
    mesh.self = Self::none;
    if (knobs.text("ball") == "mesh") return meet(world, {sheet, mesh}, {.order = 4});
    collide(world,
            {{.solid = Solid::sphere(ballRadius + thickness),
              .frame = {.origin = {0, -ballRadius, 0}},
              .staticFriction = friction,
              .dynamicFriction = friction}},
            {sheet}, {.order = 4});
    meet(world, {sheet}, {.order = 5});
}

}  // namespace

// 1 m of cotton falls from 5 cm above a ball of 25 cm radius.
Scene sheetOnSphere(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int n = knobs.byQuality(32, 64, 128);
    const Range cloth =
        world.add(grid({.columns = n, .rows = n},
                       {.origin = {-0.5, 0.05, 0.5}, .across = {1, 0, 0}, .up = {0, 0, -1}}),
                  {.density = 0.15});
    const Range ball = world.add(
        sphere({.subdivisions = 4, .radius = ballRadius}, {.origin = {0, -ballRadius, 0}}));
    world.pin(pointStencils(ball));
    world.act<Gravity>(GravityOptions{});
    const std::vector<int> threads =
        weave(world, cloth, gridThreads(n), 15, "", knobs.number("mending") / 100);
    world.constrain(bendRows(world.complex, cloth, world.rest, 1e-6), {.name = "bend", .order = 3});
    layOn(world, cloth, ball, knobs);
    scene.options.schedule = {
        .substeps = knobs.byQuality(16, 32, 64), .iterations = 2, .collisionPasses = 2};
    scene.options.damping = 0.05;
    scene.seconds = 4;
    scene.metrics = {greatestStrain(world, threads, {0, 2}), commonStrain(world, threads, {0, 4}),
                     selfIntersections(world, {cloth.first, ball.last}, {0, 0}), contactFailures()};
    View& view = scene.view;
    view = viewOf({cloth, ball}, {0, -0.24, 0}, 0.88, Material::cotton, {1.0, 0.75, 2.2});
    view.looks[1].material = Material::matte;
    view.looks[1].color = {0.254, 0.216, 0.188};
    view.groundHeight = -0.75;
    addBar(view, {0, -0.75, 0}, {0, -0.45, 0}, 0.03, Material::steel);
    return scene;
}

}  // namespace plait
