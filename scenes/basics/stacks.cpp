// A wall of bricks and a pyramid of balls, into which one more rolls.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "basics.h"

#include <plait/complex/solid_shapes.h>
#include <plait/contacts/pieces/piece_contacts.h>
#include <plait/forces/gravity.h>
#include <plait/pieces/piece.h>
#include <plait/stencils.h>

#include <algorithm>

namespace plait {
namespace {

constexpr double coat = 2e-4;                         // m, of what is between two, to either side
constexpr Vec<double> brick{0.06, 0.06, 0.12};        // m
constexpr double smallBall = 0.04, largeBall = 0.06;  // m, radii
constexpr double pyramidAt = 0.26,
                 rollFrom = -0.75;  // m: where the balls lie, where one more starts

class Yard {
public:
    Yard(World& world, double friction) : world_(&world), friction_(friction) {}

    std::vector<Surface> surfaces;

    Range add(const Shape& shape, const PieceMatter& matter) {
        const Piece piece = addPiece(*world_, shape, matter);
        surfaces.push_back({.vertices = piece.surface(),
                            .thickness = coat,
                            .staticFriction = friction_,
                            .dynamicFriction = friction_,
                            .self = Self::none});
        return piece.vertices;
    }
    void hold(const Vec<double>& low, const Vec<double>& high) {
        world_->pin(pointStencils(add(boxSurface(low, high), {})));
    }

private:
    World* world_;
    double friction_;
};

// Rows of bricks, each half a brick aside of the one below.
Range addWall(Yard& yard, int rows) {
    Range all{};
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < 4 - row % 2; ++i) {
            const Range one =
                yard.add(boxSurface(-0.5 * brick, 0.5 * brick),
                         {.density = 1800,
                          .shift = {0, 2 * coat + brick.y / 2 + row * (brick.y + 2 * coat),
                                    (i - 0.5 * (3 - row % 2)) * (brick.z + 2 * coat)}});
            if (all.last == 0) all.first = one.first;
            all.last = one.last;
        }
    return all;
}

// Squares of 3, 2 and 1 balls each way, in a tray.
Range addPyramid(Yard& yard, int subdivisions) {
    const double apart = 2 * (smallBall + coat);
    Range all{};
    for (int layer = 0; layer < 3; ++layer)
        for (int i = 0; i < (3 - layer) * (3 - layer); ++i) {
            const int each = 3 - layer, row = i / each;
            const Vec<double> place{i % each - 0.5 * (each - 1), layer * squareRoot(0.5),
                                    row - 0.5 * (each - 1)};
            const Range one = yard.add(
                sphere({.subdivisions = subdivisions, .radius = smallBall}),
                {.density = 900,
                 .shift = Vec<double>{pyramidAt, smallBall + 2 * coat, 0} + apart * place});
            if (all.last == 0) all.first = one.first;
            all.last = one.last;
        }
    return all;
}

void addTray(Yard& yard) {
    constexpr double inner = 3 * (smallBall + 2 * coat), wide = 0.015, high = 0.03;
    for (const double side : {-1.0, 1.0}) {
        const double x = pyramidAt + side * (inner + wide / 2), z = side * (inner + wide / 2);
        yard.hold({x - wide / 2, 0, -inner - wide}, {x + wide / 2, high, inner + wide});
        yard.hold({pyramidAt - inner, 0, z - wide / 2}, {pyramidAt + inner, high, z + wide / 2});
    }
}

Look lookOf(Range object, const std::array<double, 3>& color, bool sharp) {
    return {
        .object = object, .material = Material::matte, .color = color, .radius = 0, .sharp = sharp};
}

}  // namespace

Scene stacks(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    Yard yard(world, knobs.number("friction"));
    const int fine = knobs.byQuality(1, 2, 2);
    const Range wall = addWall(yard, 6), balls = addPyramid(yard, fine);
    const double speed = knobs.number("speed");
    const Range rolling = yard.add(sphere({.subdivisions = 2, .radius = largeBall}),
                                   {.density = 7800,
                                    .shift = {rollFrom, largeBall + 2 * coat, 0.03},
                                    .velocity = {speed, 0, 0},
                                    .spin = {0, 0, -speed / largeBall}});
    const int tray = rolling.last;
    addTray(yard);
    const Range planks{tray, static_cast<int>(world.start.size())};
    yard.hold({-3, -0.2, -3}, {3, 0, 3});
    world.act<Gravity>(GravityOptions{});
    holdPieces(world, {.name = "pieces"});
    meetPieces(world, yard.surfaces, {.order = 1});
    scene.options.integrator = Integrator::bdf2;
    scene.options.schedule = {.substeps = 20, .frameRate = {24, 1}, .collisionPasses = 8};
    scene.seconds = 3;
    scene.metrics = {selfIntersections(world, {wall.first, rolling.last}, {0, 0}),
                     lowestHeight({-0.2001, infinity}), contactFailures()};
    scene.view = viewOf({wall, balls}, {0.05, 0.14, 0}, 0.75, Material::matte, {-1.2, 0.7, 1.5});
    scene.view.looks = {lookOf(wall, {0.55, 0.16, 0.09}, true),
                        lookOf(balls, {0.72, 0.52, 0.16}, false),
                        {.object = rolling, .material = Material::steel, .radius = 0},
                        lookOf(planks, {0.22, 0.13, 0.07}, true)};
    scene.view.groundHeight = 0;
    return scene;
}

}  // namespace plait
