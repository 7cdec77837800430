#include "basics.h"

#include "elementary.h"
#include "forces/air.h"
#include "forces/field.h"
#include "forces/gravity.h"
#include "measures.h"
#include "stencils.h"
#include "views.h"

#include <algorithm>

namespace plait {
namespace {

constexpr Vec<double> gravity{0, -9.81, 0};
constexpr Frame hanging{.across = {1, 0, 0}, .up = {0, -1, 0}};
constexpr Frame lying{.across = {1, 0, 0}, .up = {0, 0, 1}};

void constrainStretch(World& world, Range range, double compliance = 0) {
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, range), world.rest, compliance),
                    {.name = "stretch"});
}

// In degrees: how far the lower end of the strip is from hanging, once it is at rest.
Metric stripAngle(Range strip, double wind) {
    const double exact = arctangent2(wind, 4.0) * 180 / pi;
    return {.name = "angle",
            .unit = "deg",
            .measure =
                [=](const Snapshot& at) {
                    const Vec<double> end = at.positions[static_cast<std::size_t>(strip.last - 1)];
                    return arctangent2(end.z, -end.y) * 180 / pi;
                },
            .low = exact - 0.5,
            .high = exact + 0.5,
            .from = 3,
            .caption = true};
}

// In m/s: how much slower than the air a polygon is.
Metric windLag(const Vec<double>& wind, double drag) {
    return {.name = "lag",
            .unit = "m/s",
            .measure = [=](const Snapshot& at) { return length(at.velocities[0] - wind); },
            .low = 0,
            .high = drag > 0 ? 0.01 * length(wind) : length(wind) * 1.0001,
            .from = drag > 0 ? 1 / drag : 0,
            .caption = true};
}

// In m: how far a point hangs below its pin.
Metric sag(int point, Band band) {
    return {.name = "sag" + std::to_string(point),
            .unit = "m",
            .measure =
                [=](const Snapshot& at) {
                    return 0.1 * sine(2 * at.time) -
                           at.positions[static_cast<std::size_t>(point)].y;
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
    scene.options.schedule = {.substeps = 20, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.metrics = {{.name = "x",
                      .unit = "m",
                      .measure = [](const Snapshot& at) { return at.positions[0].x; },
                      .low = -1.001,
                      .high = 1.001,
                      .caption = true}};
    scene.view = viewOf({point}, {0, 0, 0}, 1.4, Material::brass);
    return scene;
}

// A bob on a rigid, weightless link of 1 m, let go at 90 degrees (validation A1).
Scene pendulum(const Knobs& knobs) {
    Scene scene;
    const double length = knobs.number("length");
    const Range rod = scene.world.add(chain({.links = 1, .to = {length, 0, 0}}), {.density = 2});
    scene.world.pin({rod.first});
    scene.world.act<Gravity>(GravityOptions{});
    constrainStretch(scene.world, rod);
    scene.options.schedule = {.substeps = 20, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.metrics = {greatestStrain(scene.world, rod, {-0.01, 0.01}),
                     energyGain(scene.world, gravity, length * length * 9.81, {-50, 0.01}),
                     height("bob", rod.last - 1, {-1.01 * length, 0.01 * length})};
    scene.view = viewOf({rod}, {0, -length / 2, 0}, 1.4 * length, Material::steel);
    scene.view.looks.push_back(lookOf({rod.last - 1, rod.last}, Material::brass, 0.08 * length));
    return scene;
}

// Twenty links let go from horizontal; one direct solve a substep, so that BDF2 is at its best.
Scene hangingChain(const Knobs& knobs) {
    Scene scene;
    const Range links = scene.world.add(chain({.links = 20}));
    if (knobs.text("tip") == "whole") scene.world.mass.back() *= 2;
    scene.world.pin({links.first});
    scene.world.act<Gravity>(GravityOptions{});
    scene.world.constrain(
        restRows<Stretch>(edgeStencils(scene.world.complex, links), scene.world.rest),
        {.name = "stretch", .direct = knobs.text("solve") == "direct"});
    scene.options.schedule = {.substeps = 16, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.metrics = {greatestStrain(scene.world, links, {-0.01, 0.01}),
                     energyGain(scene.world, gravity, 9.81 / 2, {-70, 0.01}),
                     height("tip", links.last - 1, {-1.01, 1.01})};
    scene.view = viewOf({links}, {0, -0.5, 0}, 1.4, Material::rubber);
    return scene;
}

// 1 m of 0.2 kg/m^2 between two pinned corners, flat at the start: the work of peers-measured.
// Flat, it may buckle either way, and rounding decides; a dent of 1 mm, smooth and not symmetric,
// makes what happens the same for every method.
Scene hangingSheet(const Knobs& knobs) {
    Scene scene;
    const int size = static_cast<int>(knobs.number("size"));
    const int n = size > 0 ? std::max(size, 2) : knobs.byQuality(16, 32, 64);
    Shape shape = grid({.columns = n, .rows = n}, lying);
    for (Vec<double>& x : shape.positions)
        x.y -= knobs.number("dent") * (sine(pi * x.x) + 0.5 * sine(2 * pi * x.x)) * sine(-pi * x.z);
    const Range sheet = scene.world.add(shape, {.density = 0.2});
    if (knobs.text("pins") == "corners")
        scene.world.pin({0, n - 1});
    else
        scene.world.pin(pointStencils({0, n}));
    scene.world.act<Gravity>(GravityOptions{});
    constrainStretch(scene.world, sheet);
    scene.options.schedule = {.substeps = knobs.byQuality(50, 50, 200), .iterations = 1};
    scene.metrics = {greatestStrain(scene.world, sheet, {0, 65}),
                     commonStrain(scene.world, sheet, {0, 18}), lowestHeight({-1.1, 1e-6})};
    scene.view = viewOf({sheet}, {0.5, -0.4, -0.3}, 1.4, Material::cotton);
    return scene;
}

// 0.3 m of cloth clamped at one end and let go from horizontal: w L^3 / B = 10, and threads so soft
// that every method knows their stiffness (validation A3).
Scene cantilever(const Knobs&) {
    Scene scene;
    constexpr int columns = 17, rows = 3;
    constexpr double l = 0.3, density = 0.2;
    const Shape shape = grid({.columns = columns, .rows = rows, .width = l, .height = 0.06},
                             {.across = {1, 0, 0}, .up = {0, 0, -1}});
    const Range strip = scene.world.add(shape, {.density = density});
    scene.world.pin(scene.world.select(
        strip, [](const Vec<double>& x) { return x.x < 1.5 * l / (columns - 1); }));
    scene.world.act<Gravity>(GravityOptions{});
    constrainStretch(scene.world, strip, 1e-3);
    scene.world.constrain(
        bendRows(scene.world.complex, strip, scene.world.rest, density * 9.81 * l * l * l / 10),
        {.name = "bend", .order = 1});
    scene.options.schedule = {.substeps = 80, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.metrics = {greatestStrain(scene.world, strip, {-0.1, 1}),
                     height("tip", strip.last - 1, {-l, 0.01 * l})};
    scene.view = viewOf({strip}, {l / 2, -l / 2, 0}, 1.6 * l, Material::cotton);
    return scene;
}

// Pinned along its upper edge; tan(angle) = drag density U / (areal density g) = 1 (validation A4).
Scene stripInWind(const Knobs& knobs) {
    Scene scene;
    const double wind = knobs.number("wind");
    const Range strip = scene.world.add(
        grid({.columns = 3, .rows = 21, .width = 0.1, .height = 1}, hanging), {.density = 0.2});
    scene.world.pin({0, 1, 2});
    scene.world.act<Gravity>(GravityOptions{});
    actAir(scene.world, {.form = AirForm::legacy,
                         .drag = 0.2 * 9.81 / 4,
                         .tangentialDrag = 0,
                         .wind = {.velocity = [=](double) { return Vec<double>{0, 0, wind}; }}});
    constrainStretch(scene.world, strip);
    scene.options.schedule = {.substeps = 20, .iterations = 2};
    scene.options.damping = 0.3;
    scene.metrics = {greatestStrain(scene.world, strip, {0, 5}), stripAngle(strip, wind)};
    // From the side, where its angle is seen.
    scene.view = viewOf({strip}, {0.05, -0.45, 0.35}, 1, Material::silk, {2.4, 0.3, 1.1});
    return scene;
}

// A free polygon with drag alike in all directions: it soon moves as the air does (M 5.6.1).
Scene windGauge(const Knobs& knobs) {
    Scene scene;
    const double drag = knobs.number("drag");
    const Vec<double> wind{3, 0, 1};
    const Range gauge = scene.world.add(grid({.width = 0.1, .height = 0.1}), {.density = 0.05});
    actAir(scene.world, {.form = AirForm::legacy,
                         .drag = drag,
                         .tangentialDrag = 1,
                         .lift = knobs.number("lift"),
                         .wind = {.velocity = [=](double) { return wind; }}});
    constrainStretch(scene.world, gauge);
    scene.metrics = {windLag(wind, drag), greatestStrain(scene.world, gauge, {-0.01, 0.01})};
    scene.view = viewOf({gauge}, {-0.1, 0.05, -0.05}, 0.2, Material::silk);
    travel(scene.view, wind);
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
        const double still = 0.1 * 9.81 * 1e-3 * i;  // load over stiffness
        scene.metrics.push_back(sag(i, {0.9 * still - 1e-6, 1.1 * still + 1e-6, 1}));
    }
    scene.view = viewOf({points}, {0.5, 0, 0}, 1.2, Material::brass);
    return scene;
}

// A curtain on a rail that moves, in gusty air that has inertia, over a floor and a ball; and a
// springy wire beside it. A scene for tests: it leaves nothing out.
Scene sampler(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int n = 13;
    const Range cloth = world.add(
        grid({.columns = n, .rows = n, .width = 0.6, .height = 0.6}, hanging), {.density = 0.15});
    const Range wire = world.add(
        helix({.links = 40, .radius = 0.05, .turns = 3, .pitch = 0.08}, {.origin = {0.9, -0.3, 0}}),
        {.density = 0.02});
    const auto rail = [](const Vec<double>& x, double t) {
        return x + Vec<double>{0.05 * sine(5 * t), 0, 0.1 * sine(3 * t)};
    };
    world.pin({0, n / 2, n - 1}, rail);
    world.pin({wire.first});

    world.act<Gravity>(GravityOptions{});
    actAir(world,
           {.density = 1.2,
            .drag = 1.2,
            .lift = 0.5,
            .addedMass = 0.3,
            .wind = {.velocity = [](double t) { return Vec<double>{1, 0, 3 + 2 * sine(2 * t)}; },
                     .noise = 1,
                     .noiseLength = 0.3,
                     .seed = knobs.seed}});
    world.act<Field>(FieldOptions{
        .acceleration = [](const Vec<double>& x, double) { return Vec<double>{-x.x, 0, -x.z}; }});

    const auto edges = [&](Range range) { return edgeStencils(world.complex, range); };
    world.constrain(restRows<Stretch>(edges(cloth), world.rest), {.name = "stretch"});
    world.constrain(restRows<Stretch>(edges(wire), world.rest), {.name = "wire", .direct = true});
    world.constrain(restRows<Shear>(triangleStencils(world.complex, cloth), world.rest, 1e-2),
                    {.name = "shear", .order = 1, .damping = 0.2});
    world.constrain(restRows<Angle>(cornerStencils(world.complex, cloth), world.rest, 1e-1),
                    {.name = "corners", .order = 1, .secondaryInterval = 2});
    world.constrain(bendRows(world.complex, cloth, world.rest, 1e-5), {.name = "bend", .order = 2});
    world.constrain(curveBendRows(world.complex, wire, world.rest, 1e-4),
                    {.name = "wire bend", .order = 2});
    auto hook = restRows<Attach>({wire.last - 1}, world.rest, 1e-2);
    world.constrain(hook, {.name = "hook", .order = 3});

    auto floor = restRows<PlaneContact>(pointStencils({0, wire.last}), world.rest);
    for (auto& row : floor.rows) row = {{0, -0.5, 0}, {0, 1, 0}, 0.005};
    world.constrain(floor, {.name = "floor", .order = 8});
    auto ball = restRows<SphereContact>(pointStencils(cloth), world.rest);
    for (auto& row : ball.rows) row = {{0.3, -0.4, 0.1}, 0.12};
    world.constrain(ball, {.name = "ball", .order = 9});

    scene.options.schedule = {.substeps = 12, .iterations = 2, .collisionPasses = 1};
    scene.options.damping = 0.05;
    scene.options.smoothing = 2;
    scene.metrics = {greatestStrain(world, cloth, {0, 40}), commonStrain(world, cloth, {0, 16}),
                     lowestHeight({-0.55, 0, 1})};
    scene.view = viewOf({cloth, wire}, {0.5, -0.3, 0}, 1.2, Material::cotton);
    return scene;
}

}  // namespace plait
