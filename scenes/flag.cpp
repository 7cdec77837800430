#include "flag.h"

#include "elementary.h"
#include "forces/air.h"
#include "forces/gravity.h"
#include "measures.h"
#include "mesh_file.h"
#include "stencils.h"
#include "views.h"

#include <algorithm>

#include <cstdlib>
namespace plait {
namespace {
double env(const char* n, double d) { const char* v = std::getenv(n); return v ? std::atof(v) : d; }


constexpr double flyLength = 1.92, hoistLength = 1.2;  // m
constexpr double seconds = 10;
constexpr Vec<double> hoistFoot{0.026, 1.86, 0};  // m, the flag's lower corner at the pole

// Silk twill: threads that do not stretch, a weave that gives way on the bias, and hardly any
// stiffness to bending (Kawabata's measures of silk: G 15 N/m, B 5e-6 N m).
constexpr double density = 0.08;       // kg/m^2
constexpr double shearStiffness = 15;  // N/m
constexpr double bendRigidity = 5e-6;  // N m
constexpr double addedMass = 0.5;      // kg/m^2 of air (validation A4)

// The wind of the film: it blows, calms, freshens and gusts. Parts of the mean wind by time (s).
double weather(double t) {
    constexpr std::array<std::array<double, 2>, 9> course{{{0, 1},
                                                           {1.5, 1},
                                                           {2.6, 0.15},
                                                           {3.8, 0.15},
                                                           {5, 1},
                                                           {6.8, 1.1},
                                                           {7.4, 1.8},
                                                           {8.6, 1.6},
                                                           {10, 1}}};
    const auto next = std::find_if(course.begin() + 1, course.end() - 1,
                                   [&](const auto& at) { return t < at[0]; });
    const auto& [t0, v0] = *(next - 1);
    const auto& [t1, v1] = *next;
    const double s = std::clamp((t - t0) / (t1 - t0), 0.0, 1.0);
    return v0 + (v1 - v0) * s * s * (3 - 2 * s);
}

Wind windOf(const Knobs& knobs) {
    const double speed = knobs.number("wind");
    if (knobs.text("weather") == "steady")
        return {.velocity = [=](double) { return Vec<double>{speed, 0, 0}; }};
    return {.velocity =
                [=](double t) {
                    const double turn = 0.2 * sine(0.9 * t);
                    return speed * weather(t) * Vec<double>{cosine(turn), 0, sine(turn)};
                },
            .noise = 0.15 * speed,
            .noiseLength = 0.8,
            .noiseTime = 0.6,
            .noiseDrift = {speed, 0, 0},
            .seed = knobs.seed};
}

// As it flies at the start: a wave that grows towards the free end. Every thread keeps its length.
Vec<double> flying(const Vec<double>& rest) {
    constexpr int steps = 256;
    Vec<double> x{0, rest.y, 0};
    for (int i = 0; i < steps; ++i) {
        const double s = rest.x * (i + 0.5) / steps;
        const double slope = 0.35 * s * sine(2 * pi * s / 0.9 + 0.5);
        x += rest.x / steps * Vec<double>{cosine(slope), 0, sine(slope)};
    }
    return x;
}

// A steel pole with a ball and three rings of brass.
void addPole(View& view) {
    constexpr std::array brass{0.584, 0.305, 0.050}, steel{0.397, 0.445, 0.491};
    view.props.push_back({turned({{0.022, 0}, {0.022, 3.12}}), Material::steel, steel});
    view.props.push_back({sphere({.subdivisions = 4, .radius = 0.05}, {.origin = {0, 3.165, 0}}),
                          Material::brass, brass});
    for (const double y : {3.11, 3.04, 1.875})
        view.props.push_back({turned({{0.022, y - 0.012},
                                      {0.027, y - 0.01},
                                      {0.028, y},
                                      {0.027, y + 0.01},
                                      {0.022, y + 0.012}}),
                              Material::brass, brass});
}

}  // namespace

Scene flag(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int columns = knobs.byQuality(64, 128, 256), rows = knobs.byQuality(40, 80, 160);
    Shape shape =
        grid({.columns = columns, .rows = rows, .width = flyLength, .height = hoistLength});
    Matter matter{.density = env("DENS",0.08)};
    for (const Vec<double>& x : shape.positions) matter.start.push_back(hoistFoot + flying(x));
    for (Vec<double>& x : shape.positions) x += hoistFoot;
    const Range cloth = world.add(shape, matter);
    world.pin(world.select(cloth, [](const Vec<double>& x) { return x.x < hoistFoot.x + 1e-6; }));

    world.act<Gravity>(GravityOptions{});
    actAir(
        world,
        {.density = 1.2, .drag = env("DRAG", 1.2), .tangentialDrag = env("TANG", 0.05), .lift = env("LIFT", 0.5), .addedMass = env("AM", 0.5), .wind = windOf(knobs)});

    // Warp, weft and bias.
    Rows<Stretch> threads[2], bias;
    const Rows<Stretch> edges = restRows<Stretch>(edgeStencils(world.complex, cloth), world.rest);
    for (std::size_t i = 0; i < edges.rows.size(); ++i) {
        const int a = edges.ids[2 * i], b = edges.ids[2 * i + 1], apart = std::abs(a - b);
        Rows<Stretch>& set = apart == 1 ? threads[0] : apart == columns ? threads[1] : bias;
        set.ids.insert(set.ids.end(), {a, b});
        set.rows.push_back(edges.rows[i]);
    }
    for (auto& row : bias.rows) row.compliance = row.compression = 1 / (2 * env("SHEAR", 15));
    world.strand(threads[0], {.name = "warp"});
    world.strand(threads[1], {.name = "weft"});
    world.constrain(bias, {.name = "bias", .order = 1});
    world.constrain(bendRows(world.complex, cloth, world.rest, env("BEND", 5e-6)),
                    {.name = "bend", .order = 1});

    scene.options.integrator = Integrator::bdf2;
    scene.options.schedule = {.substeps = static_cast<int>(env("SUB", 60)), .iterations = 1};
    scene.seconds = seconds;
    scene.metrics = {greatestStrain(world, cloth, {0, 100}), commonStrain(world, cloth, {0, 100})};
    View& view = scene.view;
    Look look{.object = cloth, .print = "plait"};
    for (const Vec<double>& x : world.rest)
        look.uv.push_back({(x.x - hoistFoot.x) / flyLength, (x.y - hoistFoot.y) / hoistLength});
    view.looks = {look};
    view.cameras = {
        {.eye = {0.35, 1.7, 6.6}, .target = {0.8, 2.36, 0}, .focalLength = 68},
        {.time = seconds, .eye = {0.65, 1.7, 6.6}, .target = {1.1, 2.36, 0}, .focalLength = 68}};
    view.ground = false;
    addPole(view);
    view.glowCenter = {1.2, 1.55, -2};
    return scene;
}

}  // namespace plait
