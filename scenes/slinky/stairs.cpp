// Down a staircase, end over end, from one push of a hand.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "slinky.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plait {
namespace {

constexpr double seconds = 4.5, arcSeconds = 0.5, arcHeight = 0.12;
constexpr int floorTreads = 6;   // how long it goes on level below
constexpr double onWire = 0.15;  // friction
// m/s: how fast turns part that fell too near each other. At 0.5 where they jam goes on trembling
// at 1 m/s, at 0.05 steps take a second, as too much of what they fall with is lost.
constexpr double turnsPart = 0.35;
constexpr double depth = 0.24;  // m, of a tread, across the way

struct Stairs {
    double rise, tread;  // m
    int steps;
};

// Treads from y = 0 down along +x, the first of them `lead` treads long.
Shape shapeOf(const Stairs& stairs, int lead) {
    constexpr int across = 4;
    std::vector<std::array<double, 2>> profile;
    const auto walk = [&](double x, double y) {
        // Cells about as long as they are wide.
        if (profile.empty()) return profile.push_back({x, y});
        const auto [x0, y0] = profile.back();
        const int parts = std::max(
            1, static_cast<int>(std::lround((std::fabs(x - x0) + std::fabs(y - y0)) / 0.06)));
        for (int i = 1; i <= parts; ++i)
            profile.push_back({x0 + (x - x0) * i / parts, y0 + (y - y0) * i / parts});
    };
    walk(-(lead - 1) * stairs.tread, 0);
    for (int k = 0; k < stairs.steps; ++k) {
        walk((k + 1) * stairs.tread, -k * stairs.rise);
        walk((k + 1) * stairs.tread, -(k + 1) * stairs.rise);
    }
    walk((stairs.steps + floorTreads) * stairs.tread, -stairs.steps * stairs.rise);
    const int columns = static_cast<int>(profile.size());
    Shape shape = grid({.columns = columns, .rows = across + 1});
    for (int row = 0; row <= across; ++row)
        for (int i = 0; i < columns; ++i)
            shape.positions[row * columns + i] = {profile[i][0], profile[i][1],
                                                  depth * (0.5 - double(row) / across)};
    return shape;
}

// What is drawn of them: slabs of wood, 20 mm thick, on risers of slate.
void addStairs(View& view, const Stairs& stairs) {
    constexpr double thick = 0.02;
    for (int k = -1; k <= stairs.steps; ++k) {
        const double y = -std::max(k, 0) * stairs.rise, left = (k < 0 ? -2 : k) * stairs.tread,
                     right = (k < stairs.steps ? k + 1 : stairs.steps + floorTreads) * stairs.tread;
        view.props.push_back({block({.width = right - left, .height = thick, .depth = depth},
                                    {.origin = {left, y - thick, -depth / 2}}),
                              Material::matte,
                              {0.30, 0.135, 0.05}});
        addBox(view, {left, y - 2, -depth / 2 + 0.004},
               {right - 0.003, y - thick, depth / 2 - 0.004});
    }
}

// The hand lifts the upper turn over in an arc, and lays it on the next tread upside down.
Motion handOf(const Slinky& slinky, const Stairs& stairs, const Vec<double>& middle) {
    return [=](const Vec<double>& start, double t) {
        const double s = std::clamp(t / arcSeconds, 0.0, 1.0), q = s * s * (3 - 2 * s);
        const double angle = -pi * q, c = cosine(angle), sn = sine(angle);
        const Vec<double> at = start - middle;
        const Vec<double> to{middle.x + stairs.tread * (1 - cosine(pi * q)) / 2,
                             (1 - q) * middle.y + q * (-stairs.rise + 0.7 * slinky.wire.across) +
                                 4 * arcHeight * q * (1 - q),
                             middle.z};
        return to + Vec<double>{c * at.x - sn * at.y, sn * at.x + c * at.y, at.z};
    };
}

// In treads from the first one's middle: the middle of the end that began below, or above.
Metric wayOf(const Slinky& slinky, const Rod& rod, const Stairs& stairs, bool upper) {
    return {.name = upper ? "upper end" : "lower end",
            .unit = "treads",
            .measure = [=, first = upper ? rod.points.last - slinky.links
                                         : rod.points.first](const Snapshot& at) {
                double sum = 0;
                for (int i = 0; i < slinky.links; ++i) sum += at.positions[first + i].x;
                return sum / slinky.links / stairs.tread - 0.5;
            }};
}

}  // namespace

Scene slinky(const Knobs& knobs) {
    const Slinky slinky;
    const Stairs stairs{knobs.number("rise"), knobs.number("tread"),
                        static_cast<int>(knobs.number("steps"))};
    Scene scene;
    World& world = scene.world;
    const double closed = slinky.turns * slinky.wire.across;
    const Vec<double> foot{stairs.tread / 2, 0.0004, 0};
    const Rod rod = addSlinky(world, slinky, foot);
    const Range wood = world.add(shapeOf(stairs, 3));
    const std::vector<int> held = upperTurns(slinky, rod, 1);
    world.pin(held, handOf(slinky, stairs, foot + Vec<double>{0, closed, 0}));
    std::vector<int> still;
    for (int v = wood.first; v < wood.last; ++v) still.push_back(v);
    world.pin(still);
    world.act<Gravity>(GravityOptions{});
    const double friction = knobs.number("friction");
    Surface skin = skinOf(slinky, rod);
    skin.staticFriction = skin.dynamicFriction = onWire;
    meet(world,
         {skin,
          {.vertices = wood,
           .thickness = 0,
           .staticFriction = onWire,
           .dynamicFriction = onWire,
           .self = Self::none}},
         {.otherFriction = friction / onWire, .recovery = turnsPart});
    world.letGo(held, arcSeconds);

    // With 64 its wire is up to 1.3 % too long where an end lands.
    scene.options.schedule = {.substeps = 72, .frameRate = {48, 1}, .iterations = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.options.damping = 1 - exponential(-0.2 / 24);
    scene.seconds = seconds;
    scene.metrics = {
        wayOf(slinky, rod, stairs, false), wayOf(slinky, rod, stairs, true),
        greatestStrain(world, rod.points, {0, std::numeric_limits<double>::infinity()}),
        ridingOff(slinky, rod, {0, std::numeric_limits<double>::infinity()}), contactFailures()};
    scene.facts = factsOf(slinky);

    View& view = scene.view;
    view.looks = {lookOf(slinky, rod)};
    addStairs(view, stairs);
    // Beside where the slinky is by then, as those steps go, and below no longer down.
    const auto camera = [&](double time, double steps) {
        const double way = std::min(steps, stairs.steps + 0.2);
        const Vec<double> at{(0.5 + way) * stairs.tread, -way * stairs.rise, 0};
        return Camera{.time = time,
                      .eye = at + Vec<double>{0.55, 0.42, 1.6},
                      .target = at + Vec<double>{0.04, -0.03, 0},
                      .focalLength = 66};
    };
    view.cameras = {camera(0, 0.5), camera(0.5, 0.7), camera(2, 2.6), camera(3.4, 4.9),
                    camera(4.5, 5.2)};
    view.ground = false;
    view.glow = 0.15;
    view.takes = {{.from = 0, .to = seconds},
                  {.from = 0.4, .to = seconds, .slow = 2, .words = "at half speed"}};
    return scene;
}

}  // namespace plait
