// A pawn of sand is let go of from its head down, and comes to be a heap.
#include "../parts/measures.h"
#include "../parts/views.h"
#include "particles.h"
#include "sand.h"

#include <plait/numbers/elementary.h>
#include <plait/sources/source.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double tall = 0.15;                // m
constexpr double begins = 0.7, takes = 2.6;  // s, until the head goes, and from there to the foot

// m, of the pawn at a height.
double radiusAt(double y) {
    const auto ball = [y](double middle, double r) {
        return squareRoot(std::max(0.0, r * r - (y - middle) * (y - middle)));
    };
    const double foot = y < 0.018 ? 0.048 : 0, collar = std::fabs(y - 0.092) < 0.005 ? 0.03 : 0;
    const double f = std::clamp((y - 0.018) / 0.074, 0.0, 1.0);
    const double body = y < 0.1 ? 0.017 + 0.023 * (1 - f) * (1 - f) : 0;
    return std::max({foot, collar, body, ball(tall - 0.03, 0.03)});
}

// Layers of balls that nearly touch, each the points of one height (m), each turned against the
// last: balls that stand straight above each other would stay so, since they do not roll.
std::vector<std::vector<Vec<double>>> layersOf(double radius) {
    const double across = 2.15 * radius, row = across * squareRoot(0.75), goldenAngle = 2.39996;
    std::vector<std::vector<Vec<double>>> layers;
    const int most = static_cast<int>(0.05 / row) + 2;
    for (int j = 0; (1 + 2.15 * j) * radius < tall; ++j) {
        std::vector<Vec<double>> layer;
        const double y = (1 + 2.15 * j) * radius;
        const double c = cosine(goldenAngle * j), s = sine(goldenAngle * j);
        for (int k = -most; k <= most; ++k)
            for (int i = -most; i <= most; ++i) {
                const double x = across * (i + 0.4 + 0.5 * (k & 1)), z = row * (k + 0.3);
                const Vec<double> p{c * x + s * z, y, c * z - s * x};
                if (std::hypot(p.x, p.z) < radiusAt(y)) layer.push_back(p);
            }
        if (!layer.empty()) layers.push_back(std::move(layer));
    }
    return layers;
}

// s, when what was at a height is let go of.
double releaseAt(double y) { return begins + takes * (1 - y / tall); }

}  // namespace

Scene dissolve(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double radius = knobs.byQuality(3e-3, 2.2e-3, 1.6e-3);
    const auto layers = layersOf(radius);
    scene.view = viewOf({}, {0, 0.06, 0}, 0.24, Material::matte, {0.5, 0.4, 2.2});
    int first = -1, last = 0;
    for (const std::vector<Vec<double>>& layer : layers) {
        const auto count = static_cast<int>(layer.size());
        const Range spare =
            world.add({SimplicialComplex(0), {}}, {.density = sandMass(radius), .spare = count});
        if (first < 0) first = spare.first;
        last = spare.last;
        const SourceOptions source{.name = "layer " + std::to_string(scene.view.looks.size() + 1),
                                   .spare = spare,
                                   .nozzle = layer,
                                   .every = 1000,
                                   .scatter = 0.07 * radius,
                                   .hold = releaseAt(layer.front().y),
                                   .seed = knobs.seed + static_cast<std::uint64_t>(spare.first)};
        world.act<Source>(source);
        Look look{.object = spare, .material = Material::matte, .radius = radius};
        look.point = [=](std::int32_t id, double age) {
            const double pale = numberOf(id, source.seed, 7),
                         sand = std::clamp((age - source.hold) / 0.5, 0.0, 1.0);
            const auto mixed = [=](double stone, double gold) {
                return ((1 - sand) * stone + sand * gold) * (0.85 + 0.3 * pale);
            };
            return PointLook{radius, {mixed(0.72, 0.66), mixed(0.68, 0.42), mixed(0.62, 0.17)}};
        };
        scene.view.looks.push_back(std::move(look));
    }
    const Grains sand = sandOf({first, last}, radius, knobs.number("friction"));
    addSand(scene, sand);
    scene.seconds = 5;

    const auto centre = [](const Snapshot& at) {
        double sum = 0;
        for (const Vec<double>& p : at.positions) sum += p.y;
        return 1000 * sum / static_cast<double>(at.positions.size());
    };
    const double all = sand.vertices.size();
    scene.metrics = {
        countThere("grains", all, all),
        {.name = "centre", .unit = "mm", .measure = centre, .low = 8, .high = 500 * tall},
        inTheTable(sand),
        contactFailures()};
    for (Metric& metric : scene.metrics)
        metric.from = 1e-3;  // none is there before the first substep
    char fact[120];
    std::snprintf(fact, sizeof fact, "%d grains of %.1f mm in %zu layers, let go one by one",
                  sand.vertices.size(), 2e3 * radius, layers.size());
    scene.facts = {fact};
    scene.view.groundHeight = 0;
    return scene;
}

}  // namespace plait
