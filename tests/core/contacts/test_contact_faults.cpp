// Closed forms that contacts meet to the last digit: what is foreseen, the planes between two, and
// edges on edges that stay.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

using namespace plait;
using namespace plait::test;

namespace {

Surface smooth(Range vertices, double thickness = 0.001) {
    Surface surface;
    surface.vertices = vertices;
    surface.thickness = thickness;
    surface.staticFriction = surface.dynamicFriction = 0;
    return surface;
}

}  // namespace

// A point and a triangle that rest 0.0210 m apart, while contacts reach 0.0202 m, and that links
// draw through each other: each 0.012 m, more than half of the slack and less than all of it.
TEST_CASE("contacts: what links draw further than was foreseen is looked for again",
          "[contacts][strangers]") {
    constexpr double spare = 0.02, thin = 1e-4, reach = spare + 2 * thin, apart = 0.021,
                     drawn = 0.6 * spare;
    static_assert(apart > reach && 2 * drawn > apart);
    World world;
    Simplices cells;
    cells.triangles = {{0, 1, 2}};
    for (int v = 0; v < 4; ++v) cells.edges.push_back({v, v + 4});
    Points at{{-0.1, 0, -0.1}, {0.1, 0, -0.1}, {0, 0, 0.1}, {0, apart, 0}};
    for (int v = 0; v < 4; ++v) at.push_back(at[v] + Vec<double>{0, v < 3 ? 1.0 : -1.0, 0});
    const Range all = world.add({SimplicialComplex(8, cells), at});
    for (int v = 4; v < 8; ++v) world.rest[v].y += v < 7 ? -drawn : drawn;
    world.pin({4, 5, 6, 7});
    world.constrain(restRows<Stretch>({0, 4, 1, 5, 2, 6, 3, 7}, world.rest), {.name = "links"});
    const Range far = addPoint(world, {9, 0, 0});  // its thickness is the slack of all
    std::vector<Surface> surfaces{smooth({all.first, 3}, thin), smooth({3, 4}, thin),
                                  smooth(far, spare)};
    for (Surface& s : surfaces)
        s.restitution = 0.5;  // so that pairs are looked for before links act
    meet(world, surfaces, {.order = 1});
    Solver<double> solver(world, meeting(1));
    solver.frame();
    CHECK(countsOf(solver, world).contacts == 0);
    CHECK(countsOf(solver, world).impacts > 0);
    const Points x = solver.positions();
    CHECK(x[3].y > 0.25 * (x[0].y + x[1].y) + 0.5 * x[2].y);
}

// On its way one comes nearer than the gap by a hundredth of the way: it ends a gap away.
TEST_CASE("contacts: the plane between two goes all of their way with them",
          "[contacts][strangers]") {
    constexpr double gap = 0.002, apart = 0.05, way = 1.01 * (apart - gap);
    for (const bool edges : {false, true})
        for (const double share : {0.0, 0.3, 1.0}) {  // of the way that is the upper one's
            World world;
            Simplices edge, triangle;
            edge.edges = {{0, 1}};
            triangle.triangles = {{0, 1, 2}};
            const auto add = [&](const Simplices& cells, const Points& at, double speed) {
                const int count = static_cast<int>(at.size());
                const Points velocity(at.size(), Vec<double>{0, speed, 0});
                return world.add({SimplicialComplex(count, cells), at}, {.velocity = velocity});
            };
            const double up = 24 * (1 - share) * way, down = -24 * share * way;
            const Range lower = edges ? add(edge, {{-1, 0, 0}, {1, 0, 0}}, up)
                                      : add(triangle, {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, up);
            const Range upper = edges ? add(edge, {{0, apart, -1}, {0, apart, 1}}, down)
                                      : add({}, {{0, apart, -1.0 / 3}}, down);
            meet(world, {smooth(lower), smooth(upper)});
            Solver<double> solver(world, meeting(1, 1));
            solver.frame();
            const Points x = solver.positions();
            const double left = meanOf(x, upper).y - meanOf(x, lower).y;
            CHECK(report((edges ? "edges, " : "point, ") + std::to_string(share) +
                             " of the way, off the gap, m",
                         std::fabs(left - gap), 1e-9));
        }
}

// Across the middle of each other: no corner comes near a triangle of the other.
TEST_CASE("contacts: an edge goes through none that is pinned, whichever moves",
          "[contacts][crossings][strangers]") {
    for (const bool strips : {false, true})
        for (const bool pinnedMoves : {false, true})
            for (const double speed : {1.0, 50.0}) {
                World world;
                Simplices cells;
                if (strips)
                    cells.triangles = {{0, 1, 2}};
                else
                    cells.edges = {{0, 1}};
                const auto add = [&](Points at, double v) {
                    if (!strips) at.pop_back();
                    const int count = static_cast<int>(at.size());
                    const Points velocity(at.size(), Vec<double>{0, v, 0});
                    return world.add({SimplicialComplex(count, cells), at}, {.velocity = velocity});
                };
                const Range bar = add({{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}}, 0);
                const Range matter =
                    add({{0, 0.1, -1}, {0, 0.1, 1}, {0.05, 0.1, 1}}, pinnedMoves ? 0 : -speed);
                std::vector<int> ends;
                for (int v = bar.first; v < bar.last; ++v) ends.push_back(v);
                world.pin(ends, [=](const Vec<double>& x, double t) {
                    return x + Vec<double>{0, pinnedMoves ? speed * t : 0.0, 0};
                });
                meet(world, {smooth(bar), smooth(matter)});
                Solver<double> solver(world, meeting(4));
                // Where an edge from `a` is over the bar.
                const auto over = [&](const Points& x, int a, int b) {
                    const double part = divide(x[a].z, x[a].z - x[b].z);
                    return x[a].y + part * (x[b].y - x[a].y);
                };
                int below = 0;
                for (int frame = 0; frame < 4; ++frame) {
                    solver.frame();
                    const Points x = solver.positions();
                    for (int v = matter.first + 1; v < matter.last; ++v)
                        below += over(x, matter.first, v) <= x[0].y;
                }
                INFO((strips ? "strips" : "rods") << ", at " << speed << " m/s, the pinned one "
                                                  << (pinnedMoves ? "moves" : "stays"));
                CHECK(below == 0);
                CHECK(countsOf(solver, world).failed == 0);
            }
}
