// Contact: how fast a bullet may be, and how many layers lie on each other.
#include "map.h"
#include "watch.h"

#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/measure/surfaces/gap.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace plait {
namespace {

std::vector<std::array<int, 3>> trianglesOf(const World& world) {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < world.complex.count(2); ++i) triangles.push_back(world.complex.triangle(i));
    return triangles;
}

constexpr int flightSubsteps = 40;                  // in 1/24 s
constexpr double step = 1.0 / 24 / flightSubsteps;  // s

struct Target {
    Detection detection;
    bool cloth;  // or held, every vertex
};

// 16 bullets at a sheet of 0.2 kg/m^2 in the plane z = 0. They end their fifth substep before it a
// sixteenth of a substep's way apart, so that one of them is where it is worst to be.
Outcome shoot(const Target& target, double thickness, double speed) {
    constexpr int side = 9, bullets = 16;
    World world;
    const Range sheet = world.add(grid({.columns = side, .rows = side}), {.density = 0.2});
    const auto border = [](const Vec<double>& x) {
        return x.x == 0 || x.y == 0 || x.x == 1 || x.y == 1;
    };
    world.pin(
        world.select(sheet, [&](const Vec<double>& x) { return !target.cloth || border(x); }));
    Shape shots{SimplicialComplex(bullets), {}};
    for (int i = 0; i < bullets; ++i) {
        const int row = i / 4, column = i % 4;
        shots.positions.push_back({0.2 + 0.19 * column + 0.01 * row, 0.23 + 0.17 * row,
                                   thickness + speed * step * (5 + i / double(bullets))});
    }
    const Range shot = world.add(
        shots, {.density = 1e-3,
                .velocity = std::vector<Vec<double>>(bullets, Vec<double>{0, 0, -speed})});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest),
                    {.name = "stretch"});
    meet(world,
         {{.vertices = sheet, .thickness = 0, .self = Self::none},
          {.vertices = shot, .thickness = thickness, .self = Self::none}},
         {.detection = target.detection, .order = 1});
    Solver<double> solver(
        world, {.schedule = {.substeps = flightSubsteps, .iterations = 4, .collisionPasses = 4}});
    std::vector<std::array<int, 2>> ways;
    for (int i = 0; i < bullets; ++i) ways.push_back({shot.first + i, shot.last + i});
    const std::vector<std::array<int, 3>> triangles = trianglesOf(world);
    Judge judge(1, 2);
    watch(solver, 1, judge, [&] {
        std::vector<Vec<double>> x = solver.positions();
        // To where each came from: what has passed has the sheet in between.
        for (int i = 0; i < bullets; ++i)
            x.push_back(world.start[shot.first + i] + Vec<double>{0, 0, 1e3});
        std::vector<int> between(bullets);
        for (const Intersection& found : findIntersections(x, ways, triangles))
            ++between[found.edge];
        for (const int times : between)
            if (times % 2 == 1) judge.seeDrift();
        return judge.see(0, 0);
    });
    return judge.outcome();
}

// Sheets of 0.15 kg/m^2, half a metre wide and turned on each other, fall on each other and on the
// floor, which is held.
Outcome pile(int layers, int passes, double shock) {
    constexpr int side = 9;
    constexpr double width = 0.5, thickness = 0.002, apart = 0.02;  // m
    World world;
    const Range floor = world.add(grid({}, {.origin = {-0.5, 0, 0.5}, .up = {0, 0, -1}}));
    world.pin(pointStencils(floor));
    std::vector<Surface> surfaces{{.vertices = floor, .thickness = thickness, .self = Self::none}};
    for (int i = 0; i < layers; ++i) {
        const double turn = 0.5 * i;
        const Vec<double> across{cosine(turn), 0, -sine(turn)}, up{-sine(turn), 0, -cosine(turn)};
        const Range sheet = world.add(
            grid({.columns = side, .rows = side, .width = width, .height = width},
                 {.origin = Vec<double>{0, apart * (i + 1), 0} - 0.5 * width * (across + up),
                  .across = across,
                  .up = up}),
            {.density = 0.15});
        world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest),
                        {.name = "stretch " + std::to_string(i)});
        surfaces.push_back({.vertices = sheet, .thickness = thickness, .layer = i + 1});
    }
    world.act<Gravity>(GravityOptions{.acceleration = gravity});
    meet(world, surfaces, {.order = 1, .layerShock = shock});
    Solver<double> solver(
        world, {.schedule = {.substeps = 8, .iterations = 4, .collisionPasses = passes}});
    const std::vector<std::array<int, 3>> triangles = trianglesOf(world);
    Judge judge(mechanicalEnergy(world, solver), 2);
    watch(solver, 18, judge, [&] {
        const std::vector<Vec<double>> x = solver.positions();
        if (leastGap(x, triangles, 2 * thickness) < thickness) judge.seeDrift();
        return judge.see(mechanicalEnergy(world, solver), 0);
    });
    return judge.outcome();
}

}  // namespace

StabilityMap bulletMap() {
    const auto cell = [](const Target& target) {
        return [=](double thickness, double speed) { return shoot(target, thickness, speed); };
    };
    const auto theory = [](double thickness) { return thickness / step; };
    return {
        .name = "speed-thickness",
        .title = "How fast a bullet may be for what is thin",
        .words =
            "16 bullets of 1 g, points with a radius, fly at a sheet of 1 m × 1 m in 40 substeps "
            "of 1/960 s. The sheet is held, every vertex, or it is cloth of 0.2 kg/m² held by "
            "its border. It drifts where one has passed; nothing else is judged here.",
        .note = "16 bullets, substeps of 1/960 s; drifting: one has passed",
        .theoryWords =
            "looked for where substeps end, a bullet is found on the side that it "
            "came from for as long as it goes no further than its radius in one",
        .x = {"radius of the bullet [m]", 1e-4, 1e-2},
        .y = {"speed [m/s]", 0.03, 1000},
        .fails = Outcome::drifting,
        .boundaryAt = {1e-4, 1e-3, 1e-2},
        .panels = {{"end (held)", cell({Detection::end, false}), theory, true},
                   {"path (held)", cell({Detection::path, false})},
                   {"end (cloth)", cell({Detection::end, true}), theory, true},
                   {"path (cloth)", cell({Detection::path, true})}}};
}

StabilityMap layersMap() {
    const auto cell = [](double shock) {
        return [=](double layers, double passes) {
            return pile(static_cast<int>(layers), static_cast<int>(passes), shock);
        };
    };
    return {
        .name = "layers-passes",
        .title = "How many passes a pile of cloth wants",
        .words =
            "Sheets of 9 × 9 vertices with rigid edges, 2 cm above each other, fall on each "
            "other and on a floor, for 0.75 s in 8 substeps of 1/24 s. It drifts where anything "
            "crosses, or comes nearer than half of what is to be between them, 4 mm. With a shock "
            "of 4 each is four times heavier to the one above it.",
        .note = "sheets that fall on each other; drifting: nearer than half their thickness",
        .theoryWords = "none is known",
        .x = {"layers", 1, 8, true},
        .y = {"passes over contacts in a substep", 1, 16, true},
        .goodAtLowY = false,
        .fails = Outcome::drifting,
        .boundaryAt = {2, 4, 8},
        .panels = {{"alike", cell(1)}, {"shock 4", cell(4)}}};
}

}  // namespace plait
