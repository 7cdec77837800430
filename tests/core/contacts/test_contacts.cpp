// Contact between matter and matter: where two are nearest, what is conserved, and the same bits.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/energy.h>
#include <plait/measure/momentum.h>

using namespace plait;
using namespace plait::test;

namespace {

using Four = std::array<Vec<double>, 4>;
using Weights = std::array<double, 4>;

// Every pair of points of the two is that of some s and t in [0, 1].
Weights weightsAt(const Pairing& pair, double s, double t) {
    if (pair.first == 2) return {1 - s, s, t - 1, -t};
    if (pair.second == 3) return {1, s - 1, s * (t - 1), -s * t};
    if (pair.second == 2) return {1, s - 1, -s, 0};
    return {1, -1, 0, 0};
}

Vec<double> apartAt(const Weights& weight, const Four& x) {
    Vec<double> sum{};
    for (std::size_t i = 0; i < 4; ++i) sum += weight[i] * x[i];
    return sum;
}

// The least of ever finer grids round the best so far.
double leastDistance(const Pairing& pair, const Four& x) {
    constexpr int cells = 24;
    double least = 1e300, s0 = 0.5, t0 = 0.5;
    for (double reach = 0.5; reach > 1e-8; reach *= 0.2) {
        const double s1 = s0, t1 = t0;
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; j <= cells; ++j) {
                const double s = std::clamp(s1 + reach * (2.0 * i / cells - 1), 0.0, 1.0);
                const double t = std::clamp(t1 + reach * (2.0 * j / cells - 1), 0.0, 1.0);
                const double distance = length(apartAt(weightsAt(pair, s, t), x));
                if (distance >= least) continue;
                least = distance;
                s0 = s;
                t0 = t;
            }
    }
    return least;
}

// Points of all kinds: anywhere, on a line, in a plane, at one place, in thin simplices.
Four somewhere(Random& random) {
    Four x;
    for (Vec<double>& p : x) p = random.point(1);
    const int kind = random.below(6);
    if (kind == 1)
        for (Vec<double>& p : x) p = p.x * Vec<double>{1, 2, 3};
    if (kind == 2)
        for (Vec<double>& p : x) p.y = 0;
    if (kind == 3) x[3] = x[random.below(3)];
    if (kind == 4) x[3] = x[2] + 1e-5 * x[3];
    if (kind == 5) x[3] = x[2] + (x[1] - x[0]);
    return x;
}

}  // namespace

TEST_CASE("contacts: the nearest points are the nearest", "[contacts]") {
    Random random(3);
    double worst = 0, sums = 0, outside = 0, apart = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const int kind = trial % 4;
        const Pairing pair{{0, 1, 2, 3}, kind == 0 ? 2 : 1, kind == 0 ? 2 : kind};
        Four x = somewhere(random);
        for (int i = pair.first + pair.second; i < 4; ++i) x[i] = x[i - 1];
        const Nearest found = nearest(pair, x);
        worst = std::max(worst, length(found.apart) - leastDistance(pair, x));
        apart = std::max(apart, length(found.apart - apartAt(found.weight, x)));
        double first = 0, second = 0;
        for (int i = 0; i < 4; ++i) {
            const double w = i < pair.first ? found.weight[i] : -found.weight[i];
            (i < pair.first ? first : second) += w;
            outside = std::max(outside, -w);
        }
        sums = std::max({sums, std::fabs(first - 1), std::fabs(second - 1)});
    }
    CHECK(report("further than the nearest, m", worst, 1e-7));
    CHECK(report("weights of a simplex, against a sum of 1", sums, 1e-9));
    CHECK(report("weights below 0", outside, 1e-9));
    CHECK(report("the way against its weights, m", apart, 1e-12));
}

TEST_CASE("contacts: particles rest as far apart as their radii together",
          "[contacts][CC25][CC8]") {
    World world;
    const Range pile =
        world.add({SimplicialComplex(3), Points{{0, 0, 0}, {0, 0.5, 0}, {0, 1.2, 0}}});
    world.pin({pile.first});
    world.act<Gravity>(GravityOptions{});
    meet(world, {{.vertices = pile, .radii = {0.1, 0.02, 0.3}}}, {});
    Solver<float> solver(world, meeting(20, 8));
    advance(solver, 48);
    const Points x = solver.positions();
    CHECK(report("lower, m", std::fabs(x[1].y - x[0].y - 0.12), 1e-5));
    CHECK(report("upper, m", std::fabs(x[2].y - x[1].y - 0.32), 1e-5));
}

// Particles in a row of which the first is driven into the second: in no evaluation does the push
// reach all, and what it has not reached is clear.
TEST_CASE("contacts: what is clear is looked at again, and less often", "[contacts]") {
    constexpr int count = 60;
    World world;
    Points row, velocity(count);
    for (int i = 0; i < count; ++i) row.push_back({0.100001 * (i % 2 ? count - i : i), 0, 0});
    velocity[0] = {24 * 0.05, 0, 0};
    const Range all = world.add({SimplicialComplex(count), row}, {.velocity = velocity});
    meet(world, {{.vertices = all, .thickness = 0.05}});
    const auto moved = [&](int passes) {
        Solver<double> solver(world, meeting(1, passes));
        solver.frame();
        const Points x = solver.positions();
        int sum = 0;
        for (int i = 0; i < count; ++i) sum += length(x[i] - row[i]) > 1e-9;
        note(std::to_string(passes) + " passes: particles moved", sum);
        note("contacts looked at", static_cast<double>(solver.evaluations()));
        return sum;
    };
    CHECK(moved(4) < count);
    CHECK(moved(240) == count);
}

namespace {

// Points on triangles and edges on edges, far from each other and about to touch: 40 pairs.
World touching(double friction) {
    World world;
    Random random(9);
    Simplices triangle, edge;
    triangle.triangles = {{0, 1, 2}};
    edge.edges = {{0, 1}};
    std::vector<Surface> surfaces;
    const auto add = [&](const Shape& shape, double speed) {
        Points velocity;
        for (std::size_t i = 0; i < shape.positions.size(); ++i)
            velocity.push_back(Vec<double>{0, speed, 0} + random.point(0.02));
        const Range range = world.add(shape, {.density = 2, .velocity = velocity});
        world.mass[range.first] = random.uniform(0.5, 5);
        surfaces.push_back(
            {.vertices = range, .staticFriction = friction, .dynamicFriction = friction});
    };
    for (int i = 0; i < 40; ++i) {
        const Vec<double> at{0.3 * (i % 5), 0.3 * (i % 7), 0.3 * (i / 5)}, up{0, 0.0025, 0};
        const auto near = [&](double x, double z) {
            return at + Vec<double>{0.1 * x, 0, 0.1 * z} + random.point(1e-4);
        };
        if (i % 2) {
            add({SimplicialComplex(3, triangle), {near(-1, -1), near(1, -1), near(0.1, 1)}}, 0.1);
            add({SimplicialComplex(1), {near(0, 0) + up}}, -0.1);
        } else {
            add({SimplicialComplex(2, edge), {near(-1, 0), near(1, 0.2)}}, 0.1);
            add({SimplicialComplex(2, edge), {near(0, -1) + up, near(0.1, 1) + up}}, -0.1);
        }
    }
    meet(world, surfaces);
    return world;
}

}  // namespace

// Of pairs that have not gone through each other, which are parted as they were when they met.
// Friction acts on skins that are a gap apart, and so turns a pair by its impulse times the gap.
TEMPLATE_TEST_CASE("contacts: keep momentum and angular momentum", "[contacts]", float, double) {
    for (const double friction : {0.0, 0.5}) {
        const World world = touching(friction);
        const double h = 1.0 / 240;
        SolverOptions options = stepping(240);
        options.sweeps = Sweeps::oneWay;
        Solver<TestType> solver(world, options);
        solver.frame();
        const Points v = solver.velocities();
        Vec<double> push{}, turn{};
        double pushes = 0, turns = 0;
        int pushed = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const Vec<double> impulse = world.mass[i] * (v[i] - world.velocity[i]);
            const Vec<double> x = world.start[i] + h * world.velocity[i];
            push += impulse;
            turn += cross(x, impulse);
            pushes += length(impulse);
            turns += length(cross(x, impulse));
            pushed += length(impulse) > 1e-5;
        }
        REQUIRE(pushed > 100);
        const double digits = sizeof(TestType) == 4 ? 1e-6 : 1e-11;
        CHECK(report("momentum", length(push) / pushes, digits));
        const double levers = friction * 0.002 * pushes / turns;
        CHECK(report("angular momentum", length(turn) / turns, digits + levers));
    }
}

// A sheet of points that begins far inside the thickness of a floor.
TEST_CASE("contacts: an overlap at the start is let go of slowly", "[contacts][CC15]") {
    struct Freed {
        double speed, way;  // m/s, and m in 1/24 s, at most
    };
    const auto freed = [](double recovery) {
        World world;
        const Range floor = addSlope(world, 0);
        const Range sheet = world.add(
            grid({.columns = 6, .rows = 6}, {.origin = {-0.5, 0.002, 0.5}, .up = {0, 0, -1}}));
        world.constrain(linksOf(world), {.name = "links"});
        meet(world,
             {{.vertices = floor, .thickness = 0.02}, {.vertices = sheet, .thickness = 0.03}},
             {.recovery = recovery});
        Solver<float> solver(world, meeting(20));
        Freed most{};
        for (int frame = 0; frame < 24; ++frame) {
            const double before = solver.positions()[sheet.first].y;
            solver.frame();
            most.speed = std::max(most.speed, topSpeed(solver));
            most.way = std::max(most.way, solver.positions()[sheet.first].y - before);
        }
        return most;
    };
    const Freed slow = freed(0.1);
    CHECK(report("speed, m/s", slow.speed, 1e-4));
    CHECK(report("way in 1/24 s, m", slow.way, 0.1 / 24 * (1 + 1e-4)));
    CHECK(freed(1e6).way > 0.047);
}

TEST_CASE("contacts: the same bits from any number of threads, and resumed",
          "[contacts][determinism][threads]") {
    World world;
    const Range sheet = world.add(
        grid({.columns = 16, .rows = 16}, {.origin = {-0.5, 0.255, 0.5}, .up = {0, 0, -1}}),
        {.density = 0.2});
    const Range ball = world.add(sphere({.subdivisions = 2, .radius = 0.25}));
    std::vector<int> all;
    for (int v = ball.first; v < ball.last; ++v) all.push_back(v);
    world.pin(all);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet);
    meet(world, {{.vertices = sheet}, {.vertices = ball, .self = Self::none}}, {.order = 9});
    std::uint64_t expected = 0;
    State<float> middle;
    long evaluations = 0;
    for (const int threads : {1, 2, 3, 8}) {
        Solver<float> solver(world, meeting(8, 2, threads));
        advance(solver, 5);
        if (threads == 1) {
            middle = solver.state();
            evaluations = solver.evaluations();
        }
        advance(solver, 5);
        if (threads == 1) expected = solver.hash();
        CHECK(solver.hash() == expected);
        REQUIRE(countsOf(solver, world).contacts > 30);
    }
    Solver<float> resumed(world, meeting(8, 2, 2));
    resumed.restore(middle, evaluations);
    advance(resumed, 5);
    CHECK(resumed.hash() == expected);
}

// The one vertex that is free has a lever of 1e-5 there: to part them alone it went 1,500 m.
TEST_CASE("contacts: what touches next to pinned vertices flings nothing away", "[contacts]") {
    World world;
    Simplices cells;
    cells.triangles.push_back({0, 1, 2});
    const Range sheet = world.add(
        {SimplicialComplex(3, cells), {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}}}, {.density = 0.1});
    const Range point = addPoint(world, {0.5, 5e-4, 1e-5});
    world.pin({0, 1, point.first});
    meet(world, {{.vertices = sheet}, {.vertices = point}});
    Solver<double> solver(world, meeting(10));
    solver.frame();
    CHECK(report("way of the free vertex, m",
                 length(solver.positions()[2] - Vec<double>{0.5, 0, 1}), 0.1));
}

// Cells of 2 mm: a thickness of 1 mm to either side would have every vertex touch the
// triangles beyond the next edge, and push them away.
TEST_CASE("contacts: what was given no thickness does not touch itself as it rests",
          "[contacts][strangers]") {
    for (const double cell : {0.0005, 0.002, 0.03}) {
        World world;
        const Range sheet =
            world.add(grid({.columns = 9, .rows = 9, .width = 8 * cell, .height = 8 * cell}));
        world.constrain(linksOf(world), {.name = "links"});
        meet(world, {{.vertices = sheet}});
        Solver<double> solver(world, meeting(10));
        solver.frame();
        CHECK(solver.positions() == world.start);
    }
    // And what lands is held off by the sum of both: 1 mm each, where cells are large.
    World world;
    const Range floor = addSlope(world, 0);
    const Range ball = world.add({SimplicialComplex(1), {{0.1, 0.01, 0.1}}});
    world.act<Gravity>(GravityOptions{});
    meet(world, {{.vertices = floor}, {.vertices = ball}});
    Solver<double> solver(world, meeting(10));
    for (int frame = 0; frame < 24; ++frame) solver.frame();
    CHECK(solver.positions()[static_cast<std::size_t>(ball.first)].y == Approx(0.002).margin(1e-6));
}
