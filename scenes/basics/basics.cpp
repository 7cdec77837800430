// Points and curves.
#include "basics.h"

#include "../parts/measures.h"
#include "../parts/views.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

namespace plait {
namespace {

constexpr Vec<double> gravity{0, -9.81, 0};

// In mm: how far a point hangs below its pin.
Metric sag(int point, Band band) {
    return {.name = "sag" + std::to_string(point),
            .unit = "mm",
            .measure =
                [=](const Snapshot& at) {
                    return 1000 * (0.1 * sine(2 * at.time) -
                                   at.positions[static_cast<std::size_t>(point)].y);
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

}  // namespace

// A kilogram on a spring of 1 N/m, 1 m from where it rests: x'' = -x (validation A0). The period is
// 2 pi s.
Scene unitSpring(const Knobs&) {
    Scene scene;
    const Range point = scene.world.add({SimplicialComplex(1), {{1, 0, 0}}});
    auto spring = restRows<Attach>(pointStencils(point), scene.world.start, 1.0);
    spring.rows[0].target = {0, 0, 0};
    scene.world.constrain(spring, {.name = "spring"});
    scene.options.schedule = {.substeps = 10, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.options.sweeps = Sweeps::oneWay;  // back again, one constraint would be as it is
    scene.metrics = {{.name = "x",
                      .unit = "m",
                      .measure = [](const Snapshot& at) { return at.positions[0].x; },
                      .low = -1.001,
                      .high = 1.001,
                      .caption = true}};
    // It slides on a bar; its spring is no matter and is not drawn.
    View& view = scene.view;
    view = viewOf({point}, {-0.25, 0, 0}, 1.1, Material::brass, {0.55, 0.75, 4.4});
    view.cameras[0].across = 1;
    view.looks[0].radius = 0.19;
    addBar(view, {-2, 0, 0}, {1.5, 0, 0}, 0.025, Material::steel);
    for (const double x : {-2.15, 1.5})
        addBox(view, {x, view.groundHeight, -0.35}, {x + 0.15, 0.4, 0.35});
    return scene;
}

// A bob on a rigid, weightless link of 1 m, let go at 90 degrees (validation A1).
Scene pendulum(const Knobs& knobs) {
    Scene scene;
    const double length = knobs.number("length");
    const Range rod = scene.world.add(chain({.links = 1, .to = {length, 0, 0}}), {.density = 2});
    scene.world.pin({rod.first});
    scene.world.act<Gravity>(GravityOptions{});
    scene.world.constrain(
        restRows<Stretch>(edgeStencils(scene.world.complex, rod), scene.world.rest),
        {.name = "stretch"});
    scene.options.schedule = {.substeps = 20, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.options.sweeps = Sweeps::oneWay;  // back again, one constraint would be as it is
    scene.metrics = {greatestStrain(scene.world, rod, {-0.01, 0.01}),
                     energyGain(scene.world, gravity, length * length * 9.81, {-50, 0.01}),
                     height("bob", rod.last - 1, {-1.01 * length, 0.01 * length})};
    scene.view = viewOf({rod}, {0, -length / 2, 0}, 1.4 * length, Material::steel);
    scene.view.looks.push_back(lookOf({rod.last - 1, rod.last}, Material::brass, 0.08 * length));
    addPeg(scene.view, {0, 0, 0.03 * length}, 0.035 * length);
    return scene;
}

// Twenty links let go from horizontal; one direct solve a substep, so that BDF2 is at its best.
Scene hangingChain(const Knobs& knobs) {
    Scene scene;
    const bool direct = knobs.text("solve") == "direct";
    const Range links = scene.world.add(chain({.links = 20}));
    if (knobs.text("tip") == "whole") scene.world.mass.back() *= 2;
    scene.world.pin({links.first});
    scene.world.act<Gravity>(GravityOptions{});
    scene.world.constrain(
        restRows<Stretch>(edgeStencils(scene.world.complex, links), scene.world.rest),
        {.name = "stretch", .direct = direct});
    scene.options.schedule = {.substeps = 32, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    // Back again, a direct solve would be the same once more: substeps gain more.
    scene.options.sweeps = direct ? Sweeps::oneWay : Sweeps::palindrome;
    scene.metrics = {greatestStrain(scene.world, links, {-0.01, 0.01}),
                     energyGain(scene.world, gravity, 9.81 / 2, {-70, 0.01}),
                     height("tip", links.last - 1, {-1.01, 1.01})};
    scene.view = viewOf({links}, {0, -0.5, 0}, 1.4, Material::rubber);
    addPeg(scene.view, {0, 0, 0.03}, 0.035);
    return scene;
}

// A closed band, 1.2 times as long as at rest, over two pegs (S figures 10 and 12), solved as the
// paper does. Interleaved, its links are stretched almost alike. Sequential, stretch first pulls
// the whole band in, and contact then pushes out the ends alone: the links there bear what the
// others are spared.
Scene band(const Knobs&) {
    Scene scene;
    const int n = 80;
    const double radius = 0.1, apart = 0.8, stretched = 1.2;
    // Around both pegs: two straight runs and two half circles, evenly divided.
    const double around = 2 * apart + 2 * pi * radius;
    Simplices edges;
    Shape shape;
    std::vector<Vec<double>> start;
    for (int i = 0; i < n; ++i) {
        edges.edges.push_back({i, (i + 1) % n});
        double s = around * i / n;
        Vec<double> p;
        const double half = s < around / 2 ? 1 : -1;
        if (half < 0) s -= around / 2;
        if (s < apart) {
            p = {s - apart / 2, radius, 0};
        } else {
            const double a = (s - apart) / radius;
            p = {apart / 2 + radius * sine(a), radius * cosine(a), 0};
        }
        start.push_back(half * p);
        shape.positions.push_back((half / stretched) * p);
    }
    shape.complex = SimplicialComplex(n, edges);
    const Range loop = scene.world.add(shape, {.density = 0.1, .start = start});
    scene.world.constrain(
        restRows<Stretch>(edgeStencils(scene.world.complex, loop), scene.world.rest),
        {.name = "stretch", .importance = 26});
    auto pegs = restRows<CapsuleContact>(pointStencils(loop), scene.world.start);
    for (std::size_t i = 0; i < pegs.rows.size(); ++i)
        pegs.rows[i] = {{start[i].x < 0 ? -apart / 2 : apart / 2, 0, -1}, {0, 0, 2}, radius};
    scene.world.constrain(pegs, {.name = "pegs", .order = 1, .importance = 6});
    scene.options.schedule = {.substeps = 1};
    scene.options.method = Method::nucleus;
    scene.options.damping = 0.1;
    // The rest lengths cannot be had, and of two colours the last swept gets all of them: without
    // smoothing every other link is at rest and the next is stretched for both.
    scene.options.smoothing = 4;
    scene.seconds = 4;
    scene.metrics = {greatestStrain(scene.world, loop, {15, 26}),
                     commonStrain(scene.world, loop, {15, 26})};
    scene.view = viewOf({loop}, {0, 0, 0}, 0.65, Material::rubber);
    for (const double x : {-apart / 2, apart / 2})
        addPeg(scene.view, {x, 0, 0.02}, radius - scene.view.looks[0].radius);
    return scene;
}

// Three weights on soft pins that are carried about.
Scene softPins(const Knobs&) {
    Scene scene;
    const Range points = scene.world.add(
        {SimplicialComplex(3), {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}}, {.density = 0.1});
    scene.world.act<Gravity>(GravityOptions{});
    auto pins = restRows<Attach>(pointStencils(points), scene.world.start);
    pins.animate = [](double t, std::span<Attach::Row<double>> rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].target = {0.5 * static_cast<double>(i), 0.1 * sine(2 * t), 0};
            rows[i].compliance = 1e-3 * static_cast<double>(i);
        }
    };
    scene.world.constrain(pins, {.name = "pins"});
    for (int i = 0; i < 3; ++i) {
        const double still = 0.1 * 9.81 * i;  // load over stiffness
        scene.metrics.push_back(sag(i, {0.9 * still - 1e-3, 1.1 * still + 1e-3, 1}));
    }
    scene.view = viewOf({points}, {0.5, 0, 0}, 0.9, Material::brass);
    scene.view.cameras[0].across = 0.65;
    scene.view.looks[0].radius = 0.06;
    return scene;
}

}  // namespace plait
