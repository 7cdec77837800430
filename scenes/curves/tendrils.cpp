// Limp cords and curled tendrils on a bar that sways.
#include "../parts/hung_helix.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "curves.h"

#include <plait/forces/gravity.h>
#include <plait/numbers/arctangent.h>
#include <plait/numbers/elementary.h>
#include <plait/rods/rod.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace plait {
namespace {

constexpr double g = 9.81;       // m/s^2
constexpr double swaying = 2.4;  // s
constexpr double still = 5.5;    // s, when what swayed has come to rest
constexpr int cordLinks = 64, turnLinks = 24;
constexpr double curl = 0.024, pitch = 0.007;  // m, of a tendril's turns
// Of cotton, and of a plant.
constexpr Wire limp{.youngs = 1e6, .poisson = 0.3, .density = 900, .along = 0.011};
constexpr Wire stem{.youngs = 1.5e7, .poisson = 0.45, .density = 1000, .along = 0.0055};

// m, of the bar along x.
double swayAt(double t) {
    if (t <= 0 || t >= swaying) return 0;
    const double window = sine(pi * t / swaying);
    return 0.11 * window * window * sine(4 * pi * t / swaying);
}

Motion swayed() {
    return [](const Vec<double>& start, double t) { return start + Vec<double>{swayAt(t), 0, 0}; };
}

struct Cord {
    double span, length;  // m
};
constexpr std::array cords{Cord{1.06, 2.1}, Cord{0.78, 1.36}, Cord{0.5, 0.74}};

// From both ends straight to the middle.
Shape vee(const Cord& cord) {
    Shape shape = chain({.links = cordLinks});
    const double half = cord.span / 2, halfLength = cord.length / 2,
                 drop = std::sqrt(halfLength * halfLength - half * half);
    for (int i = 0; i <= cordLinks; ++i) {
        const double s = 2.0 * i / cordLinks - 1;
        shape.positions[static_cast<std::size_t>(i)] = {half * s, drop * (std::fabs(s) - 1), 0};
    }
    return shape;
}

// In % of its length: how far the cord is from y = a cosh(x / a), 2 a sinh(span / 2 a) = length, at
// worst.
Metric offCatenary(Range cord, const Cord& shape, Band band) {
    double low = 0.02 * shape.span, high = 100 * shape.span;
    for (int i = 0; i < 200; ++i) {
        const double a = (low + high) / 2;
        (2 * a * std::sinh(shape.span / (2 * a)) > shape.length ? low : high) = a;
    }
    return {
        .name = "off catenary " + std::to_string(std::lround(100 * shape.length)) + " cm",
        .unit = "%",
        .measure =
            [=, a = low](const Snapshot& at) {
                double worst = 0;
                for (int i = 0; i <= cordLinks; ++i) {
                    const double s = shape.length * (double(i) / cordLinks - 0.5);
                    const Vec<double> exact{a * std::asinh(s / a),
                                            std::sqrt(a * a + s * s) -
                                                std::sqrt(a * a + shape.length * shape.length / 4),
                                            0};
                    const Vec<double>& x = at.positions[cord.first + i];
                    worst =
                        std::max(worst, length(Vec<double>{x.x - swayAt(at.time), x.y, 0} - exact));
                }
                return 100 * worst / shape.length;
            },
        .low = band.low,
        .high = band.high,
        .from = band.from,
        .caption = shape.length == cords.front().length};
}

struct Tendril {
    double x, z;  // m
    int turns;
};
constexpr std::array curls{Tendril{-0.93, 0, 8},     Tendril{-0.81, 0.02, 11},
                           Tendril{-0.69, -0.01, 6}, Tendril{0.69, 0.01, 9},
                           Tendril{0.81, -0.02, 7},  Tendril{0.93, 0, 12}};

// From below upwards; its last turn goes round the bar's pin.
Rod addTendril(World& world, const Tendril& tendril) {
    const int links = tendril.turns * turnLinks;
    const Shape shape =
        helix({.links = links, .radius = curl, .turns = double(tendril.turns), .pitch = pitch},
              {.origin = {tendril.x, -tendril.turns * pitch, tendril.z}});
    std::vector<Vec<double>> outward;
    for (int e = 0; e < links; ++e) {
        const auto i = static_cast<std::size_t>(e);
        const Vec<double> middle = 0.5 * (shape.positions[i] + shape.positions[i + 1]);
        outward.push_back({middle.x - tendril.x, 0, middle.z - tendril.z});
    }
    const Rod rod = addRod(world, shape, {.wire = stem, .toward = outward},
                           {.name = "tendril " + std::to_string(std::lround(100 * tendril.x))});
    std::vector<int> held;
    for (int i = 0; i <= turnLinks; ++i) held.push_back(rod.points.last - 1 - i);
    for (int i = 0; i < turnLinks; ++i) held.push_back(rod.directors.last - 1 - i);
    world.pin(held, swayed());
    return rod;
}

// In % of what its wire says (sagOf): how far the lowest turn has sunk.
Metric drawnOut(const Rod& rod, int turns, Band band) {
    const double around = std::sqrt(4 * pi * pi * curl * curl + pitch * pitch),
                 expected = sagOf({arctangent2(pitch, 2 * pi * curl), curl},
                                  {stem.bendingSide(), stem.twisting()}, (turns - 1) * around,
                                  stem.density * stem.area() * g);
    return {.name = "drawn out",
            .unit = "%",
            .measure =
                [=, first = rod.points.first](const Snapshot& at) {
                    double sum = 0;
                    for (int i = 0; i < turnLinks; ++i) sum += at.positions[first + i].y;
                    return -100 * (sum / turnLinks + (turns - 0.5) * pitch) / expected;
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

void addBeam(View& view) {
    addBar(view, {-1.03, 0, 0}, {1.03, 0, 0}, 0.011, Material::brass);
    for (Prop& prop : view.props)
        prop.motion = [](double t) { return Frame{.origin = {swayAt(t), 0, 0}}; };
}

}  // namespace

Scene tendrils(const Knobs&) {
    Scene scene;
    World& world = scene.world;
    View& view = scene.view;
    view = viewOf({}, {0, -0.45, 0}, 1.15, Material::rubber, {0.1, 0.12, 2.3});
    std::vector<Shape> shapes;
    for (const Cord& cord : cords) shapes.push_back(vee(cord));
    const std::vector<Rod> rods =
        addRods(world, shapes, {.wire = limp, .model = RodModel::straight}, {.name = "cords"});
    for (std::size_t i = 0; i < cords.size(); ++i) {
        const Range& points = rods[i].points;
        world.pin({points.first, points.last - 1}, swayed());
        scene.metrics.push_back(offCatenary(points, cords[i], {0, 0.5, still}));
        Look look = lookOf(points, Material::rubber, limp.along / 2);
        look.color = {0.880, 0.791, 0.658};
        look.section = {.along = limp.along};
        view.looks.push_back(look);
    }
    for (const Tendril& tendril : curls) {
        const Rod rod = addTendril(world, tendril);
        if (tendril.turns == 12)
            scene.metrics.push_back(drawnOut(rod, tendril.turns, {95, 100, still}));
        Look look = lookOf(rod.points, Material::rubber, stem.along / 2);
        look.section = {.along = stem.along};
        look.directors = rod.directors;
        view.looks.push_back(look);
    }
    world.act<Gravity>(GravityOptions{});
    scene.options.schedule = {.substeps = 20, .iterations = 1};
    scene.options.sweeps = Sweeps::oneWay;
    scene.options.damping = 1 - exponential(-2.0 / 24);
    scene.seconds = 7;
    addBeam(view);
    view.ground = false;
    return scene;
}

}  // namespace plait
