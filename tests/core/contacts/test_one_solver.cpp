// One solver is one universe: all that is in it pushes back, and nothing else is there.
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/solids/collider.h>
#include <plait/measure/momentum.h>

#include <numeric>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// A net of threads, free in space, and a ball of links that flies at it; no gravity, no friction.
struct Goal {
    World world;
    Range net{}, ball{};

    explicit Goal(double scale = 1) {
        constexpr int across = 9;
        Simplices threads;
        Points knots;
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i) {
                const int v = j * across + i;
                knots.push_back({0.1 * (i - 4), 0.1 * (j - 4), 0});
                if (i > 0) threads.edges.push_back({v - 1, v});
                if (j > 0) threads.edges.push_back({v - across, v});
            }
        net = world.add({SimplicialComplex(across * across, threads), knots},
                        {.density = 0.1 * scale});
        Points velocity(42, Vec<double>{0, 0, 6});
        ball =
            world.add(sphere({.subdivisions = 1, .radius = 0.16}, {.origin = {0.03, 0.02, -0.3}}),
                      {.density = 2 * scale, .velocity = velocity});
        world.constrain(linksOf(world), {.name = "links"});
        Surface threadsOf{.vertices = net, .thickness = 0.004};
        Surface skinOf{.vertices = ball, .thickness = 0.004};
        meet(world, {threadsOf, skinOf}, {.order = 1});
    }

    template <class Real>
    Vec<double> momentumOf(const Solver<Real>& solver, Range range) const {
        const auto v = solver.velocities();
        Vec<double> sum{};
        for (int i = range.first; i < range.last; ++i) sum += world.mass[i] * v[i];
        return sum;
    }
};

// A sheet at a height, that falls; alone it never meets anything.
Range addFalling(World& world, double height, double speed) {
    return world.add(grid({.columns = 6, .rows = 6}, {.origin = {0, height, 0}, .up = {0, 0, -1}}),
                     {.density = 0.2, .velocity = Points(36, Vec<double>{0, speed, 0})});
}

World falling(const std::vector<std::pair<double, double>>& sheets) {
    World world;
    std::vector<Surface> surfaces;
    for (const auto& [height, speed] : sheets)
        surfaces.push_back({.vertices = addFalling(world, height, speed), .thickness = 0.02});
    world.constrain(linksOf(world), {.name = "links"});
    meet(world, surfaces, {.order = 1});
    return world;
}

}  // namespace

TEMPLATE_TEST_CASE("one solver: a net of threads takes from a ball what it loses",
                   "[contacts][AR1]", float, double) {
    const Goal goal;
    Solver<TestType> solver(goal.world, meeting(10, 8));
    const Vec<double> before = momentum(goal.world.mass, solver.velocities());
    double worst = 0;
    for (int frame = 0; frame < 6; ++frame) {
        solver.frame();
        worst = std::max(worst, length(momentum(goal.world.mass, solver.velocities()) - before));
    }
    const double gained = goal.momentumOf(solver, goal.net).z / before.z;
    note("part of its momentum that the ball gave to the net", gained);
    CHECK(gained > 0.1);
    CHECK(countsOf(solver, goal.world).failures() == 0);
    CHECK(report("momentum of ball and net, change / all of it", worst / length(before),
                 std::is_same_v<TestType, float> ? 1e-6 : 1e-12));
}

// Only how heavy things are beside each other counts.
TEST_CASE("one solver: all masses times a number, and the same happens", "[contacts][UN10]") {
    const auto after = [](double scale) {
        const Goal goal(scale);
        Solver<double> solver(goal.world, meeting(10, 8));
        advance(solver, 6);
        return solver.positions();
    };
    const Points one = after(1);
    for (const double scale : {1e-3, 0.3, 1e3}) {
        const Points x = after(scale);
        double worst = 0;
        for (std::size_t v = 0; v < x.size(); ++v) worst = std::max(worst, length(x[v] - one[v]));
        CHECK(report("places with masses times " + std::to_string(scale) + ", m", worst, 1e-6));
    }
}

TEST_CASE("one solver: what is in another is not met", "[contacts][AR7]") {
    const World upper = falling({{0.2, -4}}), lower = falling({{0, 0}}),
                both = falling({{0.2, -4}, {0, 0}});
    Solver<float> one(upper, meeting(8)), other(lower, meeting(8)), alone(upper, meeting(8)),
        together(both, meeting(8));
    for (int frame = 0; frame < 6; ++frame) {
        one.frame();
        other.frame();
        together.frame();
    }
    advance(alone, 6);
    CHECK(one.hash() == alone.hash());
    CHECK(countsOf(one, upper).contacts == 0);
    CHECK(countsOf(other, lower).contacts == 0);
    CHECK(one.positions()[0].y < other.positions()[0].y - 0.1);
    CHECK(countsOf(together, both).contacts > 0);
    CHECK(together.positions()[0].y > together.positions()[36].y);
}

TEST_CASE("one solver: thickness and mass where nobody says", "[contacts][CC18]") {
    World world;
    const Range slope = addSlope(world, 0), point = addPoint(world, {0.3, 0.01, 0.2});
    const Range sheet = world.add(
        grid({.columns = 3, .rows = 3, .width = 2, .height = 0.5}, {.origin = {40, 0, 0}}));
    const Range chainOf = world.add(chain({.links = 4, .from = {60, 0, 0}, .to = {62, 0, 0}}));
    const Range fine = world.add(grid({.columns = 2, .rows = 2, .width = 2e-3, .height = 2e-3},
                                      {.origin = {80, 0, 0}, .up = {0, 0, -1}}));
    std::vector<int> held(static_cast<std::size_t>(fine.size()));
    for (int i = 0; i < fine.size(); ++i) held[static_cast<std::size_t>(i)] = fine.first + i;
    world.pin(held);
    const Range over = addPoint(world, {80 + 0.7e-3, 3e-3, -0.6e-3});
    const auto massOf = [&](Range range) {
        double sum = 0;
        for (int v = range.first; v < range.last; ++v) sum += world.mass[v];
        return sum;
    };
    CHECK(massOf(point) == 1);  // kg, of a point; else a metre, a square metre
    CHECK(massOf(sheet) == Approx(1).epsilon(1e-12));
    CHECK(massOf(chainOf) == Approx(2).epsilon(1e-12));
    world.act<Gravity>(GravityOptions{});
    Surface ground{.vertices = slope}, ball{.vertices = point}, weave{.vertices = fine},
        bead{.vertices = over};
    meet(world, {ground, ball, weave, bead});
    Solver<double> solver(world, meeting(20));
    advance(solver, 24);
    const Points x = solver.positions();
    // A millimetre each; an eighth of the mean edge, where that is less.
    const double edge = (4 * 2e-3 + std::sqrt(8.0) * 1e-3) / 5;
    CHECK(report("rest above the ground, m", std::fabs(x[point.first].y - 2e-3), 1e-9));
    CHECK(report("rest above a fine mesh, m", std::fabs(x[over.first].y - 1e-3 - edge / 8), 1e-9));
}

// M 4.2: five more passes at most over what crosses, and none where nothing does.
TEST_CASE("one solver: what still crosses is passed over five times more at most",
          "[contacts][SC11]") {
    const auto most = [](double speed) {
        std::vector<std::pair<double, double>> sheets;
        for (int i = 0; i < 10; ++i) sheets.push_back({0.1 * i, speed * (4.5 - i)});
        const World world = falling(sheets);
        Solver<float> solver(world, meeting(1, 1));
        long before = 0, found = 0;
        for (int frame = 0; frame < 8; ++frame) {
            solver.frame();
            const long now = countsOf(solver, world).passes;
            found = std::max(found, now - std::exchange(before, now));
        }
        return found;
    };
    CHECK(most(0) == 0);
    const long hasty = most(10);
    note("passes more in a substep, ten sheets", static_cast<double>(hasty));
    CHECK(hasty > 0);
    CHECK(hasty <= 5);
}

// What lies side by side in a sheet is a pair as soon as both skins reach across.
TEST_CASE("one solver: pairs jump where a skin reaches the neighbour", "[contacts][CC24]") {
    constexpr int across = 12;
    constexpr double cell = 0.1;
    const auto pairs = [](double thickness) {
        World world;
        const Range sheet = world.add(grid({.columns = across,
                                            .rows = across,
                                            .width = cell * (across - 1),
                                            .height = cell * (across - 1)}));
        world.constrain(linksOf(world), {.name = "links"});
        meet(world, {{.vertices = sheet, .thickness = thickness, .self = Self::vertex}},
             {.order = 1, .margin = 1e-4});
        Solver<float> solver(world, meeting(2));
        solver.frame();
        return countsOf(solver, world).pairs;
    };
    // Each time it is a neighbour more of all but those at the border, and nothing in between.
    long last = 0;
    int jumps = 0;
    for (double part = 0.05; part < 0.8; part += 0.025) {
        const long found = pairs(part * cell);
        if (found == last) continue;
        note("thickness " + std::to_string(part) + " cells, pairs", static_cast<double>(found));
        CHECK(found - last >= 2 * (across - 2) * (across - 2));
        last = found;
        ++jumps;
    }
    CHECK(jumps >= 2);
    CHECK(jumps <= 4);
}

// Points that fall and slide, each for itself: no order in which they are solved matters.
TEST_CASE("one solver: for particles alone one substep and one pass do as well",
          "[contacts][PA6]") {
    struct Result {
        double error;  // m, of the way aside and the height at rest
        long work;
    };
    const auto run = [](const SolverOptions& options) {
        constexpr int count = 50;
        World world;
        Points at, velocity;
        for (int i = 0; i < count; ++i) {
            at.push_back({0.1 * i, 0.2 + 0.01 * i, 0});
            velocity.push_back({0, 0, 0.1 + 0.002 * i});
        }
        const Range points =
            world.add({SimplicialComplex(count), at}, {.density = 1, .velocity = velocity});
        world.act<Gravity>(GravityOptions{});
        Collider floor{.solid = Solid::plane()};
        floor.staticFriction = floor.dynamicFriction = 0;
        Surface beads{
            .vertices = points, .thickness = 0.002, .staticFriction = 0, .dynamicFriction = 0};
        collide(world, {floor}, {beads});
        Solver<double> solver(world, options);
        advance(solver, 48);
        const Points x = solver.positions();
        Result result{0, solver.evaluations()};
        for (int i = 0; i < count; ++i)
            result.error = std::max(result.error,
                                    length(x[i] - Vec<double>{at[i].x, 0.002, 2 * velocity[i].z}));
        return result;
    };
    const Result cheap = run(meeting(1, 1)), usual = run({});
    note("evaluations, 1 substep and 1 pass", static_cast<double>(cheap.work));
    note("evaluations, as nobody says", static_cast<double>(usual.work));
    CHECK(report("places, 1 substep and 1 pass, m", cheap.error, 1e-9));
    CHECK(report("places, as nobody says, m", usual.error, 1e-9));
    CHECK(10 * cheap.work < usual.work);
}

// Three sheets that fall on a fourth: the second lets the first through, and all else stays.
TEST_CASE("one solver: two that ignore each other pass, and meet all others as before",
          "[contacts][LY4][LY5]") {
    const auto fall = [](std::vector<int> ignores) {
        World world;
        std::vector<Surface> surfaces;
        for (int i = 0; i < 3; ++i)
            surfaces.push_back(
                {.vertices = addFalling(world, 0.03 + 0.03 * i, 0), .thickness = 0.01});
        surfaces[1].ignores = std::move(ignores);
        std::vector<int> floor(36);
        const Range below = addFalling(world, 0, 0);
        for (int v = 0; v < 36; ++v) floor[static_cast<std::size_t>(v)] = below.first + v;
        world.pin(floor);
        surfaces.push_back({.vertices = below, .thickness = 0.01});
        world.act<Gravity>(GravityOptions{});
        world.constrain(linksOf(world), {.name = "links"});
        meet(world, surfaces, {.order = 1});
        Solver<float> solver(world, meeting(10, 4));
        advance(solver, 6);
        const Points x = solver.positions();
        std::array<double, 3> heights{};
        for (int i = 0; i < 3; ++i)
            heights[static_cast<std::size_t>(i)] = meanOf(x, {36 * i, 36 * (i + 1)}).y;
        return heights;
    };
    const auto all = fall({}), one = fall({0}), both = fall({0, 2});
    // On the floor, and one on the other: 2 cm to a layer.
    for (int i : {0, 1, 2}) CHECK(std::fabs(all[i] - 0.02 * (i + 1)) < 2e-3);
    CHECK(std::fabs(one[0] - 0.02) < 2e-3);
    CHECK(std::fabs(one[1] - 0.02) < 2e-3);
    CHECK(std::fabs(one[2] - 0.04) < 2e-3);
    CHECK(std::fabs(both[1] - 0.02) < 2e-3);
    CHECK(std::fabs(both[2] - 0.04) < 2e-3);
    World world;
    const Range sheet = addFalling(world, 0, 0);
    CHECK_THROWS_WITH(meet(world, {{.vertices = sheet, .ignores = {1}}}),
                      "contacts: there is no surface 1 to ignore");
}

// A particle within a block of tetrahedra flies through the faces that two of them share, and not
// through the block's own.
TEST_CASE("one solver: of tetrahedra only what is open meets anything", "[contacts][CC19]") {
    World world;
    const Range within = world.add(block({3, 3, 3, 0.3, 0.3, 0.3}, {.origin = {0, 0, 0}}));
    std::vector<int> all(static_cast<std::size_t>(within.size()));
    std::iota(all.begin(), all.end(), within.first);
    world.pin(all);
    const Vec<double> from{0.06, 0.07, 0.08}, velocity{1, 0.5, 0.3};
    const Range point = addPoint(world, from, 1, velocity);
    meet(world,
         {{.vertices = within, .thickness = 0.002}, {.vertices = point, .thickness = 0.002}});
    Solver<double> solver(world, meeting(10, 4));
    advance(solver, 4);
    CHECK(report("within, off its straight way, m",
                 length(solver.positions()[point.first] - from - 4.0 / 24 * velocity), 1e-12));
    CHECK(countsOf(solver, world).contacts == 0);
    advance(solver, 4);
    CHECK(std::fabs(solver.positions()[point.first].x - 0.296) < 1e-4);
    CHECK(countsOf(solver, world).failures() == 0);
}

// Sheets that are thrown on a floor: more passes look no more often, and leave less overlap.
TEST_CASE("one solver: passes over contacts look for none anew", "[contacts][SC19]") {
    const auto overlapAfter = [](int passes, long& searches) {
        World world;
        std::vector<Surface> surfaces;
        for (int i = 0; i < 6; ++i)
            surfaces.push_back(
                {.vertices = addFalling(world, 0.041 * i, i ? -4.0 : 0.0), .thickness = 0.02});
        std::vector<int> floor(36);
        std::iota(floor.begin(), floor.end(), 0);
        world.pin(floor);
        meet(world, surfaces);
        Solver<double> solver(world, meeting(1, passes));
        solver.frame();
        searches = countsOf(solver, world).searches;
        const Points x = solver.positions();
        double overlap = 0;
        for (int i = 1; i < 6; ++i)
            overlap = std::max(overlap, 0.04 - (x[36 * i].y - x[36 * (i - 1)].y));
        return overlap;
    };
    long first = 0, searches = 0;
    double before = overlapAfter(1, first);
    for (const int passes : {4, 16, 64}) {
        const double overlap = overlapAfter(passes, searches);
        note("overlap, m, passes " + std::to_string(passes), overlap);
        CHECK(searches == first);
        CHECK(overlap < before);
        before = overlap;
    }
    CHECK(before < 1e-9);
}
