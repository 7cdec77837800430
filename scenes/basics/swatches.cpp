// After Cusick's drape test (1968): a swatch hangs over a round support, and its shadow tells how
// it drapes. Ours is square, since threads run straight.
#include "basics.h"

#include "../parts/fabrics.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"

#include <plait/air/air.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <cmath>
#include <string>

namespace plait {
namespace {

constexpr double side = 0.26, support = 0.09, level = 0.16, apart = 0.36;  // m
constexpr double settled = 3;                                              // s
constexpr double mending = 0.008;                                          // of a thread's length

// The rim of a grid of n x n, all the way round.
std::vector<int> rimOf(Range swatch, int n) {
    std::vector<int> rim;
    for (int i = 0; i < n - 1; ++i) rim.push_back(swatch.first + i);
    for (int i = 0; i < n - 1; ++i) rim.push_back(swatch.first + i * n + n - 1);
    for (int i = n - 1; i > 0; --i) rim.push_back(swatch.first + (n - 1) * n + i);
    for (int i = n - 1; i > 0; --i) rim.push_back(swatch.first + i * n);
    return rim;
}

// In %, by fabric: 23, 48, 87, 96 converged with 17 x 17 vertices, 37, 54, 90, 97 with 33 x 33.
Band bandOf(const std::string& fabric) {
    if (fabric == "silk") return {15, 45, settled};
    if (fabric == "cotton") return {40, 60, settled};
    return fabric == "burlap" ? Band{80, 93, settled} : Band{90, 99, settled};
}

// In %: how much of what overhangs is seen from above.
Metric drapeOf(const std::string& name, const std::vector<int>& rim, Band band) {
    return {.name = name + " drape",
            .unit = "%",
            .measure =
                [=](const Snapshot& at) {
                    double twice = 0;
                    for (std::size_t i = 0; i < rim.size(); ++i) {
                        const Vec<double>& a = at.positions[static_cast<std::size_t>(rim[i])];
                        const Vec<double>& b =
                            at.positions[static_cast<std::size_t>(rim[(i + 1) % rim.size()])];
                        twice += a.z * b.x - a.x * b.z;
                    }
                    constexpr double under = pi * support * support;
                    return 100 * (std::fabs(twice) / 2 - under) / (side * side - under);
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

// A flat one folds either way, and rounding decides: waves of a tenth of a millimetre do.
void dent(Shape& swatch, const Vec<double>& middle) {
    for (Vec<double>& x : swatch.positions) {
        const Vec<double> at = x - middle;
        const double angle = arctangent2(at.z, at.x);
        x.y += 1e-4 * (length(at) / side) *
               (sine(2 * angle) + sine(5 * angle + 1) + sine(7 * angle + 2));
    }
}

Look lookOf(const std::string& fabric, Range swatch) {
    if (fabric == "silk") return {.object = swatch, .material = Material::silk};
    if (fabric == "cotton")
        return {.object = swatch, .material = Material::cotton, .color = {0.42, 0.47, 0.55}};
    if (fabric == "burlap")
        return {.object = swatch, .material = Material::cotton, .color = {0.32, 0.20, 0.085}};
    return {.object = swatch, .material = Material::rubber, .color = {0.07, 0.022, 0.01}};
}

}  // namespace

Scene swatches(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int n = knobs.byQuality(17, 33, 65);
    const std::string& asked = knobs.text("fabric");
    View& view = scene.view;
    std::vector<Range> sheets;
    std::vector<int> threads;
    for (const Fabric& fabric : fabrics()) {
        const Fabric& own = asked == "each" ? fabric : findFabric(asked);
        const std::string name =
            asked == "each" ? own.name : own.name + " " + std::to_string(sheets.size() + 1);
        const Vec<double> middle{apart * (static_cast<double>(sheets.size()) - 1.5), level, 0};
        Shape shape = grid({.columns = n, .rows = n, .width = side, .height = side},
                           {.origin = middle + Vec<double>{-side / 2, 0, side / 2},
                            .across = {1, 0, 0},
                            .up = {0, 0, -1}});
        dent(shape, middle);
        const Range swatch = world.add(shape, {.density = own.density});
        world.pin(world.select(swatch, [&](const Vec<double>& x) {
            return std::hypot(x.x - middle.x, x.z) < support;
        }));
        const std::vector<int> links =
            weave(world, swatch, gridThreads(n), own.shearStiffness, name, mending);
        threads.insert(threads.end(), links.begin(), links.end());
        world.constrain(bendRows(world.complex, swatch, world.rest, own.flexuralRigidity),
                        {.name = name + " bend"});
        scene.metrics.push_back(drapeOf(name, rimOf(swatch, n), bandOf(own.name)));
        view.looks.push_back(lookOf(own.name, swatch));
        sheets.push_back(swatch);
    }
    const Range all{sheets.front().first, sheets.back().last};
    world.act<Gravity>(GravityOptions{});
    actAir(world, {});
    scene.options.schedule = {.substeps = knobs.byQuality(40, 120, 400), .iterations = 1};
    scene.options.damping = 0.1;
    scene.seconds = settled + 1;
    scene.metrics.push_back(greatestStrain(world, threads, {0, 2}));
    scene.metrics.back().caption = false;
    scene.metrics.push_back(selfIntersections(world, all, {0, 0}));

    const std::vector<Look> looks = view.looks;
    view = viewOf(sheets, {0, 0.5 * level, 0}, 0.78, Material::cotton, {0.15, 0.5, 2.2});
    view.looks = looks;
    view.groundHeight = 0;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        const double x = apart * (static_cast<double>(i) - 1.5);
        addBar(view, {x, 0, 0}, {x, level, 0}, 0.01, Material::steel);
        addBar(view, {x, level + 0.002, 0}, {x, level + 0.006, 0}, support, Material::matte);
        // Within the vertices at its rim.
        addBar(view, {x, level - 0.006, 0}, {x, level - 0.002, 0}, 0.85 * support, Material::matte);
    }
    return scene;
}

}  // namespace plait
