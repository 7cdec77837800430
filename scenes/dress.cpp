#include "dress.h"

#include "dress_wearer.h"
#include "parts/measures.h"
#include "parts/woven.h"

#include <plait/air/air.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace plait {
namespace {

constexpr double fullness = 1.06;  // of the pattern, gathered by as much where it is sewn on
constexpr double lead = 1.5;       // s, in which the skirt falls before the film begins

constexpr std::array rose{0.72, 0.32, 0.27};

// A layer of the skirt: a ring cut from cloth that lies flat, sewn to the waist along its inside.
struct Layer {
    int threads, rings;     // of vertices, around and from the waist to the hem
    int gathered;           // rings of links below the waist that may fold
    double length;          // m, from waist to hem
    double clearance;       // m, of its upper edge from her skin
    double density;         // kg/m^2
    double rigidity;        // N m, of bending
    double shearStiffness;  // N/m
    double steepness;       // rad, between its threads at the start and the spine
    Material material;
    std::array<double, 3> color;
};

// Flat: cut to lie around the seam in the plane of the waist, where it is when she whirls, and
// fuller.
Shape patternOf(const Layer& layer, const Frame& waist, const Seam& seam) {
    const std::vector<Vec<double>> sewn = seam.at(0);
    const Vec<double> forth = cross(waist.across, waist.up);
    Simplices cells;
    std::vector<Vec<double>> flat;
    for (int r = 0; r < layer.rings; ++r)
        for (int i = 0; i < layer.threads; ++i) {
            const Vec<double> x = fullness * (sewn[i] - waist.origin) +
                                  layer.length * r / (layer.rings - 1) * seam.outwards()[i];
            flat.push_back({dot(x, waist.across), 0, dot(x, forth)});
            if (r + 1 == layer.rings) continue;
            const int a = r * layer.threads + i, b = r * layer.threads + (i + 1) % layer.threads;
            const int c = a + layer.threads, d = b + layer.threads;
            // Seen from above, where angles run clockwise.
            if ((i + r) % 2) {
                cells.triangles.push_back({a, b, d});
                cells.triangles.push_back({a, d, c});
            } else {
                cells.triangles.push_back({a, b, c});
                cells.triangles.push_back({b, d, c});
            }
        }
    return {SimplicialComplex(static_cast<int>(flat.size()), cells), flat};
}

// Every thread from waist to hem straight, in directions that wave about a cone so that they are as
// far apart as on the pattern.
std::vector<Vec<double>> hung(const Layer& layer, const Frame& waist, const Seam& seam) {
    constexpr int pleats = 12;
    const double steep = sine(layer.steepness);
    const double wave = std::sqrt(2 * (1 - steep * steep)) / pleats;
    const std::vector<Vec<double>> sewn = seam.at(0);
    std::vector<Vec<double>> along;
    double angle = 0;
    for (int i = 0; i < layer.threads; ++i) {
        const Vec<double>& out = seam.outwards()[i];
        const double polar = layer.steepness + wave * cosine(pleats * angle);
        along.push_back(sine(polar) * out - cosine(polar) * waist.up);
        angle += length(seam.outwards()[(i + 1) % layer.threads] - out);
    }
    std::vector<Vec<double>> start;
    for (int r = 0; r < layer.rings; ++r)
        for (int i = 0; i < layer.threads; ++i)
            start.push_back(sewn[i] + layer.length * r / (layer.rings - 1) * along[i]);
    return start;
}

// Threads down and rings around, but for the one that is sewn on. Returns them, two vertices a
// link.
std::vector<int> weave(World& world, Range cloth, const Layer& layer, const std::string& name,
                       double mending) {
    const auto threadOf = [n = layer.threads, gathered = layer.gathered](int a, int b) {
        if (a / n != b / n) return a % n == b % n ? Thread::warp : Thread::bias;
        return a < n ? Thread::none : a / n <= gathered ? Thread::gather : Thread::weft;
    };
    world.constrain(bendRows(world.complex, cloth, world.rest, layer.rigidity),
                    {.name = name + "bend", .order = 3, .secondaryInterval = 3});
    return plait::weave(world, cloth, threadOf, layer.shearStiffness, name, mending);
}

// Of these links those that do not gather.
std::vector<int> taut(const std::vector<int>& links, Range cloth, const Layer& layer) {
    std::vector<int> list;
    for (std::size_t i = 0; i < links.size(); i += 2) {
        const int ring = (links[i] - cloth.first) / layer.threads;
        if (ring <= layer.gathered && (links[i + 1] - cloth.first) / layer.threads == ring)
            continue;
        list.insert(list.end(), {links[i], links[i + 1]});
    }
    return list;
}

// Adds a layer, sewn on. Returns its vertices.
Range addLayer(World& world, const Wearer& wearer, const Layer& layer) {
    const Seam seam(wearer.surface, wearer.waist, layer.clearance, layer.length / 3, layer.threads);
    const Range cloth =
        world.add(patternOf(layer, wearer.waist, seam),
                  {.density = layer.density, .start = hung(layer, wearer.waist, seam)});
    world.pin(pointStencils({cloth.first, cloth.first + layer.threads}),
              [seam](double t, std::span<Vec<double>> positions) {
                  std::ranges::copy(seam.at(t - lead), positions.begin());
              });
    return cloth;
}

// Skin is pinned matter that moves as its wearer does.
Range addBody(World& world, const Wearer& wearer) {
    const Range body = world.add(wearer.shape);
    world.pin(pointStencils(body),
              [at = wearer.surface.positions](double t, std::span<Vec<double>> positions) {
                  std::ranges::copy(at(t - lead), positions.begin());
              });
    return body;
}

// The skirt when it stands out level.
double reachOf(const Layer& layer, std::span<const Vec<double>> sewn, const Vec<double>& middle) {
    double widest = 0;
    for (const Vec<double>& x : sewn)
        widest = std::max(widest, std::hypot(x.x - middle.x, x.z - middle.z));
    return widest + layer.length;
}

View viewOf(const Wearer& wearer, double skirt, const std::array<Range, 3>& objects,
            const std::array<Layer, 2>& layers) {
    Staging staging = wearer.staging;
    staging.reach = std::max(staging.reach, skirt);
    View view = plait::viewOf({objects[0], objects[1], objects[2]}, staging, wearer.followed);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        view.looks[i].material = layers[i].material;
        view.looks[i].color = layers[i].color;
    }
    view.looks[2] = wearer.look;
    view.looks[2].object = objects[2];
    return view;
}

}  // namespace

Scene dress(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const Wearer wearer = knobs.text("body").empty() ? ballerina() : wearerOf(knobs);
    world.warnings = wearer.warnings;
    const int threads = knobs.byQuality(90, 180, 360), rings = knobs.byQuality(15, 29, 57),
              gathered = (rings - 1) / 5;
    const Layer silk{threads, rings, gathered, 0.42,           0.012,    0.09,
                     2e-6,    10,    0.75,     Material::silk, vermilion};
    const Layer tulle{threads, rings, gathered,        0.40, 0.006, 0.04, 4e-6,
                      10,      0.70,  Material::tulle, rose};
    const Range outside = addLayer(world, wearer, silk), inside = addLayer(world, wearer, tulle);
    const Range body = addBody(world, wearer), skirt{outside.first, inside.last};
    world.act<Gravity>(GravityOptions{});
    actAir(world, {.density = 1.2, .drag = 1.2, .tangentialDrag = 0.1, .interval = 2});
    std::vector<int> links, tautLinks;
    for (const auto& [cloth, layer, name] :
         {std::tuple{outside, silk, "silk "}, {inside, tulle, "tulle "}}) {
        const std::vector<int> woven =
            weave(world, cloth, layer, name, knobs.number("mending") / 100);
        const std::vector<int> straight = taut(woven, cloth, layer);
        links.insert(links.end(), woven.begin(), woven.end());
        tautLinks.insert(tautLinks.end(), straight.begin(), straight.end());
    }
    // Less than what is between vertices at the waist: threads that gather would push each other
    // away.
    const double thickness = knobs.byQuality(0.0015, 0.00075, 0.0004);  // m
    const auto surface = [thickness](Range vertices, Self self) {
        return Surface{.vertices = vertices,
                       .thickness = thickness,
                       .staticFriction = 0.2,
                       .dynamicFriction = 0.2,
                       .self = self};
    };
    meet(world,
         {surface(outside, Self::full), surface(inside, Self::full), surface(body, Self::none)},
         {.detection = knobs.text("detection") == "path" ? Detection::path : Detection::end,
          .order = 4});
    scene.options.schedule = {
        .substeps = knobs.byQuality(24, 24, 48), .iterations = 24, .collisionPasses = 24};
    scene.options.damping = 0.02;
    scene.lead = lead;
    scene.seconds = wearer.seconds;
    scene.metrics = {greatestStrain(world, links, {0, 2}),
                     commonStrain(world, tautLinks, {0, 1}),
                     selfIntersections(world, skirt, {0, 0}),
                     contactFailures(),
                     folds(world, skirt, {}),
                     insideOf(world, skirt, body, {0, 0})};
    if (scene.metrics.back().measure({world.start, world.velocity, 0, 0}) > 0)
        throw std::invalid_argument("body: it must stand in its first mesh, clear of the skirt");
    const auto sewn = std::span(world.start).subspan(outside.first, threads);
    scene.view = viewOf(wearer, reachOf(silk, sewn, wearer.waist.origin), {outside, inside, body},
                        {silk, tulle});
    return scene;
}

}  // namespace plait
