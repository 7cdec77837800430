// A tress of wavy hair in gusts.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "curves.h"

#include <plait/air/air.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/numbers/splitmix.h>
#include <plait/rods/rod.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace plait {
namespace {

// A strand is a lock of a hundred hairs of 70 um that slide on each other: a hundred times the area
// and the stiffness of one, not of a rope as thick.
constexpr int hairs = 100;
constexpr Wire lock{.youngs = 3.7e9 / hairs, .poisson = 0.35, .density = 1300, .along = 0.7e-3};
constexpr int links = 32;
constexpr double reach = 0.31;                // m, of a lock, undrawn
constexpr double wave = 0.008, turns = 2.75;  // m, of its waves; in all its length
constexpr double thickness = 0.5e-3;          // m, to either side
constexpr double head = 0.085, chin = 0.15;   // m, from the middle up and aside, and down
constexpr double lead = 1.2;                  // s, in which the tress falls before the film

Vec<double> unit(const Vec<double>& a) { return (1 / length(a)) * a; }

// Where locks grow: a cap of the head around this direction, evenly by the golden angle.
constexpr double cap = 0.55;  // rad
std::vector<Vec<double>> roots(int count) {
    const Vec<double> middle = unit({0.62, 0.78, 0}), side = unit({0.78, -0.62, 0}), other{0, 0, 1};
    std::vector<Vec<double>> at;
    for (int i = 0; i < count; ++i) {
        const double turn = 2.399963 * i, out = cap * std::sqrt((i + 0.5) / count);
        at.push_back((head + thickness) * (cosine(out) * middle +
                                           sine(out) * (cosine(turn) * side + sine(turn) * other)));
    }
    return at;
}

// Waves begin small, so that a lock leaves the scalp where it grows.
Shape lockFrom(const Vec<double>& root, Splitmix& chance) {
    const Vec<double> up = unit(unit(root) + Vec<double>{0.25, 0.1, 0}),
                      across = unit(cross(up, Vec<double>{0, 0, 1}));
    const double size = 1 + 0.12 * chance.both(), phase = 0.5 * chance.both();
    Shape shape = chain({.links = links});
    const Vec<double> other = cross(across, up);
    for (int i = 0; i <= links; ++i) {
        const double s = double(i) / links, a = 2 * pi * turns * s + phase,
                     r = wave * std::min(1.0, 4 * s);
        shape.positions[static_cast<std::size_t>(i)] =
            root + size * (reach * s * up + r * cosine(a) * across + r * sine(a) * other);
    }
    return shape;
}

// In m/s, of the wind along x: two gusts, and a breeze between.
double windAt(double t) {
    const auto gust = [&](double from, double seconds) {
        const double s = (t - from) / seconds;
        return s > 0 && s < 1 ? sine(pi * s) * sine(pi * s) : 0;
    };
    return 0.6 + 4.4 * gust(lead + 0.2, 1.3) + 6 * gust(lead + 1.9, 1.8) +
           3 * gust(lead + 4.2, 1.4);
}

// In % of what it is at rest: how much a lock is bent, in the third at its tip, on average.
Metric curlKept(const World& world, const std::vector<Rod>& rods, Band band) {
    const auto bent = [rods](const std::vector<Vec<double>>& x) {
        double sum = 0;
        for (const Rod& rod : rods)
            for (int v = rod.points.last - links / 3; v + 1 < rod.points.last; ++v)
                sum += length(unit(x[v + 1] - x[v]) - unit(x[v] - x[v - 1]));
        return sum;
    };
    return {.name = "curl kept",
            .unit = "%",
            .measure = [=, rest = bent(world.rest)](
                           const Snapshot& at) { return 100 * bent(at.positions) / rest; },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

// Radius and height (m) from below: half a ball on half an egg.
std::vector<std::array<double, 2>> headProfile() {
    constexpr int rings = 48;
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= rings; ++i) {
        const double a = pi * (double(i) / rings - 0.5), up = sine(a);
        profile.push_back({i % rings == 0 ? 0 : head * cosine(a), (up < 0 ? chin : head) * up});
    }
    return profile;
}

// In mm: how far the deepest vertex is from the scalp.
Metric offScalp(Range points, const Solid& solid, Band band) {
    return {.name = "off scalp",
            .unit = "mm",
            .measure =
                [=](const Snapshot& at) {
                    double least = 1;
                    for (int v = points.first; v < points.last; ++v)
                        least = std::min(least, sideOf(solid, at.positions[v]).distance);
                    return 1000 * least;
                },
            .low = band.low,
            .high = band.high};
}

void addWind(World& world, std::uint64_t seed) {
    actAir(world, {.density = 1.2,
                   .drag = 1.2,
                   .tangentialDrag = 0.1,
                   .width = 2 * lock.along,
                   .wind = {.velocity = [](double t) { return Vec<double>{windAt(t), 0, 0}; },
                            .noise = 0.7,
                            .noiseLength = 0.12,
                            .noiseTime = 0.15,
                            .noiseDrift = {2.5, 0, 0},
                            .seed = seed}});
}

void addHead(View& view) {
    view.props.push_back({turned(headProfile(), 96), Material::matte, {0.62, 0.53, 0.43}});
    addBar(view, {0, -0.7, 0}, {0, -0.97 * chin, 0}, 0.011, Material::brass);
}

View viewOf(Range points) {
    View view =
        plait::viewOf({points}, {0.13, -0.06, 0}, 0.5, Material::brushed, {0.12, 0.16, 1.95});
    view.looks[0].color = {0.36, 0.095, 0.028};
    view.looks[0].section = {.along = lock.along};
    view.looks[0].radius = 0;
    view.ground = false;
    addHead(view);
    return view;
}

}  // namespace

Scene tress(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    Splitmix chance(knobs.seed);
    std::vector<Shape> shapes;
    for (const Vec<double>& root : roots(static_cast<int>(knobs.number("locks"))))
        shapes.push_back(lockFrom(root, chance));
    const std::vector<Rod> rods = addRods(world, shapes, {.wire = lock}, {.name = "locks"});
    for (const Rod& rod : rods)
        world.pin({rod.points.first, rod.points.first + 1, rod.directors.first});
    const Range points{rods.front().points.first, rods.back().points.last};
    world.act<Gravity>(GravityOptions{});
    addWind(world, knobs.seed);
    const Solid solid = Solid::turned(Profile(headProfile()));
    const Surface hair{
        .vertices = points, .thickness = thickness, .staticFriction = 0.2, .dynamicFriction = 0.2};
    meet(world, {hair}, {.order = 1});
    collide(world, {{.solid = solid, .staticFriction = 0.3, .dynamicFriction = 0.3}}, {hair},
            {.order = 2});
    scene.options.schedule = {.substeps = knobs.byQuality(24, 32, 48), .iterations = 2};
    scene.options.sweeps = Sweeps::oneWay;
    scene.options.damping = 1 - exponential(-1.0 / 24);
    scene.lead = lead;
    scene.seconds = 6;
    scene.metrics = {
        curlKept(world, rods, {60, 110}), greatestStrain(world, points, {0, 6}),
        commonStrain(world, points, {0, 1}),
        offScalp(points, solid, {0.25 * 1000 * thickness, std::numeric_limits<double>::infinity()}),
        contactFailures()};

    scene.view = viewOf(points);
    return scene;
}

}  // namespace plait
