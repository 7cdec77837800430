// Sheets.
#include "basics.h"

#include "../parts/measures.h"
#include "../parts/views.h"

#include <plait/air/air.h>
#include <plait/forces/field.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/sheets/inextensible.h>
#include <plait/stencils.h>

#include <algorithm>

namespace plait {
namespace {

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

}  // namespace

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
    const std::vector<int> pins =
        knobs.text("pins") == "corners" ? std::vector{0, n - 1} : pointStencils({0, n});
    scene.world.pin(pins);
    scene.world.act<Gravity>(GravityOptions{});
    const std::string& solve = knobs.text("solve");
    const bool strands = solve == "strands" || solve == "all";
    holdSheet(scene.world, sheet,
              {.compliance = knobs.number("compliance"),
               .strands = strands,
               .tethers = solve != "sweeps",
               .aggregates = solve == "aggregates" || solve == "all",
               .mending = solve == "sweeps" ? 0 : knobs.number("mending") / 100,
               .geometricStiffness = true});
    if (strands) {
        // BDF2 loses less energy, and keeps the crack of the lower edge (at 1.4 s) as noise.
        // That crack presses 16 x 16 as it would no finer sheet: in one frame, with 30, by 1.7 %.
        scene.options.schedule = {.substeps = knobs.byQuality(40, 30, 30), .iterations = 1};
    } else {
        scene.options.schedule = {.substeps = knobs.byQuality(50, 50, 200), .iterations = 1};
        scene.options.integrator = Integrator::bdf2;
    }
    scene.metrics = {greatestStrain(scene.world, sheet, {0, strands ? 2.0 : 40.0}),
                     commonStrain(scene.world, sheet, {0, strands ? 1.5 : 8.0}),
                     lowestHeight({-1.1, 1e-6})};
    View& view = scene.view;
    view = viewOf({sheet}, {0.5, -0.5, -0.2}, 1.3, Material::cotton, {0.7, 0.5, 2.6});
    view.groundHeight = -1.15;
    addBar(view, {-0.2, 0.02, 0}, {1.2, 0.02, 0}, 0.012, Material::steel);
    for (const double x : {-0.2, 1.2})
        addBar(view, {x, view.groundHeight, 0}, {x, 0.04, 0}, 0.015, Material::matte);
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
    scene.options.schedule = {.substeps = 320, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    // Converged (2,560 substeps; newton) threads stretch by 1.5 % where the tip whips up; with 80
    // substeps by 4.2 %.
    scene.metrics = {greatestStrain(scene.world, strip, {-0.1, 2}),
                     height("tip", strip.last - 1, {-l, 0.01 * l})};
    View& view = scene.view;
    view =
        viewOf({strip}, {0.38 * l, -0.31 * l, -0.03}, 0.8 * l, Material::cotton, {1.7, 1.1, -2.0});
    view.ground = false;
    addBox(view, {-0.035, 0.001, -0.07}, {0.026, 0.012, 0.01});
    addBox(view, {-0.035, -0.012, -0.07}, {0.026, -0.001, 0.01});
    addBar(view, {-0.005, 0.012, -0.03}, {-0.005, 0.021, -0.03}, 0.008, Material::brass);
    addBar(view, {-0.5, 0, -0.03}, {-0.035, 0, -0.03}, 0.008, Material::steel);
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
    constrainStretch(scene.world, strip, 1e-3);
    scene.options.schedule = {.substeps = 40, .iterations = 1};
    scene.options.integrator = Integrator::bdf2;
    scene.options.damping = 0.3;
    scene.metrics = {greatestStrain(scene.world, strip, {0, 5}), stripAngle(strip, wind)};
    // From the side, where its angle is seen.
    scene.view = viewOf({strip}, {0.05, -0.45, 0.35}, 1, Material::silk, {2.4, 0.3, 1.1});
    scene.view.cameras[0].across = 0.4;
    addBar(scene.view, {-0.06, 0.01, 0}, {0.14, 0.01, 0}, 0.012, Material::steel);
    addBar(scene.view, {-0.06, scene.view.groundHeight, 0}, {-0.06, 0.04, 0}, 0.015,
           Material::matte);
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
    scene.view.cameras[0].across = 1;
    travel(scene.view, wind);
    // It would seem to stand still: a post every metre on its way.
    scene.seconds = 4;
    for (int i = -1; i < 14; ++i) {
        const Vec<double> foot = (i / length(wind)) * wind + Vec<double>{0.2, -1, -0.6};
        addBar(scene.view, foot, foot + Vec<double>{0, 1.25, 0}, 0.02, Material::matte);
    }
    return scene;
}

// A curtain on a rail that moves, in gusty air that it carries with it, over a floor and a ball;
// and a springy wire beside it. A scene for tests: it leaves nothing out.
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
            .carried = {.mass = 0.3, .reach = 0.1},
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
    scene.view = viewOf({cloth, wire}, {0.55, -0.2, 0}, 0.95, Material::cotton);
    scene.view.groundHeight = -0.5;
    scene.view.props.push_back(
        {sphere({.subdivisions = 4, .radius = 0.117}, {.origin = {0.3, -0.4, 0.1}})});
    return scene;
}

}  // namespace plait
