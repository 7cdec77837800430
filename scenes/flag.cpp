#include "flag.h"

#include "parts/measures.h"
#include "parts/views.h"
#include "parts/woven.h"

#include <plait/air/air.h>
#include <plait/contacts/surface.h>
#include <plait/files/mesh_file.h>
#include <plait/forces/gravity.h>
#include <plait/inspection/inspect.h>
#include <plait/numbers/elementary.h>
#include <plait/sheets/inextensible.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

constexpr double flyLength = 1.92, hoistLength = 1.2;  // m
constexpr double seconds = 10;
constexpr Vec<double> hoistTop{0.026, 3.06, 0};  // m, the upper corner at the pole

// Silk: threads that do not stretch, a weave that gives way on the bias, hardly any stiffness to
// bending.
constexpr double density = 0.1;        // kg/m^2
constexpr double shearStiffness = 15;  // N/m
constexpr double mending = 0.018;      // of a thread's length
// A waving sheet carries 2 rho / k of air in potential flow on both sides: mass / (1 + reach^2 k^2)
// meets that where k = 1 / reach if the mass is 4 rho reach. Of the longest waves a strip as wide
// as the hoist carries pi / 4 rho of its width: as much.
constexpr CarriedAirOptions carried{.mass = 1.1, .reach = 0.22};
// Threads pull within a substep. The air takes (density + carried mass) / (rho Cd u / 2) to change
// a velocity, 90 ms at u = 10 m/s where k = 1 / reach, and is asked every 2 ms.
constexpr int airInterval = 3;

// The wind of the film: it blows, calms, freshens and gusts. Parts of the mean wind by time (s).
double weather(double t) {
    constexpr std::array<std::array<double, 2>, 9> course{{{0, 1},
                                                           {1.5, 1},
                                                           {2.4, 0.3},
                                                           {3.2, 0.3},
                                                           {4.4, 1},
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
    const double length = rest.x - hoistTop.x;
    Vec<double> x{hoistTop.x, rest.y, rest.z};
    for (int i = 0; i < steps; ++i) {
        const double s = length * (i + 0.5) / steps;
        // Never upright, however long: or the wave would run into itself.
        const double slope = 0.35 * std::min(s, flyLength) * sine(2 * pi * s / 0.9 + 0.5);
        x += length / steps * Vec<double>{cosine(slope), 0, sine(slope)};
    }
    return x;
}

// A steel pole with a ball and three rings of brass, the last of them where the cloth ends. It is
// so many times as large as for the flag's own cloth; its foot is not to be seen.
void addPole(View& view, double lowest, double size) {
    constexpr std::array brass{0.584, 0.305, 0.050}, steel{0.397, 0.445, 0.491};
    const auto add = [&](Shape shape, Material material, const std::array<double, 3>& color) {
        for (Vec<double>& x : shape.positions) x = hoistTop + size * (x - hoistTop);
        view.props.push_back({std::move(shape), material, color});
    };
    add(turned({{0.022, 0}, {0.022, 3.12}}), Material::steel, steel);
    add(turned({{0.022, -100}, {0.022, 0}}), Material::steel, steel);
    add(sphere({.subdivisions = 4, .radius = 0.05}, {.origin = {0, 3.165, 0}}), Material::brass,
        brass);
    for (const double y : {3.11, 3.04, hoistTop.y + (lowest - hoistTop.y) / size + 0.015})
        add(turned({{0.022, y - 0.012},
                    {0.027, y - 0.01},
                    {0.028, y},
                    {0.027, y + 0.01},
                    {0.022, y + 0.012}}),
            Material::brass, brass);
}

// A cloth of the user's own: nobody knows its threads, so every edge is one.
std::vector<int> hold(World& world, Range cloth) {
    holdSheet(world, cloth);
    return edgeStencils(world.complex, cloth);
}

// What no edges join to the hoist flies off.
void warnOfLooseParts(World& world, const InspectedMesh& mesh, const std::vector<int>& hoist) {
    const Csr ring = world.complex.oneRing();
    std::vector<bool> isReached(mesh.vertices.size(), false);
    const auto reach = [&](int from) {
        std::vector<int> reached{from};
        isReached[from] = true;
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (const int v : ring[reached[i]]) {
                if (!isReached[v]) reached.push_back(v);
                isReached[v] = true;
            }
    };
    for (const int v : hoist) reach(v);
    int parts = 0, first = -1;
    for (int v = 0; v < static_cast<int>(isReached.size()); ++v) {
        if (isReached[v]) continue;
        if (++parts == 1) first = v;
        reach(v);
    }
    if (parts > 0)
        world.warnings.push_back(
            mesh.told("parts of it that no edge joins to its left edge will fly off: " +
                      std::to_string(parts) + ", the first that of vertex " + mesh.name(first)));
}

struct Box {
    Vec<double> low, high;
};

Box boxOf(std::span<const Vec<double>> points) {
    Box box{points[0], points[0]};
    for (const Vec<double>& p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y),
                    std::max(box.high.z, p.z)};
    }
    return box;
}

// Its mesh, hoisted: the left edge at the pole, the upper one where the flag's own would be.
InspectedMesh clothOf(const Knobs& knobs, int columns, int rows) {
    constexpr double least = 0.05, most = 30;  // m
    const std::string& file = knobs.text("mesh");
    InspectedMesh mesh;
    if (file.empty())
        mesh.shape =
            grid({.columns = columns, .rows = rows, .width = flyLength, .height = hoistLength});
    else
        mesh = inspect(readMesh(file), file, {.least = least, .usual = flyLength, .most = most});
    const Box box = boxOf(mesh.shape.positions);
    if (!(box.high.x > box.low.x && box.high.y > box.low.y))
        throw std::invalid_argument(mesh.told("it must have a width and a height, along x and y"));
    const Vec<double> corner{box.low.x, box.high.y, (box.low.z + box.high.z) / 2};
    for (Vec<double>& x : mesh.shape.positions) x += hoistTop - corner;
    return mesh;
}

View viewOf(Range cloth, std::span<const Vec<double>> rest) {
    const Box box = boxOf(rest);
    const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    View view;
    Look look{.object = cloth, .print = "plait"};
    for (const Vec<double>& x : rest)
        look.uv.push_back({(x.x - box.low.x) / width, (x.y - box.low.y) / height});
    view.looks = {look};
    // In parts of the flag's own. A long one hangs down far where the wind calms.
    const double across = width / flyLength, size = std::max(across, height / hoistLength),
                 down = (height + width / 2) / (hoistLength + flyLength / 2);
    const auto place = [&](double x, double y, double z) {
        return hoistTop + Vec<double>{across * x, down * y, size * z};
    };
    constexpr double drift = 0.3;
    // To the pole when the camera has drifted, or to the free end before.
    const double half = std::max(0.8 * across + drift * size, width - 0.8 * across) + 0.1 * size;
    for (const double t : {0.0, seconds}) {
        const Vec<double> target =
            place(0.8, -0.8, 0) + Vec<double>{drift * size * t / seconds, 0, 0};
        view.cameras.push_back({.time = t,
                                .eye = target + size * Vec<double>{-0.45, -0.65, 7.1},
                                .target = target,
                                .focalLength = 66,
                                .across = half / (1.95 * size)});
    }
    view.ground = false;
    view.glowCenter = place(1.174, -1.51, -2);
    addPole(view, box.low.y, std::sqrt(width * height / (flyLength * hoistLength)));
    return view;
}

}  // namespace

Scene flag(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const bool own = knobs.text("mesh").empty();
    const int columns = knobs.byQuality(62, 126, 254), rows = knobs.byQuality(40, 80, 160);
    const InspectedMesh mesh = clothOf(knobs, columns, rows);
    Matter matter{.density = density};
    for (const Vec<double>& x : mesh.shape.positions) matter.start.push_back(flying(x));
    const Range cloth = world.add(mesh.shape, matter);
    world.warnings = mesh.warnings;
    const double nearPole = hoistTop.x + 0.005 * (boxOf(world.rest).high.x - hoistTop.x);
    const std::vector<int> hoist =
        world.select(cloth, [&](const Vec<double>& x) { return x.x < nearPole; });
    world.pin(hoist);
    if (!own) warnOfLooseParts(world, mesh, hoist);

    world.act<Gravity>(GravityOptions{});
    actAir(world, {.density = 1.2,
                   .drag = 1.2,
                   .tangentialDrag = 0.05,
                   .carried = carried,
                   .interval = airInterval,
                   .wind = windOf(knobs)});
    const std::vector<int> threads =
        own ? weave(world, cloth, gridThreads(columns), shearStiffness, "", mending)
            : hold(world, cloth);

    const bool meets = knobs.text("self-collision") == "on";
    if (meets && !own) refuseCrossing(mesh, world.start);
    Surface surface{.vertices = cloth};
    if (own) surface.thickness = 0.001;
    if (meets) meet(world, {surface}, {.order = 9});

    // Half the strain of first order, and its energy falls as steadily
    // (tests/scenes/test_flag.cpp).
    scene.options.integrator = Integrator::bdf2;
    scene.options.schedule = {.substeps = knobs.byQuality(60, 80, 110), .iterations = 1};
    scene.seconds = seconds;
    constexpr double unbound = std::numeric_limits<double>::infinity();
    scene.metrics = {greatestStrain(world, threads, {0, own ? 2 : unbound}),
                     commonStrain(world, threads, {0, own ? 1 : unbound}),
                     selfIntersections(world, cloth, {0, meets ? 0 : unbound}),
                     folds(world, cloth, {}), contactFailures()};
    scene.view = viewOf(cloth, world.rest);
    return scene;
}

}  // namespace plait
