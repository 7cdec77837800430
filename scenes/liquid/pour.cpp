// A jug pours what it holds into a wine glass, until that runs over.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "liquid.h"
#include "vessels.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/particles/liquid.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double poured = 0.6e-3;  // m^3
constexpr double gravity = 9.81;   // m/s^2
constexpr double settles = 0.5;    // s, before the film
constexpr double slow = 2.5;       // times, the film

// Time (s), tilt (degrees), and where the lip is (m), of a hand that pours.
struct Pose {
    double t, tilt, x, y;
};
constexpr std::array hand{Pose{0, 28, -0.105, 0.222},    Pose{0.35, 58, -0.072, 0.222},
                          Pose{0.7, 73, -0.062, 0.225},  Pose{1.3, 83, -0.056, 0.228},
                          Pose{2.0, 96, -0.052, 0.23},   Pose{2.6, 112, -0.05, 0.235},
                          Pose{2.9, 112, -0.052, 0.238}, Pose{3.7, 40, -0.09, 0.26}};

// A cubic between two poses that stands still at both ends or goes on as it came.
Pose poseAt(double t) {
    const int n = static_cast<int>(hand.size());
    int i = 0;
    while (i + 2 < n && hand[i + 1].t < t) ++i;
    const Pose &a = hand[i], &b = hand[i + 1];
    const double f = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
    const auto mixed = [&](double Pose::*what) {
        const auto slope = [&](int k) {
            if (k == 0 || k == n - 1) return 0.0;
            return (hand[k + 1].*what - hand[k - 1].*what) / (hand[k + 1].t - hand[k - 1].t);
        };
        const double span = b.t - a.t, p = a.*what, q = b.*what;
        const double u = span * slope(i), v = span * slope(i + 1);
        return p + f * u + f * f * (3 * (q - p) - 2 * u - v) + f * f * f * (2 * (p - q) + u + v);
    };
    return {t, mixed(&Pose::tilt), mixed(&Pose::x), mixed(&Pose::y)};
}

// Tilted about its lip.
Frame jugAt(const Vessel& jug, double t) {
    const Pose pose = poseAt(t);
    const double a = pi / 180 * pose.tilt, c = cosine(a), s = sine(a);
    const auto [r, h] = jug.cavity.back();
    return {.origin = {pose.x - r * c - h * s, pose.y + r * s - h * c, 0},
            .across = {c, -s, 0},
            .up = {s, c, 0}};
}

// A lattice of so many, from the bottom up.
Shape waterIn(const Vessel& jug, const Frame& frame, int count, double spacing) {
    const Profile wall(jug.wall);
    const int across = static_cast<int>(0.06 / spacing);
    Shape shape;
    for (int j = 0; static_cast<int>(shape.positions.size()) < count; ++j)
        for (int k = -across; k <= across; ++k)
            for (int i = -across; i <= across; ++i) {
                const auto shaken = [&](int n, int by) {
                    return (n + 2e-2 * ((7 * i + 13 * j + by * k) % 5 - 2)) * spacing;
                };
                const double x = shaken(i, 5), y = 0.55 * spacing + shaken(j, 11),
                             z = shaken(k, 17), r = std::hypot(x, z);
                if (!jug.holds(r, y) || wall.nearest(r, y).distance < 0.5 * spacing) continue;
                if (static_cast<int>(shape.positions.size()) < count)
                    shape.positions.push_back(frame.origin + Vec<double>{x, y, z});
            }
    shape.complex = SimplicialComplex(count);
    return shape;
}

Collider smoothWall(Solid solid, const Frame& frame = {}) {
    Collider wall{.solid = std::move(solid), .frame = frame};
    wall.staticFriction = wall.dynamicFriction = 0;
    return wall;
}

struct Table {
    double thick;
    Vessel jug, glass;
    Outline tray;

    explicit Table(double spacing)
        : thick(std::max(0.0022, 1.2 * spacing)),
          jug(carafe(thick)),
          glass(wineGlass(thick)),
          tray(trayRim(std::max(0.005, thick))) {}

    std::vector<Collider> still() const {
        return {smoothWall(Solid::plane()), smoothWall(Solid::turned(Profile(glass.wall))),
                smoothWall(Solid::turned(Profile(tray)))};
    }
    Collider tilting() const {
        Collider wall = smoothWall(Solid::turned(Profile(jug.wall)));
        wall.motion = [vessel = jug](double t) { return jugAt(vessel, t - settles); };
        return wall;
    }
};

// By vertex of the wall as it is turned: see Prop.
std::vector<double> hollowOf(const Vessel& vessel, int sides, double foot) {
    std::vector<double> hollow;
    const std::size_t outside = vessel.wall.size() - vessel.cavity.size();
    for (std::size_t i = 0; i < vessel.wall.size(); ++i) {
        const auto [r, y] = vessel.wall[i];
        const double in = y < foot ? 0.93 * r : vessel.radius(y);
        hollow.insert(hollow.end(), static_cast<std::size_t>(sides),
                      i >= outside ? -1 : r > 0 ? in / r : 0);
    }
    return hollow;
}

Prop propOf(const Vessel& vessel, double foot) {
    constexpr int sides = 96;
    return {.shape = turned(vessel.wall, sides),
            .material = Material::crystal,
            .hollow = hollowOf(vessel, sides, foot)};
}

View viewOf(const Table& table, const Liquid& liquid) {
    View view;
    view.looks = {{.object = liquid.particles,
                   .material = Material::water,
                   .color = {0.03, 0.15, 0.27},
                   .radius = 0.5 * liquid.spacing}};
    view.props = {propOf(table.glass, 0.0104), propOf(table.jug, -1)};
    view.props.back().motion = [vessel = table.jug](double t) { return jugAt(vessel, t); };
    view.props.push_back({turned(table.tray, 96), Material::matte, {0.03, 0.035, 0.045}});
    view.cameras = {{.eye = {-0.03, 0.36, 0.92}, .target = {-0.06, 0.165, 0}, .focalLength = 50}};
    view.groundSize = 0.5;
    view.stage.floor = {0.05, 0.055, 0.07};
    view.glowCenter = {0, 0.15, -0.5};
    view.glow = 0.9;
    view.takes = {{.from = 0, .to = 4, .slow = slow, .words = "2.5 times slower"}};
    return view;
}

}  // namespace

Scene pouring(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int count = knobs.byQuality(5000, 50000, 500000);
    Liquid liquid{.particles = {}, .spacing = std::cbrt(poured / count)};
    const Table table(liquid.spacing);
    liquid.particles = world.add(waterIn(table.jug, jugAt(table.jug, 0), count, liquid.spacing),
                                 {.density = 1000 * std::pow(liquid.spacing, 3)});
    const std::vector<Collider> still = table.still();
    liquid.walls = still;
    liquid.walls.push_back(table.tilting());
    world.act<Gravity>(GravityOptions{.acceleration = {0, -gravity, 0}});
    holdDensity(world, liquid, {.name = "density"});
    collide(world, still, {surfaceOf(liquid)}, {.name = "glass and tray", .order = 1});
    collide(world, {liquid.walls.back()}, {surfaceOf(liquid)}, {.name = "jug", .order = 1});

    const double h = std::sqrt(2 * liquid.relaxation) * liquid.spacing / knobs.number("sound");
    const int substeps = static_cast<int>(std::ceil(1 / (60 * h)));
    scene.options.schedule = {
        .substeps = substeps, .frameRate = {60, 1}, .iterations = 1, .collisionPasses = 1};
    scene.lead = settles;
    scene.seconds = 4;
    scene.metrics = {contactFailures()};
    scene.view = viewOf(table, liquid);
    return scene;
}

}  // namespace plait
