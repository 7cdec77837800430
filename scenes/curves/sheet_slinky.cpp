// A sheet rolled to a tube of three sides and wound to a coil (S 5, figure 24).
#include "../parts/bodies.h"
#include "../parts/hung_helix.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "curves.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/arctangent.h>
#include <plait/numbers/elementary.h>
#include <plait/rods/chain_set.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace plait {
namespace {

constexpr double g = 9.81;                        // m/s^2
constexpr int turns = 12, links = 24, sides = 3;  // of a turn; of the tube
constexpr int sections = turns * links + 1;
constexpr double coil = 0.06, pitch = 0.011;  // m
constexpr double side = 0.009;                // m, of the tube
constexpr double density = 0.35;              // kg/m^2
constexpr double thickness = 0.0003;          // m, to either side
constexpr double bar = 0.64;                  // m, above the floor

double around() { return std::sqrt(4 * pi * pi * coil * coil + pitch * pitch); }

// From the lower end up, section by section; corner 0 of each outside.
Shape tubeAlong(const Vec<double>& top) {
    Shape shape;
    Simplices cells;
    const double out = side / std::sqrt(3.0);
    for (int i = 0; i < sections; ++i) {
        const double a = 2 * pi * i / links;
        const Vec<double> radial{cosine(a), 0, -sine(a)}, up{0, 1, 0};
        const Vec<double> middle = top + coil * radial + (pitch * (double(i) / links - turns)) * up;
        for (int k = 0; k < sides; ++k) {
            const double b = 2 * pi * k / sides;
            shape.positions.push_back(middle + out * (cosine(b) * radial + sine(b) * up));
        }
        if (i == 0) continue;
        for (int k = 0; k < sides; ++k) {
            const int next = (k + 1) % sides, low = sides * (i - 1), high = sides * i;
            cells.triangles.push_back({low + k, low + next, high + k});
            cells.triangles.push_back({low + next, high + next, high + k});
        }
    }
    shape.complex = SimplicialComplex(sides * sections, cells);
    return shape;
}

// Of both triangles of each wall, from an edge around or along the tube on: measured from a
// diagonal the same shear would count less. `wall` in N/m: the modulus of shear times the
// thickness.
Rows<Shear> shearOf(const World& world, Range tube, double wall) {
    std::vector<int> stencils;
    for (int low = tube.first; low + sides < tube.last; low += sides)
        for (int k = 0; k < sides; ++k) {
            const int a = low + k, b = low + (k + 1) % sides;
            stencils.insert(stencils.end(), {a, b, a + sides, b + sides, a + sides, b});
        }
    auto shear = restRows<Shear>(stencils, world.rest);
    for (std::size_t i = 0; i < shear.rows.size(); ++i) {
        std::array<Vec<double>, 3> x;
        for (std::size_t a = 0; a < 3; ++a)
            x[a] = world.rest[static_cast<std::size_t>(stencils[3 * i + a])];
        const double area = 0.5 * length(cross(x[1] - x[0], x[2] - x[0]));
        shear.rows[i].compliance = 1 / (wall * area);
    }
    return shear;
}

// Around the tube and along it lengths are kept; across its walls nothing but shear resists, and
// nothing if `wall` is 0.
// Returns the links that keep their lengths.
std::vector<int> holdTube(World& world, Range tube, double wall, const char* name) {
    Chains chains;
    Rows<Stretch> stretch;
    std::vector<int> order;
    const auto link = [&](int a, int b) {
        stretch.ids.insert(stretch.ids.end(), {a, b});
        stretch.rows.push_back({length(world.rest[static_cast<std::size_t>(b)] -
                                       world.rest[static_cast<std::size_t>(a)]),
                                0, 0});
    };
    for (int v = tube.first; v < tube.last; ++v) {
        order.push_back(v);
        if (v - sides >= tube.first) link(v - sides, v);
        const int first = v - (v - tube.first) % sides;
        link(std::min(v, first + (v - first + 1) % sides),
             std::max(v, first + (v - first + 1) % sides));
    }
    chains.addCurve(order);
    chains.add(stretch);
    if (wall > 0) chains.add(shearOf(world, tube, wall));
    chains.constrain(world, {.name = name});
    return stretch.ids;
}

// Its uppermost turn is held.
Range addTube(World& world, double x) {
    const Range tube = world.add(tubeAlong({x, bar, 0}), {.density = density});
    world.pin(pointStencils({tube.last - sides * (links + 1), tube.last}));
    return tube;
}

// m: how far a coil hangs out whose wire is a tube of thin walls, C = 4 A^2 G t / perimeter
// (Bredt), that twists and never bends.
double expectedSag(double wall) {
    const double twisting = wall * side * side * side / 4,
                 weight = density * sides * side * g;  // N/m
    return sagOf({arctangent2(pitch, 2 * pi * coil), coil}, {1e4 * twisting, twisting},
                 (turns - 1) * around(), weight);
}

Metric sag(const std::string& name, Range tube, Band band) {
    return {.name = name,
            .unit = "mm",
            .measure =
                [=](const Snapshot& at) {
                    double sum = 0;
                    for (int i = 0; i < sides * links; ++i) sum += at.positions[tube.first + i].y;
                    return 1000 * (bar - (turns - 0.5) * pitch - sum / (sides * links));
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

}  // namespace

Scene sheetSlinky(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double wall = 1000 * knobs.number("shear");
    const Range left = addTube(world, -0.2), right = addTube(world, 0.2);
    const std::vector<int> kept = holdTube(world, left, wall, "with shear"),
                           others = holdTube(world, right, 0, "without");
    world.act<Gravity>(GravityOptions{});
    const auto surface = [](Range tube) { return roughSurface(tube, thickness, 0.3); };
    meet(world, {surface(left), surface(right)}, {.order = 1});
    collide(world, {{.solid = Solid::plane(), .staticFriction = 0.5, .dynamicFriction = 0.5}},
            {surface(left), surface(right)}, {.order = 2});
    scene.options.schedule = {.substeps = knobs.byQuality(24, 32, 48), .iterations = 2};
    scene.options.sweeps = Sweeps::oneWay;
    scene.options.damping = 1 - exponential(-2.0 / 24);
    scene.seconds = 6;
    // All but the held turn, onto the floor.
    const Band fallen{900 * (bar - (turns - 0.5) * pitch), infinity, 1};
    const double expected = wall > 0 ? 1000 * expectedSag(wall) : 0;
    const Band hung = wall > 0 ? Band{0.96 * expected, 1.04 * expected, 3.6} : fallen;
    scene.metrics = {sag("with shear", left, hung), sag("without", right, fallen),
                     greatestStrain(world, kept, {0, wall > 0 ? 1 : infinity}),
                     commonStrain(world, others, {0, 5, 1}), contactFailures()};

    View& view = scene.view;
    view = viewOf({left, right}, {0, 0.35, 0}, 0.75, Material::satin, {0.3, 0.2, 2.15});
    view.looks[1].color = {0.880, 0.791, 0.658};
    view.groundHeight = 0;
    addBar(view, {-0.4, bar + 0.012, 0}, {0.4, bar + 0.012, 0}, 0.009, Material::brass);
    for (const double x : {-0.4, 0.4})
        addBar(view, {x, 0, 0}, {x, bar + 0.03, 0}, 0.011, Material::brass);
    return scene;
}

}  // namespace plait
