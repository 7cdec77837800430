// What contacts cannot hold is left out, named, and taken back (M 4.4, 4.5.3, V).
#include "closed_meshes.h"
#include "contact_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <set>

using namespace plait;
using namespace plait::test;

TEST_CASE("failed contacts: what fails is marked beside what is marked by hand",
          "[contacts][failed][FH8][FH9]") {
    const int failed[4]{2, 3, 2, 3}, freed[4]{0, 1, 0, 1};
    for (int flag = 0; flag < 4; ++flag) {
        CHECK(Disabled::fail(flag) == failed[flag]);
        CHECK(Disabled::free(flag) == freed[flag]);
    }
}

// Two particles of one surface over a floor, the upper one fast enough to overtake.
TEST_CASE("failed contacts: by hand, with its own surface, with others, and both",
          "[contacts][failed][FH9][CC21]") {
    for (const int own : {0, 1})
        for (const int others : {0, 1}) {
            World world;
            const Range floor = addSlope(world, 0);
            const Range pile =
                world.add({SimplicialComplex(2), Points{{0.3, 0.5, 0}, {0.3, 0.8, 0}}},
                          {.velocity = {{0, -1, 0}, {0, -3, 0}}});
            Surface surface;
            surface.vertices = pile;
            surface.thickness = 0.05;
            surface.disableSelf = std::vector<std::uint8_t>(2, static_cast<std::uint8_t>(own));
            surface.disableExternal =
                std::vector<std::uint8_t>(2, static_cast<std::uint8_t>(others));
            meet(world, {{.vertices = floor, .thickness = 0.01}, surface});
            Solver<double> solver(world, meeting(10, 8));
            advance(solver, 24);
            const Points x = solver.positions();
            const double low = x[pile.first].y, high = x[pile.first + 1].y;
            INFO("with its own " << own << ", with others " << others);
            CHECK((low > 0) == (others == 0));
            CHECK((high > 0) == (others == 0));
            CHECK((high > low + 0.0999) == (own == 0));
        }
}

// A drop over each triangle of a sheet that is held; one vertex of it is out.
TEST_CASE("failed contacts: simplices with a corner that is out meet nothing",
          "[contacts][failed][FH9]") {
    constexpr int side = 5, middle = 12;
    World world;
    const Range sheet =
        pinned(world, world.add(grid({.columns = side, .rows = side}, {.up = {0, 0, -1}})));
    Points at;
    for (const auto& t : trianglesOf(world))
        at.push_back(1.0 / 3 * (world.start[t[0]] + world.start[t[1]] + world.start[t[2]]) +
                     Vec<double>{0, 0.1, 0});
    const int count = static_cast<int>(at.size());
    const Range drops = world.add({SimplicialComplex(count), at},
                                  {.velocity = Points(at.size(), Vec<double>{0, -1, 0})});
    Surface surface;
    surface.vertices = sheet;
    surface.disableExternal.assign(side * side, 0);
    surface.disableExternal[middle] = 1;
    meet(world, {surface, {.vertices = drops}});
    Solver<double> solver(world, meeting(10));
    advance(solver, 6);
    int wrong = 0, through = 0;
    for (int i = 0; i < count; ++i) {
        const auto t = world.complex.vertices(2, i);
        const bool out = std::ranges::find(t, middle) != t.end();
        const bool below = solver.positions()[drops.first + i].y < 0;
        wrong += out != below;
        through += below;
    }
    CHECK(through == 6);
    CHECK(wrong == 0);
}

namespace {

constexpr double row = 0.5 / 8;  // m

// A plate that is held, level, and an upright cloth that pierces it and moves up at `speed`.
struct Snag {
    World world;
    Range plate, cloth;

    Snag(double speed, const ContactOptions& options, bool one = false) {
        plate = pinned(world, world.add(grid({.columns = 8, .rows = 8},
                                             {.origin = {-0.5, 0, 0.5}, .up = {0, 0, -1}})));
        cloth = world.add(grid({.columns = 9, .rows = 9, .width = 0.5, .height = 0.5},
                               {.origin = {-0.237, -0.163, 0.011}}),
                          {.density = 0.2, .velocity = Points(81, Vec<double>{0, speed, 0})});
        world.constrain(restRows<Stretch>(edgeStencils(world.complex, cloth), world.rest),
                        {.name = "links"});
        std::vector<Surface> surfaces(2);
        surfaces[0].vertices = one ? Range{plate.first, cloth.last} : plate;
        surfaces[1].vertices = cloth;
        if (one) surfaces.pop_back();
        if (!one) {
            surfaces[1].disableExternal.assign(81, 0);
            surfaces[1].disableExternal[0] = 1;
        }
        meet(world, surfaces, options);
    }

    // Of the cloth, by the exact test.
    std::set<int> piercing(const Points& x) const {
        const auto triangles = trianglesOf(world);
        const auto edges = edgesOf(triangles);
        std::set<int> found;
        for (const Intersection& i : findIntersections(x, edges, triangles)) {
            for (const int v : edges[i.edge]) found.insert(v);
            for (const int v : triangles[i.triangle]) found.insert(v);
        }
        std::erase_if(found, [&](int v) { return v < cloth.first; });
        return found;
    }
};

ContactOptions disabling() { return {.order = 1, .disableFailed = true}; }

// By how much the cloth has moved up, m.
double risen(const Snag& snag, const Points& x) {
    return meanOf(x, snag.cloth).y - meanOf(snag.world.start, snag.cloth).y;
}

double risen(double speed, const ContactOptions& options, bool one, double seconds) {
    const Snag snag(speed, options, one);
    Solver<float> solver(snag.world, meeting(10));
    advance(solver, static_cast<int>(24 * seconds));
    return risen(snag, solver.positions());
}

}  // namespace

// In the drawer of the one set that has any.
auto& flagsOf(auto& state) {
    return std::ranges::max_element(state.kept, {},
                                    [](const auto& drawer) { return drawer.integers.size(); })
        ->integers;
}

TEST_CASE("failed contacts: exactly what pierces is out", "[contacts][failed][FH7]") {
    const Snag snag(0, disabling());
    Solver<double> solver(snag.world, meeting(10));
    solver.frame();
    const std::set<int> expected = snag.piercing(snag.world.start);
    REQUIRE(expected.size() > 10);
    std::set<int> found;
    const auto& flags = flagsOf(solver.state());
    for (int v = 0; v < std::ssize(flags); ++v)
        if (flags[v] & Disabled::asFailed) found.insert(v);
    CHECK(found == expected);
    CHECK(countsOf(solver, snag.world).disabled == std::ssize(expected));
    CHECK(countsOf(solver, snag.world).tangled == std::ssize(expected));
    CHECK(report("what is out stays where it is, m/s", topSpeed(solver), 1e-12));
}

TEST_CASE("failed contacts: what has come free is taken back", "[contacts][failed][FH8]") {
    const Snag snag(1, disabling());
    Solver<double> solver(snag.world, stepping(240));
    std::set<int> seen;
    for (int step = 0; step < 80; ++step) {
        const std::set<int> piercing = snag.piercing(solver.positions());
        solver.frame();
        int enabled = 0;
        for (const int v : piercing)
            enabled += (flagsOf(solver.state())[v] & Disabled::asFailed) == 0;
        CHECK(enabled == 0);
        seen.insert(piercing.begin(), piercing.end());
    }
    note("vertices that pierced", static_cast<double>(seen.size()));
    CHECK(
        report("slower than unhindered", std::fabs(3 * risen(snag, solver.positions()) - 1), 1e-9));
    const ContactCounts& counts = countsOf(solver, snag.world);
    CHECK(counts.disabled >= std::ssize(seen));
    CHECK(counts.enabled == counts.disabled);
    int byHand = 0, failed = 0;
    for (const int flag : flagsOf(solver.state())) {
        byHand += flag & Disabled::byHand;
        failed += flag & ~Disabled::byHand;
    }
    CHECK(byHand == 1);
    CHECK(failed == 0);
    const double held = risen(1, {.order = 1}, false, 1.0 / 3);
    note("risen with all contacts, m", held);
    CHECK(held < row);
}

// Left out only while they pierce; and the worse case: what goes in is let in.
TEST_CASE("failed contacts: what is trapped is left out of contacts", "[contacts][failed][FH5]") {
    for (const bool one : {false, true}) {
        ContactOptions options{.order = 1};
        (one ? options.selfTrapped : options.trapped) = true;
        for (const double speed : {1.0, -1.0}) {
            const double way = risen(speed, options, one, 1.0 / 3);
            CHECK(report("slower than unhindered", std::fabs(3 * way - speed), 1e-6));
            CHECK(std::fabs(risen(speed, {.order = 1}, one, 1.0 / 3)) < row);
        }
        // Each says nothing about the other's pairs.
        CHECK(std::fabs(risen(1, options, !one, 1.0 / 3)) < row);
    }
}

namespace {

// Two plates that are held close upon a strip of cloth, go through each other, and open again.
World elbow(const ContactOptions& options) {
    World world;
    std::vector<Surface> surfaces;
    for (const double side : {-1.0, 1.0}) {
        const Range plate = world.add(grid({.columns = 4, .rows = 4, .width = 1.2, .height = 1.2},
                                           {.origin = {-0.6, 0.1 * side, 0.6}, .up = {0, 0, -1}}));
        std::vector<int> all;
        for (int v = plate.first; v < plate.last; ++v) all.push_back(v);
        world.pin(all, [side](const Vec<double>& x, double t) {
            const double way = t < 0.25 ? t : std::max(0.5 - t, 0.0);  // 0.6 m/s and back
            return x - Vec<double>{0, 0.6 * side * way, 0};
        });
        surfaces.push_back({.vertices = plate, .thickness = 0.005, .self = Self::none});
    }
    const Range cloth = world.add(grid({.columns = 8, .rows = 8, .width = 0.5, .height = 0.5},
                                       {.origin = {-0.26, 0.013, 0.24}, .up = {0, 0, -1}}),
                                  {.density = 0.2});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, cloth), world.rest),
                    {.name = "links"});
    surfaces.push_back({.vertices = cloth, .thickness = 0.005});
    meet(world, surfaces, options);
    return world;
}

}  // namespace

TEST_CASE("failed contacts: what is pinched is let go and taken back",
          "[contacts][failed][FH7][FH8]") {
    const World world = elbow(disabling());
    Solver<float> solver(world, meeting(10));
    advance(solver, 24);
    const ContactCounts& counts = countsOf(solver, world);
    note("vertices disabled", static_cast<double>(counts.disabled));
    note("pairs that failed", static_cast<double>(counts.failed));
    CHECK(counts.disabled > 0);
    CHECK(counts.enabled == counts.disabled);
    CHECK(countIntersections(solver.positions(), trianglesOf(world)) == 0);
    const World control = elbow({.order = 1});
    Solver<float> all(control, meeting(10));
    advance(all, 24);
    note("pairs that failed, with nothing disabled",
         static_cast<double>(countsOf(all, control).failed));
    note("crossings, with nothing disabled",
         countIntersections(all.positions(), trianglesOf(control)));
    CHECK(counts.failed < countsOf(all, control).failed);
}

// The flags are a part of the state.
TEST_CASE("failed contacts: the same bits from any number of threads, and resumed",
          "[contacts][failed][determinism][threads]") {
    const World world = elbow(disabling());
    std::uint64_t expected = 0;
    State<float> middle;
    for (const int threads : {1, 2, 3}) {
        Solver<float> solver(world, meeting(10, 2, threads));
        advance(solver, 8);
        if (threads == 1) middle = solver.state();
        advance(solver, 6);
        if (threads == 1) expected = solver.hash();
        CHECK(solver.hash() == expected);
        solver.rewind();
        advance(solver, 14);
        CHECK(solver.hash() == expected);
    }
    REQUIRE(std::ranges::any_of(flagsOf(middle), [](int flag) { return flag != 0; }));
    Solver<float> resumed(world, meeting(10));
    resumed.restore(middle, 0);
    advance(resumed, 6);
    CHECK(resumed.hash() == expected);
    flagsOf(middle).resize(3);
    CHECK_THROWS_AS(resumed.restore(middle, 0), std::invalid_argument);
}

TEST_CASE("failed contacts: flags and limits out of range are refused", "[contacts][failed]") {
    World world;
    Surface surface;
    surface.vertices = addPoint(world, {});
    CHECK_THROWS_AS(meet(world, {surface}, {.displacementLimit = -1}), std::invalid_argument);
    surface.disableSelf = {2};
    CHECK_THROWS_AS(meet(world, {surface}), std::invalid_argument);
    surface.disableSelf = {0, 0};
    CHECK_THROWS_AS(meet(world, {surface}), std::invalid_argument);
}
