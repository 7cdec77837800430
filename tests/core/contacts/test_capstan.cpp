// A rope that slips on a cylinder pulls e^(mu theta) times what it carries (Euler, Eytelwein).
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/field.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

struct Capstan {
    double angle, friction;
    int substeps;        // in 1/24 s
    bool mesh = false;   // the cylinder is triangles that are pinned
    bool tight = false;  // its links begin too near the mesh, by up to 0.12 mm
};

// The gauge of the rope and, on a mesh, of the cylinder; how wide that is, and what a link of the
// rope is long (m).
constexpr double thickness = 1e-3, radius = 0.1, link = 0.01;

Surface rough(Range vertices, double friction) {
    return {.vertices = vertices,
            .thickness = thickness,
            .staticFriction = friction,
            .dynamicFriction = friction,
            .self = Self::none};
}

// Adds the cylinder around z that the rope lies on.
void addCylinder(World& world, Range rope, const Capstan& capstan) {
    const Frame frame{.across = {1, 0, 0}, .up = {0, 0, 1}};
    if (!capstan.mesh) {
        collide(world,
                {{.solid = Solid::capsule(2, radius),
                  .frame = frame,
                  .staticFriction = capstan.friction,
                  .dynamicFriction = capstan.friction}},
                {rough(rope, capstan.friction)});
        return;
    }
    // No multiple of the rope's links: their corners would catch in its corners like teeth.
    constexpr int sides = 90;
    constexpr double width = 0.1;
    const Range mesh =
        world.add(tube({.segments = sides, .radius = radius, .height = width},
                       {.origin = {0, 0, -width / 2}, .across = frame.across, .up = frame.up}));
    std::vector<int> all;
    for (int v = mesh.first; v < mesh.last; ++v) all.push_back(v);
    world.pin(all);
    meet(world, {rough(rope, capstan.friction), rough(mesh, capstan.friction)});
}

// The mean tension of the pulled end over that of the other while it slips, which carries 1 N: of a
// rope of rigid links around a cylinder, pulled by a spring at 1 cm/s.
double pullOf(const Capstan& capstan) {
    constexpr double weight = 1, speed = 0.01;
    constexpr int hanging = 4;
    const double grip = std::exp(capstan.friction * capstan.angle);
    const double spring = weight * grip / 0.02;  // N/m
    // Links are clear of a mesh as well, not their ends alone.
    const double beside = radius + (capstan.mesh ? 2 : 1) * thickness;
    const double way =
        capstan.mesh && !capstan.tight ? beside / std::cos(0.5 * link / beside) + 1e-7 : beside;
    const int arc = static_cast<int>(std::lround(capstan.angle * way / link));
    const auto around = [&](double at) {
        return Vec<double>{-way * std::cos(at), way * std::sin(at), 0};
    };
    const Vec<double> end = around(capstan.angle),
                      away{std::sin(capstan.angle), std::cos(capstan.angle), 0};
    std::vector<Vec<double>> rope;
    for (int i = hanging; i > 0; --i) rope.push_back(around(0) - Vec<double>{0, i * link, 0});
    for (int i = 0; i <= arc; ++i) rope.push_back(around(capstan.angle * i / arc));
    for (int i = 1; i <= hanging; ++i) rope.push_back(end + i * link * away);
    rope.push_back(end + ((hanging + 1) * link + weight / spring) * away);

    World world;
    const int links = static_cast<int>(rope.size()) - 1, last = links;
    const Range all = world.add({chain({.links = links}).complex, rope});
    for (int v = 0; v <= last; ++v) world.mass[v] = 1e-3;
    world.mass[0] = 0.01;
    world.mass[last - 1] = 0.1;
    // At first nearly as far as it takes until all slips.
    const double ahead = 0.9 * weight * (grip - 1) / spring;
    world.pin({last}, [=](const Vec<double>& start, double t) {
        const double s = std::min(1.0, t / 0.25);
        return start + (ahead * s * s * (3 - 2 * s) + speed * std::max(0.0, t - 0.25)) * away;
    });
    std::vector<int> pairs;
    for (int v = 0; v < last - 1; ++v) pairs.insert(pairs.end(), {v, v + 1});
    world.constrain(restRows<Stretch>(pairs, world.rest), {.name = "rope", .direct = true});
    auto pulling = restRows<Stretch>({last - 1, last}, world.rest, 1 / spring);
    pulling.rows[0].rest = link;
    world.constrain(pulling, {.name = "spring", .damping = 0.9});
    const double g = weight / world.mass[0];
    world.act<Field>(FieldOptions{
        .acceleration = [g](const Vec<double>&, double) { return Vec<double>{0, -g, 0}; },
        .objects = {{0, 1}}});
    addCylinder(world, all, capstan);

    Solver<float> solver(
        world, {.schedule = {.substeps = capstan.substeps, .iterations = 1, .collisionPasses = 2}});
    double sum = 0;
    for (int frame = 1; frame <= 20; ++frame) {
        solver.frame();
        const auto x = solver.positions();
        if (frame > 14) sum += spring * (length(x[last] - x[last - 1]) - link) / weight;
    }
    return sum / 6;
}

double errorOf(const Capstan& capstan) {
    return std::fabs(pullOf(capstan) / std::exp(capstan.friction * capstan.angle) - 1);
}

std::string nameOf(const Capstan& capstan) {
    return "mu " + std::to_string(capstan.friction) + ", " + std::to_string(capstan.angle) +
           " rad, " + std::to_string(capstan.substeps) +
           (capstan.tight ? " substeps, tight, off" : " substeps, off");
}

}  // namespace

TEST_CASE("capstan: a rope that slips on a solid pulls e^(mu theta)", "[rods][figures]") {
    for (const double angle : {pi / 2, pi, 2 * pi})
        for (const double friction : {0.1, 0.3, 0.5})
            for (const int substeps : {100, 400}) {
                const Capstan capstan{angle, friction, substeps};
                CHECK(report(nameOf(capstan), errorOf(capstan), 0.03));
            }
}

TEST_CASE("capstan: a rope that slips on a mesh pulls e^(mu theta)", "[rods][contacts][figures]") {
    for (const double angle : {pi / 2, pi, 2 * pi}) {
        const Capstan capstan{angle, 0.1, 200, true};
        CHECK(report(nameOf(capstan), errorOf(capstan), 0.03));
    }
}

// Contacts of edges and triangles share vertices of the rope, so that sweeps leave what is pressed
// hard pressed too little: less so with substeps.
TEST_CASE("capstan: on a mesh it is nearer with more substeps", "[rods][contacts][figures][long]") {
    for (const double angle : {pi / 2, pi, 2 * pi})
        for (const double friction : {0.1, 0.3, 0.5}) {
            const Capstan coarse{angle, friction, 200, true}, fine{angle, friction, 1600, true};
            const double before = errorOf(coarse), after = errorOf(fine);
            note(nameOf(coarse), before);
            CHECK(report(nameOf(fine), after, 0.03));
            CHECK(after < before);
        }
}

// What begins too near is parted without being thrown off: that would be further with more
// substeps, and the rope would not grip for as long as it flies.
TEST_CASE("capstan: a rope that begins too near a mesh grips it",
          "[rods][contacts][overlap][figures]") {
    double coarse = 1;
    for (const int substeps : {400, 800, 1600}) {
        const Capstan capstan{pi, 0.5, substeps, true, true};
        const double error = errorOf(capstan);
        CHECK(report(nameOf(capstan), error, 0.03));
        CHECK(error <= coarse);
        if (substeps == 400) coarse = error;
    }
}

TEST_CASE("capstan: begun too near it is nearer with more substeps",
          "[rods][contacts][overlap][figures][long]") {
    for (const double angle : {pi / 2, pi, 2 * pi})
        for (const double friction : {0.1, 0.3, 0.5}) {
            const Capstan coarse{angle, friction, 400, true, true},
                fine{angle, friction, 1600, true, true};
            const double before = errorOf(coarse), after = errorOf(fine);
            note(nameOf(coarse), before);
            CHECK(report(nameOf(fine), after, 0.03));
            CHECK(after < before);
        }
}
