// Shards of glass fall into a heap.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "basics.h"

#include <plait/complex/solid_shapes.h>
#include <plait/contacts/pieces/piece_contacts.h>
#include <plait/forces/gravity.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/numbers/splitmix.h>
#include <plait/pieces/piece.h>
#include <plait/stencils.h>

#include <algorithm>

namespace plait {
namespace {

constexpr double thickness = 1e-4;  // m, of what is between two, to either side
constexpr double glass = 2500;      // kg/m^3
constexpr double pane = 0.004;      // m
constexpr double pitch = 0.07;      // m, from shard to shard as they start

struct Heap {
    std::vector<Surface> surfaces;
    double friction;

    Piece add(World& world, const Shape& shape, const PieceMatter& matter) {
        const Piece piece = addPiece(world, shape, matter, "shard");
        surfaces.push_back({.vertices = piece.surface(),
                            .thickness = thickness,
                            .staticFriction = friction,
                            .dynamicFriction = friction,
                            .self = Self::none});
        return piece;
    }
    void addFloor(World& world, const Vec<double>& low, const Vec<double>& high) {
        const Piece piece = add(world, boxSurface(low, high), {});
        world.pin(pointStencils(piece.vertices));
    }
};

// In so many columns each way.
Range addShards(World& world, Heap& heap, int count, int columns) {
    Splitmix chance(1);
    const auto between = [&](double low, double high) {
        return low + (high - low) * chance.next();
    };
    const int first = static_cast<int>(world.start.size());
    for (int i = 0; i < count; ++i) {
        const int corners = 3 + static_cast<int>(between(0, 4));
        const Shape shape =
            prismSurface({.corners = corners, .radius = between(0.01, 0.03), .height = pane});
        const Vec<double> axis{chance.both(), chance.both(), chance.both()};
        const Vec<double> turn = (between(0, 3) / length(axis)) * axis;
        const int layer = i / (columns * columns), row = i / columns % columns;
        const Vec<double> place{i % columns - 0.5 * (columns - 1), layer + 1.0,
                                row - 0.5 * (columns - 1)};
        heap.add(world, shape, {.density = glass, .turn = turnBy(turn), .shift = pitch * place});
    }
    return {first, static_cast<int>(world.start.size())};
}

// Edges of shards that go through faces of others, by exact arithmetic.
Metric overlaps(const World& world, Range shards) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < world.complex.count(2); ++t)
        if (world.complex.triangle(t)[0] < shards.last)
            triangles.push_back(world.complex.triangle(t));
    return {.name = "overlaps",
            .unit = "",
            .measure =
                [triangles](const Snapshot& at) {
                    return static_cast<double>(countIntersections(at.positions, triangles));
                },
            .low = 0,
            .high = 0,
            .caption = true};
}

// Root of the mean square over all vertices.
Metric restlessness(Range shards) {
    return {.name = "speed",
            .unit = "m/s",
            .measure =
                [shards](const Snapshot& at) {
                    double sum = 0;
                    for (int v = shards.first; v < shards.last; ++v)
                        sum += dot(at.velocities[v], at.velocities[v]);
                    return squareRoot(sum / shards.size());
                },
            .low = 0,
            .high = 5,
            .caption = true};
}

View viewOf(Range shards, double size) {
    View view =
        plait::viewOf({shards}, {0, 0.2 * size, 0}, size, Material::steel, {0.75, 0.6, 1.6});
    view.looks.front() = {.object = shards,
                          .material = Material::matte,
                          .color = {0.35, 0.62, 0.58},
                          .radius = 0,
                          .sharp = true};
    view.groundHeight = 0;
    return view;
}

}  // namespace

Scene pile(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    Heap heap{.surfaces = {}, .friction = knobs.number("friction")};
    const int columns = knobs.byQuality(4, 8, 10);
    const Range shards = addShards(world, heap, knobs.byQuality(160, 1000, 2000), columns);
    heap.addFloor(world, {-3, -0.2, -3}, {3, 0, 3});
    world.act<Gravity>(GravityOptions{});
    holdPieces(world, {.name = "pieces"});
    meetPieces(world, heap.surfaces, {.order = 1});
    scene.options.integrator = Integrator::bdf2;
    scene.options.schedule = {.substeps = 20, .frameRate = {24, 1}, .collisionPasses = 4};
    scene.seconds = 3;
    scene.metrics = {overlaps(world, shards), restlessness(shards), contactFailures()};
    scene.view = viewOf(shards, 0.2 + pitch * columns);
    return scene;
}

}  // namespace plait
