// Balls on a taut elastic sheet: either moves the other.
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "basics.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <array>

namespace plait {
namespace {

constexpr double thickness = 0.0015;           // m, of sheet and balls, to either side
constexpr double radius = 0.55, drawn = 1.15;  // m, of the rim; of the sheet at rest
constexpr double density = 0.3;                // kg/m^2
constexpr double bed = 0.45;                   // m, above the floor
constexpr double stiffness = 250;              // N/m, of an edge
constexpr double heavy = 0.4;                  // kg, of the ball that falls
constexpr Vec<double> gravity{0, -9.81, 0};

// A steel ring, of pinned matter that meets nothing.
Range addRing(World& world) {
    constexpr int links = 72;
    Shape ring;
    Simplices edges;
    for (int i = 0; i < links; ++i) {
        const double a = 2 * pi * i / links;
        ring.positions.push_back({radius * cosine(a), 0, radius * sine(a)});
        edges.edges.push_back({i, (i + 1) % links});
    }
    ring.complex = SimplicialComplex(links, edges);
    const Range range = world.add(ring);
    world.pin(pointStencils(range));
    return range;
}

Range addSheet(World& world, int rings) {
    const Shape shape =
        disc({.rings = rings, .radius = radius / drawn}, {.across = {1, 0, 0}, .up = {0, 0, -1}});
    Matter matter{.density = density};
    for (const Vec<double>& x : shape.positions) matter.start.push_back(drawn * x);
    const Range sheet = world.add(shape, matter);
    world.pin(pointStencils({sheet.last - 6 * rings, sheet.last}));
    return sheet;
}

// A light ball that lies on the sheet, a heavy one that falls on it, and another light one.
std::vector<Piece> addBalls(World& world, double drop) {
    constexpr double low = 2 * thickness;
    std::vector<Piece> balls;
    for (const auto& [size, mass, x, y, z] : {std::array{0.05, 0.05, 0.2, low, 0.05},
                                              {0.08, heavy, -0.06, drop, 0.02},
                                              {0.065, 0.1, -0.22, low, -0.2}})
        balls.push_back(addSolid(
            world, sphere({.subdivisions = 1, .radius = size}, {.origin = {x, size + y, z}}),
            mass));
    return balls;
}

View viewOf(Range sheet, Range ring, const std::vector<Piece>& balls) {
    View view = plait::viewOf({sheet}, {0, 0.16, 0}, 1.2, Material::cotton, {0.3, 0.32, 2.1});
    view.looks.push_back(lookOf(ring, Material::steel, 0.018));
    for (const Piece& ball : balls)
        view.looks.push_back(lookOf(ball.surface(), Material::brass, 0.01));
    view.groundHeight = -bed;
    for (int i = 0; i < 4; ++i) {
        const double a = pi * (0.25 + 0.5 * i);
        const Vec<double> top{radius * cosine(a), 0, radius * sine(a)};
        addBar(view, {1.15 * top.x, -bed, 1.15 * top.z}, top, 0.014, Material::steel);
    }
    return view;
}

}  // namespace

Scene trampoline(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double drop = knobs.number("drop");
    const Range sheet = addSheet(world, knobs.byQuality(12, 20, 40));
    const std::vector<Piece> balls = addBalls(world, drop);
    const Range ring = addRing(world);

    world.act<Gravity>(GravityOptions{});
    world.constrain(
        restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest, 1 / stiffness),
        {.name = "stretch"});
    holdPieces(world, {.name = "balls", .order = 1});
    std::vector<Surface> surfaces{{.vertices = sheet, .thickness = thickness}};
    for (const Piece& ball : balls)
        surfaces.push_back(
            {.vertices = ball.surface(), .thickness = thickness, .self = Self::none});
    meet(world, surfaces, {.order = 2});
    const Range allBalls{balls.front().vertices.first, balls.back().vertices.last};
    addGround(world, allBalls, -bed, thickness, 3);
    scene.options.schedule = {
        .substeps = knobs.byQuality(32, 48, 96), .iterations = 6, .collisionPasses = 3};
    scene.seconds = 3;
    scene.metrics = {
        energyGain(world, gravity, heavy * 9.81 * drop, {-infinity, 1}),
        selfIntersections(world, {sheet.first, allBalls.last}, {0, 0}),
        height("heavy", balls[1].vertices.first, {-bed, infinity}),
        height("light", balls[0].vertices.first, {-bed, infinity}),
        contactFailures(),
    };
    scene.view = viewOf(sheet, ring, balls);
    return scene;
}

}  // namespace plait
