// Heaps and folds of what meets as balls.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/contacts/solids/collider.h>

#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double bead = 0.01;  // m, radius

// Beads of one friction let fall in a column on a rough floor: tangent of the heap's slope, by the
// height of its middle and its mean width as of a cone: 4 z / (3/2 r).
double slopeOf(double friction) {
    constexpr int across = 6, high = 14;
    World world;
    Random random(3);
    Points at;
    for (int k = 0; k < high; ++k)
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
                at.push_back(Vec<double>{2.1 * bead * (i - 2.5), bead + 2.1 * bead * k,
                                         2.1 * bead * (j - 2.5)} +
                             random.point(0.05 * bead));
    const int count = static_cast<int>(at.size());
    const Range beads = world.add({SimplicialComplex(count), at}, {.density = 0.01});
    world.act<Gravity>(GravityOptions{});
    Surface surface{.vertices = beads, .staticFriction = friction, .dynamicFriction = friction};
    surface.radii.assign(static_cast<std::size_t>(count), bead);
    meet(world, {surface});
    Collider floor{.solid = Solid::plane(), .staticFriction = 2, .dynamicFriction = 2};
    Surface rough = surface;
    rough.staticFriction = rough.dynamicFriction = 2;  // of the pair at most 1
    collide(world, {floor}, {rough}, {.name = "floor", .order = 1});
    Solver<float> solver(world, meeting(20, 4));
    advance(solver, 60);
    const Points x = solver.positions();
    const Vec<double> middle = meanOf(x, beads);
    double wide = 0;
    for (const Vec<double>& p : x) wide += std::hypot(p.x - middle.x, p.z - middle.z) / count;
    return 4 * (middle.y - bead) / (1.5 * wide);
}

}  // namespace

TEST_CASE("heaps: rougher beads lie steeper", "[contacts][figures][friction][FR8]") {
    double last = 0;
    for (const double friction : {0.0, 0.2, 0.6}) {
        const double slope = slopeOf(friction);
        note("friction " + std::to_string(friction) + ", tangent of the heap's slope", slope);
        CHECK(slope > last + 0.05);
        last = slope;
    }
}

// A thread without bending, hung by both ends side by side: it turns at its lowest in a hairpin as
// narrow as its links let it, unless its points meet as balls. Then no two of them but neighbours
// are nearer than two radii r, and three in a row lie on a circle of l^2 / 2 sqrt(l^2 - r^2).
TEST_CASE("folds: what meets as balls is stiff to fold, the more the wider they are",
          "[contacts][self][SF6]") {
    constexpr int links = 40;
    constexpr double l = 0.01;
    const auto radiusOf = [](double width) {
        World world;
        Points at;
        for (int i = 0; i <= links; ++i) {  // wide apart at first
            const double turn = std::numbers::pi * i / links;
            at.push_back({links * l / std::numbers::pi * -std::cos(turn),
                          links * l / std::numbers::pi * -std::sin(turn), 0});
        }
        const Range thread = world.add({chain({.links = links}).complex, at}, {.density = 0.01});
        // In the end as far apart as their balls let them be.
        const double apart = std::max(0.02, 0.42 * width) * l, wide = at.back().x - at.front().x;
        world.pin({0, links}, [part = apart / wide](const Vec<double>& x, double t) {
            return Vec<double>{(1 - (1 - part) * std::min(t, 1.0)) * x.x, x.y, x.z};
        });
        world.act<Gravity>(GravityOptions{});
        world.constrain(linksOf(world), {.name = "links"});
        if (width > 0)
            meet(world,
                 {{.vertices = thread,
                   .thickness = 0.2 * l,
                   .self = Self::vertex,
                   .selfWidth = width}},
                 {.order = 1});
        SolverOptions options = meeting(20, 10);
        options.damping = 0.2;
        Solver<double> solver(world, options);
        advance(solver, 72);
        const Points x = solver.positions();
        double least = infinity;
        for (int i = 1; i < links; ++i) {
            const auto v = static_cast<std::size_t>(i);
            const double a = length(x[v] - x[v - 1]), b = length(x[v + 1] - x[v]),
                         c = length(x[v + 1] - x[v - 1]),
                         area = length(cross(x[v] - x[v - 1], x[v + 1] - x[v - 1])) / 2;
            least = std::min(least, a * b * c / (4 * area));
        }
        return least / l;
    };
    const double free = radiusOf(0);
    note("least radius of a fold without contact, links", free);
    double last = free;
    for (const double width : {1.5, 3.0, 4.5}) {
        const double r = 0.2 * width, rule = 1 / (2 * std::sqrt(1 - r * r));
        const double found = radiusOf(width);
        note("balls of " + std::to_string(r) + " links: least radius, links", found);
        CHECK(found > 0.97 * rule);
        CHECK(found > last);
        last = found;
    }
}
