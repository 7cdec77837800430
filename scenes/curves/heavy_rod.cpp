// A rod held level at one end, which droops under its own weight (validation A2).
#include "../parts/measures.h"
#include "../parts/views.h"
#include "curves.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/rods/rod.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace plait {
namespace {

constexpr double gravity = 9.81;  // m/s^2
constexpr double rest = 7;        // s, when it has come to rest

// Of polyurethane, 1 m of which weighs so much against its stiffness: w L^3 / B.
Wire plasticOf(double weight) {
    Wire wire{.youngs = 1e8, .poisson = 0.48, .density = 1100};
    wire.along = std::sqrt(16 * wire.density * gravity / (wire.youngs * weight));
    return wire;
}

// Clamped in the middle of its first link, from where it is 1 m long.
Rod addHeavyRod(World& world, const Wire& wire, int links, const std::string& solve) {
    const Shape line =
        chain({.links = links, .from = {-1.0 / (2 * links - 1), 0, 0}, .to = {1, 0, 0}});
    Rod rod;
    if (solve == "sweeps") {
        rod.points = world.add(line, {.density = wire.density * wire.area()});
        world.constrain(restRows<Stretch>(edgeStencils(world.complex, rod.points), world.rest),
                        {.name = "stretch"});
        world.constrain(curveBendRows(world.complex, rod.points, world.rest, wire.bending()),
                        {.name = "bend", .order = 1});
    } else {
        const RodModel model = solve == "frames" ? RodModel::framed : RodModel::straight;
        rod = addRod(world, line, {.wire = wire, .model = model}, {.name = "rod"});
    }
    world.pin({rod.points.first, rod.points.first + 1});
    if (rod.directors.size() > 0) world.pin({rod.directors.first});
    return rod;
}

// What a joint that is bent by `psi` resists with, over B / l: points have the energy of psi,
// frames that of 2 tan(psi / 2).
double resistanceOf(double psi, bool framed) {
    if (!framed) return psi;
    const double half = std::tan(psi / 2);
    return 2 * half * (1 + half * half);
}

// By how much a joint resists more or less than what lies beyond it weighs, at worst: in % of what
// the clamp would bear if the rod were level.
Metric momentOff(const World& world, const Rod& rod, double stiffness, Band band) {
    const auto [points, directors] = rod;
    const bool framed = directors.size() > 0;
    const double hinge = stiffness / length(world.rest[1] - world.rest[0]);
    double level = 0;
    for (int v = points.first + 1; v < points.last; ++v)
        level += world.mass[v] * gravity * world.rest[v].x;
    const auto worst = [=, mass = world.mass](const Snapshot& at) {
        const std::vector<Vec<double>>& x = at.positions;
        double beyond = 0, moment = 0, most = 0;  // kg, and kg m about the joint
        for (int v = points.last - 2; v > points.first; --v) {
            const Vec<double> before = x[v] - x[v - 1], after = x[v + 1] - x[v];
            beyond += mass[v + 1];
            moment += beyond * after.x;
            if (framed) {
                const int director = directors.first + v - points.first;
                moment += mass[director] * (x[director].x - x[v].x);
                beyond += mass[director];
            }
            const double psi = std::atan2(length(cross(before, after)), dot(before, after));
            most = std::max(most, std::fabs(hinge * resistanceOf(psi, framed) - gravity * moment));
        }
        return 100 * most / level;
    };
    return {.name = "moment off",
            .unit = "%",
            .measure = worst,
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

Metric fastestOf(const Rod& rod, Band band) {
    return {.name = "fastest",
            .unit = "mm/s",
            .measure =
                [=](const Snapshot& at) {
                    double speed = 0;
                    for (int v = rod.points.first; v < rod.points.last; ++v)
                        speed = std::max(speed, length(at.velocities[v]));
                    return 1000 * speed;
                },
            .low = band.low,
            .high = band.high,
            .from = band.from};
}

}  // namespace

Scene heavyRod(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const Wire wire = plasticOf(knobs.number("weight"));
    const std::string& solve = knobs.text("solve");
    const Rod rod =
        addHeavyRod(world, wire, static_cast<int>(std::lround(knobs.number("links"))), solve);
    world.act<Gravity>(GravityOptions{.acceleration = {0, -gravity, 0}});
    scene.options.schedule = {.substeps = 10, .frameRate = {60, 1}, .iterations = 1};
    scene.options.sweeps = solve == "sweeps" ? Sweeps::palindrome : Sweeps::oneWay;
    scene.options.damping = 1 - exponential(-4.0 / 24);
    scene.seconds = 8;
    scene.metrics = {momentOff(world, rod, wire.bending(), {0, 0.01, rest}),
                     greatestStrain(world, rod.points, {-0.1, 0.1}),
                     height("tip", rod.points.last - 1, {-1, 1e-6}),
                     fastestOf(rod, {0, 0.01, rest})};
    View& view = scene.view;
    view = viewOf({rod.points}, {0.36, -0.36, 0}, 0.95, Material::rubber, {0.5, 0.35, 2.4});
    view.looks[0].section = {.along = wire.along};
    view.looks[0].directors = rod.directors;
    view.ground = false;
    const double half = wire.along / 2;
    addBox(view, {-0.1, half, -0.05}, {0, half + 0.03, 0.05});
    addBox(view, {-0.1, -half - 0.03, -0.05}, {0, -half, 0.05});
    addBar(view, {-0.05, half + 0.03, 0}, {-0.05, half + 0.05, 0}, 0.012, Material::brass);
    addBar(view, {-1, 0, 0}, {-0.1, 0, 0}, 0.014, Material::steel);
    return scene;
}

}  // namespace plait
