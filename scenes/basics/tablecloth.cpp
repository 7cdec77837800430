// What stands on a cloth stays where it is if the cloth is pulled away fast enough.
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"
#include "basics.h"

#include <plait/complex/solid_shapes.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plait {
namespace {

constexpr double thickness = 0.0015;  // m, of cloth, table and tins, to either side
constexpr double clearance = 0.004;   // m, from cloth to table at the start
// m, of the cloth: across, on the table, and hanging down before it. All multiples of the coarsest
// cell, so that a row of vertices lies along the edge of the table. Behind the table it would have
// to turn a corner as it is pulled, and without tension fly up instead and take along what stands
// on it.
constexpr double width = 0.6, depth = 0.5, before = 0.15, coarsest = 0.025;
constexpr Vec<double> tableLow{-0.35, -0.05, -depth - 0.05}, tableHigh{0.35, 0, -clearance};

constexpr double floorHeight = -0.6;  // m

// A closed tin that stands on `foot`.
Shape tin(double radius, double height, const Vec<double>& foot) {
    constexpr int sides = 10;
    constexpr double edge = 0.004;  // m, by which its rims are broken
    const std::array<std::array<double, 2>, 4> profile{
        {{radius - edge, 0}, {radius, edge}, {radius, height - edge}, {radius - edge, height}}};
    Shape shape;
    Simplices faces;
    for (const auto& [r, y] : profile)
        for (int k = 0; k < sides; ++k)
            shape.positions.push_back(foot + Vec<double>{r * cosine(2 * pi * k / sides), y,
                                                         -r * sine(2 * pi * k / sides)});
    const int bottom = static_cast<int>(shape.positions.size()), top = bottom + 1;
    shape.positions.push_back(foot);
    shape.positions.push_back(foot + Vec<double>{0, height, 0});
    for (int k = 0; k < sides; ++k) {
        const int next = (k + 1) % sides, rim = bottom - sides;
        faces.triangles.push_back({bottom, next, k});
        faces.triangles.push_back({top, rim + k, rim + next});
        for (int low = 0; low < rim; low += sides) {
            faces.triangles.push_back({low + k, low + next, low + sides + next});
            faces.triangles.push_back({low + k, low + sides + next, low + sides + k});
        }
    }
    shape.complex = SimplicialComplex(top + 1, faces);
    return shape;
}

// Where what is `way` (m) from the cloth's rear hem lies at the start: on the table, and down
// before it.
Vec<double> laid(double x, double way) {
    return {x, clearance + std::min(0.0, depth - way), std::min(0.0, way - depth)};
}

// s; the latter to get up to speed, and to stop
constexpr double pullStart = 0.1, hurry = 0.15;
constexpr double run = 1.2;  // m, that the hem is pulled

// Where the front hem has got to (m), from where it hangs: away from the table, at `speed` (m/s)
// for most of the way, and up where the cloth has left the table.
Vec<double> pulled(double t, double speed) {
    constexpr double rise = 0.55;  // m
    const double steady = run / speed - hurry;
    // Part of `hurry` that is over, and the way by then, in speed x hurry.
    const auto hurried = [](double s) { return s * s * s * (1 - 0.5 * s); };
    const double since = std::clamp(t - pullStart, 0.0, steady + 2 * hurry);
    double way = speed * (since - 0.5 * hurry);
    if (since < hurry) way = speed * hurry * hurried(since / hurry);
    if (since > hurry + steady)
        way = run - speed * hurry * hurried((steady + 2 * hurry - since) / hurry);
    const double s = std::clamp((way - 0.6) / (run - 0.6), 0.0, 1.0);
    return {0, rise * s * s * (3 - 2 * s), way};
}

// In m: how far the middle of the tin that went furthest has gone.
Metric tinsMoved(const World& world, const std::vector<Piece>& tins) {
    const auto middle = [](const std::vector<Vec<double>>& x, Range tin) {
        Vec<double> sum{};
        for (int v = tin.first; v < tin.last; ++v) sum += x[static_cast<std::size_t>(v)];
        return (1.0 / tin.size()) * sum;
    };
    std::vector<Vec<double>> start;
    for (const Piece& tin : tins) start.push_back(middle(world.start, tin.surface()));
    return {.name = "moved",
            .unit = "m",
            .measure =
                [=](const Snapshot& at) {
                    double most = 0;
                    for (std::size_t i = 0; i < tins.size(); ++i)
                        most = std::max(most,
                                        length(middle(at.positions, tins[i].surface()) - start[i]));
                    return most;
                },
            .caption = true};
}

Range addCloth(World& world, int columns, int rows, double cell) {
    Matter cotton{.density = 0.15};
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            cotton.start.push_back(laid(c * cell - 0.5 * width, r * cell));
    return world.add(
        grid({.columns = columns, .rows = rows, .width = width, .height = (rows - 1) * cell},
             {.across = {1, 0, 0}, .up = {0, 0, 1}}),
        cotton);
}

std::vector<Piece> addTins(World& world) {
    constexpr double mass = 0.05, foot = clearance + 2 * thickness;  // kg, m
    std::vector<Piece> tins;
    for (const auto& [radius, height, x, z] : {std::array{0.035, 0.09, -0.15, -0.25},
                                               {0.045, 0.05, 0.02, -0.38},
                                               {0.03, 0.11, 0.17, -0.28},
                                               {0.04, 0.04, 0.06, -0.17}})
        tins.push_back(addSolid(world, tin(radius, height, {x, foot, z}), mass));
    return tins;
}

// The hem and the bar that it hangs on, which meets nothing.
Range pullHem(World& world, Range hem, double speed) {
    const Vec<double> middle = laid(0, depth + before), out{0.5 * width + 0.08, 0, 0};
    const Range bar = world.add(chain({.from = middle - out, .to = middle + out}));
    const auto pull = [=](const Vec<double>& x, double t) { return x + pulled(t, speed); };
    world.pin(pointStencils(hem), pull);
    world.pin(pointStencils(bar), pull);
    return bar;
}

void meetAll(World& world, Range cloth, Range table, const std::vector<Piece>& tins,
             double friction) {
    std::vector<Surface> surfaces{roughSurface(cloth, thickness, friction),
                                  roughSurface(table, thickness, friction)};
    for (const Piece& tin : tins)
        surfaces.push_back(roughSurface(tin.surface(), thickness, friction));
    for (std::size_t i = 1; i < surfaces.size(); ++i) surfaces[i].self = Self::none;
    meet(world, surfaces, {.order = 5});
    addGround(world, {tins.front().vertices.first, tins.back().vertices.last}, floorHeight,
              thickness, 6);
}

View viewOf(Range cloth, Range bar, const std::vector<Piece>& tins) {
    View view = plait::viewOf({cloth}, {0, -0.02, 0.0}, 0.8, Material::cotton, {1.9, 0.85, 1.5});
    for (const Piece& tin : tins)
        view.looks.push_back(lookOf(tin.surface(), Material::brass, 0.01));
    view.looks.push_back(lookOf(bar, Material::steel, 0.008));
    view.groundHeight = floorHeight;
    addBox(view, tableLow, tableHigh);
    for (const double x : {tableLow.x + 0.04, tableHigh.x - 0.04})
        for (const double z : {tableLow.z + 0.04, tableHigh.z - 0.04})
            addBar(view, {x, view.groundHeight, z}, {x, tableLow.y, z}, 0.015, Material::steel);
    return view;
}

}  // namespace

// Filmed at a quarter of its speed.
Scene tablecloth(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double speed = knobs.number("speed");
    const double cell = coarsest / knobs.byQuality(1, 2, 4);
    const int columns = static_cast<int>(std::lround(width / cell)) + 1;
    const int rows = static_cast<int>(std::lround((depth + before) / cell)) + 1;
    const Range cloth = addCloth(world, columns, rows, cell);
    const Range table = world.add(boxSurface(tableLow, tableHigh));
    world.pin(pointStencils(table));
    const std::vector<Piece> tins = addTins(world);
    const Range bar = pullHem(world, {cloth.last - columns, cloth.last}, speed);

    world.act<Gravity>(GravityOptions{});
    const std::vector<int> threads = weave(world, cloth, gridThreads(columns), 15, "", 0.01);
    world.constrain(bendRows(world.complex, cloth, world.rest, 1e-6), {.name = "bend", .order = 3});
    holdPieces(world, {.name = "tins", .order = 4});
    meetAll(world, cloth, table, tins, knobs.number("friction"));
    const int substeps = knobs.byQuality(16, 16, 32);
    scene.options.schedule = {.substeps = substeps, .iterations = 4, .collisionPasses = 4};
    scene.options.baseSteps = substeps;
    scene.options.timeScale = 0.25;
    scene.seconds = (pullStart + run / speed + hurry + 0.1) / scene.options.timeScale;
    scene.metrics = {greatestStrain(world, threads, {0, 2}),
                     selfIntersections(world, {cloth.first, tins.back().vertices.last}, {0, 0}),
                     tinsMoved(world, tins), contactFailures()};
    scene.view = viewOf(cloth, bar, tins);
    return scene;
}

}  // namespace plait
