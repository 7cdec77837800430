// A sleeve is pinched in the crook of an elbow, and comes free again (M 4.5.3).
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "../parts/woven.h"
#include "basics.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/search/nearest.h>
#include <plait/forces/gravity.h>
#include <plait/measure/surfaces/box_tree.h>
#include <plait/numbers/elementary.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plait {
namespace {

constexpr double thickness = 0.001;  // m, of cloth and skin, to either side
// m, from a vertex to what touches it: their thicknesses and a quarter.
constexpr double touching = 2.5 * thickness;
constexpr double upper = 0.23, fore = 0.25;  // m, from the elbow to the ends of the arm
// m, along the arm, that bends. Its inside is then an arc of radius reach / angle less that of the
// arm: three thicknesses at 148 degrees, where skin, cloth, cloth and skin just have room in it,
// and nothing at 159, beyond which the arm goes through itself and takes the cloth along.
constexpr double reach = 0.115;
constexpr double sewn = -0.185, cuff = 0.185;  // m, along the arm: the ends of the sleeve
constexpr double lead = 0.25;                  // s, in which the sleeve falls before the film
constexpr double start = 0.2, rise = 0.9, held = 0.3, opened = start + rise + held + rise;  // s

// m, of the arm, so far behind the elbow.
double radiusAt(double s) { return 0.040 - 0.025 * s; }

// Where what belongs to the arm is when it is bent by an angle (rad). What bends lies on an arc.
class Bones {
public:
    explicit Bones(double angle) : angle_(angle) {}

    // So far (m) behind the elbow, and off the arm's middle towards the crook and to its side.
    Vec<double> place(double s, double inward, double aside) const {
        const double u = std::clamp(s + reach / 2, 0.0, reach), turned = angle_ * u / reach;
        const Vec<double> along{cosine(turned), sine(turned), 0};
        const Vec<double> in{-along.y, along.x, 0};
        Vec<double> middle{u - reach / 2, 0, 0};
        if (angle_ > 0)
            middle = {(reach / angle_) * along.y - reach / 2, (reach / angle_) * (1 - along.x), 0};
        middle += (s - (u - reach / 2)) * along + inward * in;
        const Vec<double> x = middle + Vec<double>{0, 0, aside};
        return {cosine(lean) * x.x - sine(lean) * x.y, sine(lean) * x.x + cosine(lean) * x.y, x.z};
    }

private:
    static constexpr double lean = -0.65;  // rad, of the upper arm

    double angle_;
};

// A section of something round: how far behind the elbow, and how wide.
struct Section {
    double s, radius;
};

std::vector<Vec<double>> around(const std::vector<Section>& sections, int sides, double angle) {
    const Bones bones(angle);
    std::vector<Vec<double>> x;
    for (const auto& [s, radius] : sections)
        for (int k = 0; k < sides; ++k) {
            const double a = 2 * pi * k / sides;
            x.push_back(bones.place(s, radius * cosine(a), radius * sine(a)));
        }
    return x;
}

// The triangles of sections joined, seen from outside.
Simplices joined(int sections, int sides) {
    Simplices cells;
    for (int i = 0; i + 1 < sections; ++i)
        for (int k = 0; k < sides; ++k) {
            const int a = i * sides + k, b = i * sides + (k + 1) % sides;
            if ((i + k) % 2) {
                cells.triangles.push_back({a, b, b + sides});
                cells.triangles.push_back({a, b + sides, a + sides});
            } else {
                cells.triangles.push_back({a, b, a + sides});
                cells.triangles.push_back({b, b + sides, a + sides});
            }
        }
    return cells;
}

// Round ends and all, but for their poles.
std::vector<Section> armSections(double cell) {
    constexpr int capRings = 6;
    const int cells = static_cast<int>(std::lround((upper + fore) / cell));
    std::vector<Section> sections;
    const auto addCap = [&](double end, int ring) {
        const double a = 0.5 * pi * ring / capRings, r = radiusAt(end);
        sections.push_back({end + r * sine(a), r * cosine(a)});
    };
    for (int ring = 1 - capRings; ring <= 0; ++ring) addCap(-upper, ring);
    for (int i = 1; i < cells; ++i) {
        const double s = -upper + (upper + fore) * i / cells;
        sections.push_back({s, radiusAt(s)});
    }
    for (int ring = 0; ring < capRings; ++ring) addCap(fore, ring);
    return sections;
}

// Closed, with a pole at either end.
std::vector<Vec<double>> armAt(const std::vector<Section>& sections, int sides, double angle) {
    std::vector<Vec<double>> x = around(sections, sides, angle);
    const Bones bones(angle);
    x.push_back(bones.place(-upper - radiusAt(-upper), 0, 0));
    x.push_back(bones.place(fore + radiusAt(fore), 0, 0));
    return x;
}

Shape arm(const std::vector<Section>& sections, int sides) {
    const int rings = static_cast<int>(sections.size()), pole = rings * sides;
    Simplices cells = joined(rings, sides);
    for (int k = 0; k < sides; ++k) {
        const int next = (k + 1) % sides, last = (rings - 1) * sides;
        cells.triangles.push_back({pole, next, k});
        cells.triangles.push_back({pole + 1, last + k, last + next});
    }
    return {SimplicialComplex(pole + 2, cells), armAt(sections, sides, 0)};
}

// rad, of the elbow at a time (s): bent, held and opened.
double angleAt(double t, double bend) {
    const auto eased = [](double u) {
        u = std::clamp(u, 0.0, 1.0);
        return u * u * u * (10 - 15 * u + 6 * u * u);
    };
    const double since = t - start;
    return bend *
           (since < rise + held ? eased(since / rise) : 1 - eased((since - rise - held) / rise));
}

// Of the sleeve: how far behind the elbow its rings are, and how wide.
std::vector<Section> sleeveSections(int rings) {
    std::vector<Section> sections;
    const double narrow = radiusAt(sewn) + 0.004, wide = 0.060;
    for (int i = 0; i < rings; ++i) {
        const double part = static_cast<double>(i) / (rings - 1);
        sections.push_back({sewn + part * (cuff - sewn), narrow + part * (wide - narrow)});
    }
    return sections;
}

// Its upper end is sewn to the arm, where it does not move.
Range addSleeve(World& world, int rings, int threads) {
    const Range cloth = world.add({SimplicialComplex(rings * threads, joined(rings, threads)),
                                   around(sleeveSections(rings), threads, 0)},
                                  {.density = 0.12});
    world.pin(pointStencils({cloth.first, cloth.first + threads}));
    return cloth;
}

// Skin is pinned matter that moves as it is told.
Range addArm(World& world, double cell, int sides, double bend) {
    const std::vector<Section> sections = armSections(cell);
    const Range range = world.add(arm(sections, sides));
    world.pin(pointStencils(range), [=](double t, std::span<Vec<double>> positions) {
        std::ranges::copy(armAt(sections, sides, angleAt(t - lead, bend)), positions.begin());
    });
    return range;
}

// Vertices of the sleeve that skin, or cloth from elsewhere, touches on both sides.
Metric pinched(const World& world, Range sleeve, double cell, Band band) {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < world.complex.count(2); ++i) triangles.push_back(world.complex.triangle(i));
    const auto measure = [=, rest = world.rest](const Snapshot& at) {
        const std::vector<Vec<double>>& x = at.positions;
        std::vector<Box> boxes;
        std::vector<Vec<double>> normals(x.size(), {0, 0, 0});
        for (const auto& [a, b, c] : triangles) {
            boxes.push_back(boxOf(std::array{x[a], x[b], x[c]}));
            for (const int v : {a, b, c}) normals[v] += cross(x[b] - x[a], x[c] - x[a]);
        }
        const BoxTree tree(boxes);
        const Vec<double> reached{touching, touching, touching};
        int count = 0;
        for (int v = sleeve.first; v < sleeve.last; ++v) {
            bool outside = false, within = false;
            tree.overlaps({x[v] - reached, x[v] + reached}, [&](int t) {
                const auto [a, b, c] = triangles[t];
                for (const int corner : {a, b, c})
                    if (a < sleeve.last && length(rest[corner] - rest[v]) < 1.5 * cell) return;
                const auto [weight, apart] =
                    nearest({{v, a, b, c}, 1, 3}, {x[v], x[a], x[b], x[c]});
                if (length(apart) <= touching)
                    (dot(apart, normals[v]) < 0 ? outside : within) = true;
            });
            count += outside && within;
        }
        return static_cast<double>(count);
    };
    return {.name = "pinched",
            .unit = "",
            .measure = measure,
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

}  // namespace

Scene elbow(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const int threads = knobs.byQuality(36, 72, 144), rings = knobs.byQuality(36, 72, 144),
              sides = knobs.byQuality(24, 36, 48);
    const double bend = knobs.number("bend") * pi / 180, friction = knobs.number("friction");
    const Range sleeve = addSleeve(world, rings, threads);
    const Range arm = addArm(world, knobs.byQuality(0.0075, 0.005, 0.005), sides, bend);
    world.act<Gravity>(GravityOptions{});
    const auto threadOf = [threads](int a, int b) {
        if (a / threads != b / threads)
            return a % threads == b % threads ? Thread::warp : Thread::bias;
        return a < threads ? Thread::none : Thread::weft;
    };
    const std::vector<int> links = weave(world, sleeve, threadOf, 15, "", 0.01);
    world.constrain(bendRows(world.complex, sleeve, world.rest, 1e-5),
                    {.name = "bend", .order = 3});
    Surface skin = roughSurface(arm, thickness, friction);
    skin.self = Self::none;
    meet(world, {roughSurface(sleeve, thickness, friction), skin}, {.order = 4});
    const int substeps = knobs.byQuality(24, 32, 48);
    scene.options.schedule = {.substeps = substeps, .iterations = 4, .collisionPasses = 8};
    scene.options.baseSteps = substeps;
    scene.options.damping = 0.05;
    scene.lead = lead;
    scene.seconds = 3;
    scene.metrics = {greatestStrain(world, links, {0, 2}),
                     selfIntersections(world, {sleeve.first, arm.last}, {0, 0}),
                     insideOf(world, sleeve, arm, {0, 0}),
                     pinched(world, sleeve, (cuff - sewn) / (rings - 1), {0, 0, opened}),
                     contactFailures()};
    View& view = scene.view;
    view = viewOf({sleeve, arm}, {-0.01, 0.07, 0}, 0.5, Material::cotton, {-0.75, 0.7, 2.0});
    view.cameras[0].across = 0.65;
    view.looks[1].material = Material::matte;
    view.looks[1].color = {0.55, 0.42, 0.33};
    const Vec<double> shoulder = Bones(0).place(-upper - 0.02, 0, 0);
    addBar(view, {shoulder.x, view.groundHeight, shoulder.z}, shoulder, 0.012, Material::steel);
    return scene;
}

}  // namespace plait
