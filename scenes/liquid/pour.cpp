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
constexpr std::array hand{Pose{0, 45, -0.085, 0.222},    Pose{0.3, 68, -0.066, 0.223},
                          Pose{0.8, 80, -0.058, 0.226},  Pose{1.4, 91, -0.054, 0.229},
                          Pose{1.9, 101, -0.051, 0.232}, Pose{2.3, 112, -0.05, 0.235},
                          Pose{2.6, 112, -0.052, 0.238}, Pose{3.5, 40, -0.09, 0.255}};

// A cubic between two poses that stands still at both ends or goes on as it came.
Pose poseAt(double t) {
    const int n = static_cast<int>(hand.size());
    int i = 0;
    while (i + 2 < n && hand[i + 1].t < t) ++i;
    const Pose &a = hand[i], &b = hand[i + 1];
    const double f = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
    const auto mixed = [&](double Pose::* what) {
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

// A lattice of so many, from below up, as level as water is.
Shape waterIn(const Vessel& jug, const Frame& frame, int count, double spacing) {
    const Profile wall(jug.wall);
    const Placement place(frame, "jug");
    const int across = static_cast<int>(0.25 / spacing);
    Shape shape;
    for (int j = -across; std::ssize(shape.positions) < count && j < across; ++j)
        for (int k = -across; k <= across; ++k)
            for (int i = -across; i <= across; ++i) {
                const auto shaken = [&](int n, int by) {
                    return (n + 2e-2 * ((7 * i + 13 * j + by * k) % 5 - 2)) * spacing;
                };
                const Vec<double> p =
                    frame.origin + Vec<double>{shaken(i, 5), shaken(j, 11), shaken(k, 17)};
                const Vec<double> own = place.own(p);
                const double r = std::hypot(own.x, own.z);
                if (!jug.holds(r, own.y) || wall.nearest(r, own.y).distance < 0.5 * spacing)
                    continue;
                if (std::ssize(shape.positions) < count) shape.positions.push_back(p);
            }
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()));
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
        Collider wet = smoothWall(Solid::plane());  // it keeps what is spilled
        wet.staticFriction = wet.dynamicFriction = 0.6;
        return {wet, smoothWall(Solid::turned(Profile(glass.wall))),
                smoothWall(Solid::turned(Profile(tray)))};
    }
    Collider tilting() const {
        Collider wall = smoothWall(Solid::turned(Profile(jug.wall)));
        wall.motion = [vessel = jug](double t) { return jugAt(vessel, t - settles); };
        return wall;
    }
};

// Of one particle at a time (s): where it is.
struct Places {
    Table table;
    std::vector<Collider> walls;
    double spacing;

    bool inGlass(const Vec<double>& p) const {
        return table.glass.holds(std::hypot(p.x, p.z), p.y);
    }
    bool inWall(const Vec<double>& p, double t) const {
        return std::ranges::any_of(walls, [&](const Collider& wall) {
            const Placement at(wall.motion ? wall.motion(t + settles) : wall.frame, "wall");
            return sideOf(wall.solid, at.own(p)).distance < 0;
        });
    }
    // What has left jug, glass and table alike.
    bool isLost(const Vec<double>& p) const { return !(length(p) < 0.8); }
};

std::vector<Metric> metricsOf(const Table& table, const Liquid& liquid, double percent) {
    const Places places{table, liquid.walls, liquid.spacing};
    const Liquid shaded{liquid.particles, liquid.spacing, liquid.walls, shadesOf(liquid)};
    const auto countOf = [](const auto& which) {
        return [which](const Snapshot& at) {
            return static_cast<double>(std::ranges::count_if(
                at.positions, [&](const Vec<double>& p) { return which(p, at.time); }));
        };
    };
    const auto held = [=](const Vec<double>& p, double) { return !places.isLost(p); };
    const auto inWall = [=](const Vec<double>& p, double t) { return places.inWall(p, t); };
    const double n = liquid.particles.size();
    // What the glass is full to by the height of the water's centre, over what its particles are.
    const auto volume = [=](const Snapshot& at) {
        double count = 0, sum = 0;
        for (const Vec<double>& p : at.positions)
            if (places.inGlass(p)) ++count, sum += p.y;
        if (count < 0.05 * n) return 100.0;
        const Vessel& glass = places.table.glass;
        return 100 * glass.volume(glass.levelOf(sum / count)) /
               (count * std::pow(places.spacing, 3));
    };
    const auto inGlass = [=](const Snapshot& at) {
        return 1e6 * std::pow(places.spacing, 3) *
               static_cast<double>(std::ranges::count_if(
                   at.positions, [&](const Vec<double>& p) { return places.inGlass(p); }));
    };
    const auto compression = [=](const Snapshot& at) {
        return 100 * (std::ranges::max(densityRatios(shaded, at.positions, at.time + settles)) - 1);
    };
    return {{.name = "particles", .unit = "", .measure = countOf(held), .low = n, .high = n},
            {.name = "in walls", .unit = "", .measure = countOf(inWall), .low = 0, .high = 0},
            {.name = "in the glass", .unit = "ml", .measure = inGlass, .caption = true},
            {.name = "volume in the glass",
             .unit = "%",
             .measure = volume,
             .low = 97,
             .high = 103,
             .from = 3.9},
            {.name = "largest compression",
             .unit = "%",
             .measure = compression,
             .low = 0,
             .high = percent},
            contactFailures()};
}

// By vertex of the wall as it is turned: see Prop.
std::vector<double> hollowOf(const Vessel& vessel, int sides, double foot) {
    std::vector<double> hollow;
    const std::size_t outside = vessel.wall.size() - vessel.cavity.size();
    for (std::size_t i = 0; i < vessel.wall.size(); ++i) {
        const auto [r, y] = vessel.wall[i];
        const double in = y < foot ? 0.93 * r : vessel.radius(y);
        hollow.insert(hollow.end(), static_cast<std::size_t>(sides),
                      i >= outside ? -1
                      : r > 0      ? in / r
                                   : 0);
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
    // Larger than they are: water reaches into the dark edge that glass around it has.
    view.looks = {{.object = liquid.particles,
                   .material = Material::water,
                   .color = {0.04, 0.16, 0.26},
                   .radius = 0.7 * liquid.spacing,
                   .wall = {.thickness = 0.3, .clear = 0.2}}};
    view.props = {propOf(table.glass, 0.0104), propOf(table.jug, -1)};
    view.props.back().motion = [vessel = table.jug](double t) { return jugAt(vessel, t); };
    view.props.push_back({turned(table.tray, 96), Material::matte, {0.03, 0.035, 0.045}});
    view.cameras = {{.eye = {0.0, 0.29, 1.05}, .target = {-0.055, 0.178, 0}, .focalLength = 50}};
    view.groundSize = 0.17;
    view.stage.floor = {0.05, 0.055, 0.07};
    view.glowCenter = {-0.02, 0.15, 0};
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
    scene.options.sweeps = Sweeps::oneWay;
    scene.lead = settles;
    scene.seconds = 4;
    scene.metrics = metricsOf(table, liquid, 15);
    char fact[160];
    std::snprintf(
        fact, sizeof fact,
        "%d particles of %.2f mm, %d substeps in 1/60 s; the jug holds %.0f ml, the glass "
        "%.0f ml",
        count, 1e3 * liquid.spacing, substeps, 1e6 * poured,
        1e6 * table.glass.volume(table.glass.rim()));
    scene.facts = {fact};
    scene.view = viewOf(table, liquid);
    return scene;
}

}  // namespace plait
