// How a surface meets itself: as balls, as points and faces, or whole (M 4.5.1).
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/contacts/self_collision.h>
#include <plait/measure/surfaces/penetration.h>

#include <numbers>

using namespace plait;
using namespace plait::test;

namespace {

// Triangles that keep their shape.
Range addTriangles(World& world, const std::vector<std::array<Vec<double>, 3>>& corners,
                   const Points& velocities) {
    Simplices cells;
    Points x, v;
    for (std::size_t t = 0; t < corners.size(); ++t) {
        const int first = static_cast<int>(x.size());
        cells.triangles.push_back({first, first + 1, first + 2});
        for (const Vec<double>& corner : corners[t]) {
            x.push_back(corner);
            v.push_back(velocities[t]);
        }
    }
    return world.add({SimplicialComplex(static_cast<int>(x.size()), cells), x}, {.velocity = v});
}

void holdEdges(World& world, Range range) {
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, range), world.rest),
                    {.name = "links"});
}

// Two triangles, one upright and one that rises through its lower side: no vertex meets a face.
int crossingsOfEdges(Self self) {
    World world;
    const Range both = addTriangles(
        world,
        {{{{-1, 0, 0}, {1, 0, 0}, {0.1, 2, 0}}}, {{{0, -0.2, -1}, {0, -0.2, 1}, {0, -2.2, 0.1}}}},
        {{}, {0, 1, 0}});
    world.pin({0, 1, 2});
    holdEdges(world, both);
    meet(world, {{.vertices = both, .thickness = 0.01, .self = self}}, {.order = 1});
    Solver<float> solver(world, meeting(8));
    int most = 0;
    for (int frame = 0; frame < 12; ++frame) {  // 0.5 m
        solver.frame();
        most = std::max(most, countIntersections(solver.positions(), trianglesOf(world)));
    }
    return most;
}

}  // namespace

// As where a shirt is buttoned.
TEST_CASE("self-collision: only the full mode parts edges", "[contacts][self][SF1][SF8]") {
    CHECK(crossingsOfEdges(Self::full) == 0);
    CHECK(crossingsOfEdges(Self::vertexFace) > 0);
    CHECK(crossingsOfEdges(Self::vertex) > 0);
    CHECK(crossingsOfEdges(Self::none) > 0);
}

namespace {

constexpr int across = 16, bullets = (across / 2 - 1) * (across / 2 - 1);
constexpr double cell = 0.1;  // m

Shape square() { return grid({across + 1, across + 1, across * cell, across * cell}); }

// A square sheet that is held, `stretch` times as wide as at rest, and small triangles that are
// shot at it, one vertex ahead, at every second cell; all of it is one surface. How many of them
// get through.
struct Shots {
    Self self;
    double thickness;
    double width = 1;
    double stretch = 1;
};

int through(const Shots& shots) {
    World world;
    const Shape sheet = square();
    Points start = sheet.positions;
    for (Vec<double>& x : start) x.x *= shots.stretch;
    const Range held = world.add(sheet, {.start = start});
    std::vector<int> all(held.last);
    for (int v = held.first; v < held.last; ++v) all[v] = v;
    world.pin(all);
    Random random(4);
    std::vector<std::array<Vec<double>, 3>> corners;
    for (int i = 2; i < across; i += 2)
        for (int j = 2; j < across; j += 2) {
            const Vec<double> tip{shots.stretch * cell * (i + random.uniform(0, 1)),
                                  cell * (j + random.uniform(0, 1)), 0.15};
            corners.push_back(
                {tip, tip + Vec<double>{0.002, 0, 0.02}, tip + Vec<double>{0, 0.002, 0.02}});
        }
    const Range shot = addTriangles(world, corners, Points(bullets, {0, 0, -2}));
    holdEdges(world, shot);
    meet(world,
         {{.vertices = {held.first, shot.last},
           .thickness = shots.thickness,
           .self = shots.self,
           .selfWidth = shots.width}},
         {.order = 1});
    Solver<float> solver(world, meeting(8));
    advance(solver, 8);  // 0.67 m
    const Points x = solver.positions();
    int count = 0;
    for (int v = shot.first; v < shot.last; v += 3) count += x[v].z < 0;
    return count;
}

double automatic() {
    const Shape sheet = square();
    return automaticThickness(sheet.complex, {0, sheet.complex.count(0)}, sheet.positions);
}

}  // namespace

TEST_CASE("self-collision: points go through no face, and through holes between balls",
          "[contacts][self][SF1][SF4]") {
    const double thickness = automatic();
    CHECK(through({Self::none, thickness}) == bullets);
    CHECK(through({Self::full, thickness}) == 0);
    CHECK(through({Self::vertexFace, thickness}) == 0);
    CHECK(through({Self::vertexFace, 0.01 * thickness}) == 0);
    CHECK(through({Self::vertex, thickness, denseWidth}) == 0);
    const int few = through({Self::vertex, thickness});
    note("through balls of width 1, of " + std::to_string(bullets), few);
    CHECK(few > bullets / 2);
}

// A mesh that is pulled out, as by too few sweeps, opens between its balls.
TEST_CASE("self-collision: balls let through what a stretched mesh leaves between them",
          "[contacts][self][SF7]") {
    const double thickness = automatic();
    for (const double stretch : {1.0, 1.4, 1.8, 2.0, 2.4, 3.0}) {
        Shape sheet = square();
        for (Vec<double>& x : sheet.positions) x.x *= stretch;
        const bool holes = widthWithoutHoles(sheet.complex, {0, sheet.complex.count(0)},
                                             sheet.positions, thickness) > denseWidth;
        CHECK(holes == (stretch > 1.9));
        const int some = through({Self::vertex, thickness, denseWidth, stretch});
        note("through a mesh stretched " + std::to_string(stretch) + " times", some);
        CHECK((some > 0) == holes);
        CHECK(through({Self::vertexFace, thickness, 1, stretch}) == 0);
    }
}

TEST_CASE("self-collision: the automatic thickness is a sixth of the mean triangle's side",
          "[contacts][self][SF3]") {
    const double side = 0.3, height = 0.5 * std::sqrt(3.0) * side;
    Simplices cells;
    Points x;
    for (int i = 0; i < 5; ++i) {
        cells.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        x.insert(x.end(), {{0, 1.0 * i, 0}, {side, 1.0 * i, 0}, {0.5 * side, 1.0 * i, height}});
    }
    const SimplicialComplex equal(15, cells);
    CHECK(report("equilateral, m", std::fabs(automaticThickness(equal, {0, 15}, x) - side / 6),
                 1e-15));
    CHECK(report("balls of width 3 then touch, m",
                 std::fabs(2 * denseWidth * automaticThickness(equal, {0, 15}, x) - side), 1e-15));
    // Twice the side has four times the area.
    for (int v = 12; v < 15; ++v) x[v] = 2.0 * x[v];
    CHECK(report("mean of areas, m",
                 std::fabs(automaticThickness(equal, {0, 15}, x) - side / 6 * std::sqrt(8.0 / 5)),
                 1e-15));
    CHECK(report("of a range, m", std::fabs(automaticThickness(equal, {0, 12}, x) - side / 6),
                 1e-15));
    CHECK_THROWS_AS(automaticThickness(equal, {0, 2}, x), std::invalid_argument);
    CHECK_THROWS_AS(widthWithoutHoles(equal, {0, 15}, x, 0), std::invalid_argument);
}

// Brute force: no place of a triangle is further from its nearest corner, and some place is as far.
TEST_CASE("self-collision: balls of the width without holes cover all triangles",
          "[contacts][self][SF4]") {
    constexpr int parts = 200;
    Random random(8);
    double over = 0, under = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Points x{random.point(1), random.point(1), random.point(1)};
        if (trial % 4 == 1) x[2] = x[0] + cross(x[1] - x[0], x[2]);  // a right angle
        if (trial % 4 == 2) x[2] = 0.6 * x[0] + 0.4 * x[1] + 0.05 * x[2];
        Simplices cells;
        cells.triangles.push_back({0, 1, 2});
        const SimplicialComplex one(3, cells);
        const double thickness = 0.07;
        const double reach = 2 * thickness * widthWithoutHoles(one, {0, 3}, x, thickness);
        double hole = 0, longest = 0;
        for (int i = 0; i < 3; ++i) longest = std::max(longest, length(x[(i + 1) % 3] - x[i]));
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const Vec<double> p =
                    x[0] + (1.0 * i / parts) * (x[1] - x[0]) + (1.0 * j / parts) * (x[2] - x[0]);
                hole = std::max(hole,
                                std::min({length(p - x[0]), length(p - x[1]), length(p - x[2])}));
            }
        over = std::max(over, hole - reach);
        under = std::max(under, (reach - hole) / (longest / parts));
    }
    CHECK(report("a place beyond the reach of balls, m", over, 1e-12));
    CHECK(report("reach beyond any place, in steps of the search", under, 1));
}

TEST_CASE("self-collision: dense meshes meet themselves as balls", "[contacts][self][SF2]") {
    const Shape sheet = square();
    const Range all{0, sheet.complex.count(0)};
    // Right angles: half the diagonal reaches everywhere.
    const double least = std::sqrt(0.5) * cell / (2 * denseWidth);
    CHECK(selfModeFor(sheet.complex, all, sheet.positions, 1.01 * least) == Self::vertex);
    CHECK(selfModeFor(sheet.complex, all, sheet.positions, 0.99 * least) == Self::vertexFace);
    CHECK(selfModeFor(sheet.complex, all, sheet.positions, automatic()) == Self::vertex);
}

namespace {

// A sheet folded upon itself, that falls onto a floor.
struct Work {
    long pairs, contacts, evaluations;
    int crossings;
};

Work fold(Self self, double width) {
    constexpr int side = 25;
    World world;
    Shape sheet = grid({.columns = side, .rows = side});
    const double thickness = automaticThickness(sheet.complex, {0, side * side}, sheet.positions);
    // A hairpin, its legs four thicknesses of a ball apart.
    Points start = sheet.positions;
    const double radius = 4 * thickness * denseWidth, half = 0.5 - 0.5 * std::numbers::pi * radius;
    for (Vec<double>& x : start) {
        const double way = x.x, bend = std::clamp((way - half) / radius, 0.0, std::numbers::pi);
        const double back = std::max(way - half - std::numbers::pi * radius, 0.0);
        x = {std::min(way, half) + radius * std::sin(bend) - back,
             1.1 * radius + radius * (1 - std::cos(bend)), x.y};
    }
    const Range cloth = world.add(sheet, {.density = 0.2, .start = start});
    const Range floor = addSlope(world, 0, 4);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, cloth);
    meet(world,
         {{.vertices = cloth, .thickness = thickness, .self = self, .selfWidth = width},
          {.vertices = floor, .thickness = thickness, .self = Self::none}},
         {.order = 9});
    Solver<float> solver(world, meeting(8));
    Work work{};
    for (int frame = 0; frame < 16; ++frame) {
        solver.frame();
        work.crossings += countIntersections(solver.positions(), trianglesOf(world));
    }
    const ContactCounts& counts = countsOf(solver, world);
    work.pairs = counts.pairs;
    work.contacts = counts.contacts;
    work.evaluations = solver.evaluations();
    return work;
}

}  // namespace

TEST_CASE("self-collision: balls are far less work", "[contacts][self][SF5]") {
    const Work whole = fold(Self::full, 1), faces = fold(Self::vertexFace, 1),
               balls = fold(Self::vertex, denseWidth);
    for (const auto& [name, work] :
         {std::pair{"full", whole}, {"vertexFace", faces}, {"vertex", balls}}) {
        const std::string mode = name;
        note(mode + ", pairs", static_cast<double>(work.pairs));
        note(mode + ", contacts", static_cast<double>(work.contacts));
        note(mode + ", evaluations", static_cast<double>(work.evaluations));
        CHECK(work.crossings == 0);
    }
    CHECK(4 * balls.pairs < whole.pairs);
    CHECK(balls.pairs < faces.pairs);
    CHECK(4 * balls.contacts < whole.contacts);
    CHECK(fold(Self::none, 1).crossings > 0);
}

namespace {

// Two balls, one surface, one held: crossings of triangles, and vertices inside, in all frames.
struct Clash {
    int crossings = 0, inside = 0;
    long pairs = 0;
};

Clash clash(Self self) {
    World world;
    const SphereParameters size{.subdivisions = 2, .radius = 0.2};
    const Range held = world.add(sphere(size));
    const Range thrown =
        world.add(sphere(size, {.origin = {0.03, 0.6, 0.02}}),
                  {.velocity = Points(sphere(size).positions.size(), Vec<double>{0, -3, 0})});
    std::vector<int> all(held.last);
    for (int v = 0; v < held.last; ++v) all[v] = v;
    world.pin(all);
    holdEdges(world, thrown);
    meet(world, {{.vertices = {0, thrown.last}, .thickness = 0.005, .self = self}}, {.order = 1});
    Solver<float> solver(world, meeting(8));
    Clash found;
    std::vector<std::array<int, 3>> one, other;
    for (const auto& t : trianglesOf(world)) (t[0] < held.last ? one : other).push_back(t);
    for (int frame = 0; frame < 24; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        found.crossings += countCrossings(x, one, other);
        const std::span<const Vec<double>> points(x);
        found.inside += static_cast<int>(findInside(points.subspan(held.last), points, one).size());
    }
    found.pairs = countsOf(solver, world).pairs;
    return found;
}

}  // namespace

TEST_CASE("self-collision: faces alone hold closed surfaces apart", "[contacts][self][SF8]") {
    const Clash none = clash(Self::none), faces = clash(Self::vertexFace),
                whole = clash(Self::full);
    note("vertexFace, crossings", faces.crossings);
    note("pairs of vertexFace / full", double(faces.pairs) / double(whole.pairs));
    CHECK(none.inside > 0);
    CHECK(faces.inside == 0);
    CHECK(faces.crossings == 0);
    CHECK(whole.crossings == 0);
    CHECK(2 * faces.pairs < whole.pairs);
}
