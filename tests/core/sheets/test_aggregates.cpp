// Coarse levels of a sheet, ways along its links, and tethers: bounds that no folding breaks, and
// what they are worth.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/report.h"
#include "tests/sheet.h"
#include "tests/shells.h"

#include <plait/constraints/constants.h>
#include <plait/measure/energy.h>
#include <plait/measure/momentum.h>
#include <plait/sets/constraint_set.h>
#include <plait/sheets/aggregates/aggregate_set.h>
#include <plait/sheets/tethers/tethers.h>

#include <numbers>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

std::vector<Link> linksBetween(const std::vector<int>& ids, const Points& rest) {
    std::vector<Link> links;
    for (std::size_t i = 0; i < ids.size(); i += 2)
        links.push_back({ids[i], ids[i + 1], length(rest[ids[i + 1]] - rest[ids[i]])});
    return links;
}

// Floyd and Warshall.
std::vector<std::vector<double>> allWays(int nodes, const std::vector<Link>& links) {
    std::vector<std::vector<double>> d(nodes, std::vector<double>(nodes, infinity));
    for (int n = 0; n < nodes; ++n) d[n][n] = 0;
    for (const Link& l : links) d[l.a][l.b] = d[l.b][l.a] = std::min(d[l.a][l.b], l.length);
    for (int k = 0; k < nodes; ++k)
        for (int i = 0; i < nodes; ++i)
            for (int j = 0; j < nodes; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
    return d;
}

// A sheet and what aggregates are made of it.
struct Sheet {
    Points rest;
    std::vector<Link> links;
    std::vector<double> mass;
    std::vector<AggregateLevel> levels;

    Sheet(Points at, const std::vector<int>& ids, const std::vector<int>& pins = {},
          bool even = false)
        : rest(std::move(at)), links(linksBetween(ids, rest)) {
        Random random(5);
        for (std::size_t i = 0; i < rest.size(); ++i)
            mass.push_back(even ? 1 : random.uniform(0.2, 1));
        for (const int p : pins) mass[p] = infinity;
        levels = aggregate(mass, rest, links, 4);
    }
    static Sheet of(const Shape& shape, const std::vector<int>& pins = {}, bool even = false) {
        return {shape.positions,
                edgeStencils(shape.complex, {0, static_cast<int>(shape.positions.size())}), pins,
                even};
    }

    // The largest |X_a - X_b| / bound of any level with the vertices at x; and the least, for links
    // that `counts` by the difference of their means.
    double tightest(const Points& x) const {
        double most = 0;
        forLinks(x, [&](const Vec<double>& d, double bound) {
            most = std::max(most, length(d) / bound);
        });
        return most;
    }
    template <class Visit>
    void forLinks(Points x, const Visit& visit) const {
        for (const AggregateLevel& level : levels) {
            Points mean(level.mass.size(), {0, 0, 0});
            for (std::size_t n = 0; n < x.size(); ++n)
                if (level.parent[n] >= 0) mean[level.parent[n]] += level.share[n] * x[n];
            for (const Link& link : level.links) visit(mean[link.b] - mean[link.a], link.length);
            x = std::move(mean);
        }
    }
};

// Folds at planes anywhere: what lies beyond is mirrored. No two points part.
void fold(Points& x, Random& random, int times) {
    while (times-- > 0) {
        Vec<double> normal = random.point(1);
        normal = (1 / length(normal)) * normal;
        const Vec<double> at = x[random.below(static_cast<int>(x.size()))];
        for (Vec<double>& p : x) p -= 2 * std::max(0.0, dot(p - at, normal)) * normal;
    }
}

// Rolled up around y, at a slant.
void roll(Points& x, double radius, double slant) {
    const Vec<double> u{std::cos(slant), std::sin(slant), 0},
        v{-std::sin(slant), std::cos(slant), 0};
    for (Vec<double>& p : x) {
        const double s = dot(p, u), t = dot(p, v);
        p = {radius * std::sin(s / radius), t, radius * std::cos(s / radius)};
    }
}

struct Hanging {
    int n = 16;
    int substeps = 60;
    int frames = 120;
    bool tethers = true, coarse = true;
};

struct Outcome {
    double energy = -1e30;  // J, the highest at the end of any frame; the start has 0
    double peak = 0;        // largest strain in the second half
    double mean = 0;        // of the frames' largest strains, in the second half
};

// A sheet of 1 m, n^2 equal masses, 0.2 kg, flat and at rest, let go from
// two corners, 60 frames a second.
template <class Real>
Outcome hang(const Hanging& of) {
    World world;
    const Range all =
        world.add(grid({.columns = of.n, .rows = of.n}, {.across = {1, 0, 0}, .up = {0, 0, 1}}));
    world.mass.assign(world.mass.size(), 0.2 / (of.n * of.n));
    world.pin({0, of.n - 1});
    world.act<Gravity>(GravityOptions{});
    const Rows<Stretch> links = sheetLinks(world, of.n, of.n);
    world.constrain(links, {.name = "links"});
    if (of.tethers)
        world.constrain(tethersOf(world.complex, all, world.rest, std::vector{0, of.n - 1}).set,
                        {.name = "tethers"});
    if (of.coarse) aggregate(world, links, {.name = "aggregates"});
    SolverOptions options;
    options.schedule = {.substeps = of.substeps, .frameRate = {60, 1}, .iterations = 1};
    Solver<Real> solver(world, options);
    Outcome outcome;
    for (int frame = 0; frame < of.frames; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        outcome.energy =
            std::max(outcome.energy, kineticEnergy(world.mass, solver.velocities()) +
                                         gravitationalEnergy(world.mass, x, {0, -9.81, 0}));
        if (2 * frame < of.frames) continue;
        double strain = 0;
        for (const double e : strainsOf(links, x)) strain = std::max(strain, e);
        outcome.peak = std::max(outcome.peak, strain);
        outcome.mean += strain / (of.frames / 2);
    }
    std::printf(
        "    %d x %d, %3d substeps%s%s: strain %.2f %% at most, %.2f %% on average; E %.1e J\n",
        of.n, of.n, of.substeps, of.tethers ? ", tethers" : "", of.coarse ? ", aggregates" : "",
        100 * outcome.peak, 100 * outcome.mean, outcome.energy);
    return outcome;
}

}  // namespace

TEST_CASE("ways: the shortest, from the nearest source, in order", "[aggregates]") {
    Random random(1);
    constexpr int nodes = 60;
    std::vector<Link> links;
    for (int i = 0; i < 110; ++i)
        links.push_back({random.below(nodes), random.below(nodes), random.uniform(0.1, 1)});
    const auto expected = allWays(nodes, links);
    Ways ways(nodes, links);
    for (int trial = 0; trial < 30; ++trial) {
        const std::vector<int> sources{random.below(nodes), random.below(nodes)};
        const int stop = trial % 2 ? random.below(20) : nodes;
        std::vector<bool> seen(nodes, false);
        double last = 0;
        int visited = 0;
        ways.from(sources, [&](int node, double distance, int source) {
            REQUIRE(!seen[node]);
            seen[node] = true;
            REQUIRE(distance >= last);
            last = distance;
            const double nearest = std::min(expected[sources[0]][node], expected[sources[1]][node]);
            REQUIRE(distance == Approx(nearest).epsilon(1e-14));
            REQUIRE(expected[source][node] == Approx(nearest).epsilon(1e-14));
            REQUIRE((source == sources[0] || source == sources[1]));
            return ++visited < stop;
        });
        if (stop < nodes) continue;
        for (int n = 0; n < nodes; ++n)
            REQUIRE(seen[n] ==
                    (std::min(expected[sources[0]][n], expected[sources[1]][n]) < infinity));
    }
}

TEST_CASE("aggregates: no folding of a sheet breaks a bound", "[aggregates]") {
    const Shell shell = shellOf(17, 13, 2);
    const Shape flat = grid({.columns = 17, .rows = 14}), round = disc({.rings = 8});
    const Sheet sheets[] = {Sheet::of(flat),
                            Sheet::of(round),
                            {shell.rest, shell.links},
                            Sheet::of(flat, {0, 16, 100}),
                            {shell.rest, shell.links, {5, 90}}};
    Random random(8);
    for (const Sheet& sheet : sheets) {
        REQUIRE(sheet.levels.size() >= 2);
        double worst = sheet.tightest(sheet.rest);
        note("a flat sheet, |X_a - X_b| / bound, greatest", worst);
        for (int trial = 0; trial < 60; ++trial) {
            Points x = sheet.rest;
            if (trial % 3 == 0) roll(x, random.uniform(0.02, 1), random.uniform(0, 3));
            fold(x, random, trial % 5);
            worst = std::max(worst, sheet.tightest(x));
        }
        CHECK(report("|X_a - X_b| / bound - 1, greatest of 60 foldings", worst - 1, 1e-12));
    }
}

TEST_CASE("aggregates: of a regular grid, squares with exact bounds along its axes",
          "[aggregates]") {
    const Sheet sheet = Sheet::of(grid({.columns = 16, .rows = 16}), {}, true);
    REQUIRE(sheet.levels.size() == 3);
    std::size_t expected = 64;
    for (const AggregateLevel& level : sheet.levels) {
        CHECK(level.mass.size() == expected);
        expected /= 4;
        for (const double m : level.mass) CHECK(m == level.mass[0]);
    }
    double worst = 0;
    int along = 0;
    sheet.forLinks(sheet.rest, [&](const Vec<double>& d, double bound) {
        if (std::min(std::fabs(d.x), std::fabs(d.y)) > 1e-12) return;
        worst = std::max(worst, std::fabs(length(d) / bound - 1));
        ++along;
    });
    CHECK(along == 2 * (8 * 7 + 4 * 3 + 2 * 1));
    CHECK(report("|X_a - X_b| / bound - 1 along the axes", worst, 1e-12));
}

// The rest is what ways along links are longer than straight. Couplings of the cheapest pairs
// first, without exchanges, reach 0.834.
TEST_CASE("aggregates: bounds of an irregular sheet are nearly what it reaches", "[aggregates]") {
    const Shell shell = shellOf(40, 30, 1);
    const Sheet sheet(shell.rest, shell.links);
    double reached = 0, bounds = 0;
    sheet.forLinks(sheet.rest, [&](const Vec<double>& d, double bound) {
        reached += length(d);
        bounds += bound;
    });
    note("distances of a flat sheet / bounds", reached / bounds);
    CHECK(reached > 0.85 * bounds);
}

TEST_CASE("aggregates: one with a pin stands at it, what has no link is in none", "[aggregates]") {
    Shape shape = grid({.columns = 9, .rows = 8});
    const std::vector<int> ids = edgeStencils(shape.complex, {0, 72});
    for (int i = 0; i < 500; ++i) shape.positions.push_back({0, 0, 1});
    const Sheet sheet(shape.positions, ids, {0, 40});
    REQUIRE(sheet.levels.size() == 2);  // 72 vertices, 20, 6, whatever is loose
    std::vector<int> pins{0, 40};
    for (const AggregateLevel& level : sheet.levels) {
        for (int& pin : pins) {
            const int p = level.parent[pin];
            CHECK(level.share[pin] == 1);
            CHECK(level.mass[p] == infinity);
            pin = p;
        }
        std::vector<double> sums(level.mass.size(), 0);
        for (std::size_t n = 0; n < level.parent.size(); ++n)
            if (level.parent[n] >= 0) sums[level.parent[n]] += level.share[n];
        for (const double sum : sums) CHECK(sum == Approx(1).epsilon(1e-12));
        for (const Link& link : level.links)
            CHECK_FALSE((level.mass[link.a] == infinity && level.mass[link.b] == infinity));
    }
    CHECK(aggregate(sheet.mass, sheet.rest, sheet.links, 70).empty());
    for (std::size_t n = 0; n < 572; ++n) CHECK((sheet.levels[0].parent[n] >= 0) == (n < 72));
}

// The two halves of a sheet torn apart: one coarse link that acts. It pulls each along the line
// between their means, so that no torque is left.
TEMPLATE_TEST_CASE("aggregates: one link moves its halves as wholes, without resultant or torque",
                   "[aggregates]", double, float) {
    World world;
    const Range all = world.add(grid({.columns = 4, .rows = 2}), {.density = 1});
    Random random(6);
    for (double& mass : world.mass) mass *= random.uniform(0.3, 2);
    for (Vec<double>& x : world.start) x = (2 + (x.x > 0.5 ? 1 : 0)) * x + random.point(0.1);
    std::vector<AggregateLevel> levels = aggregate(
        world.mass, world.rest, linksBetween(edgeStencils(world.complex, all), world.rest), 2);
    REQUIRE(levels.size() == 1);
    REQUIRE(levels[0].links.size() == 1);
    for (const Direction direction : {Direction::forward, Direction::backward}) {
        AggregateSet<TestType> set(levels, bestKernels());
        State<TestType> state = stateOf<TestType>(world);
        Points x;
        for (int i = 0; i < 8; ++i) x.push_back(state.position(i));
        Workers workers(1);
        set.begin({0.01, 1}, workers);
        const Sweep<TestType> sweep{&state.particles[0].x.x, nullptr, 1e4, 1, 1};
        set.project(sweep, direction, workers);
        Vec<double> sum{}, torque{}, mean[2] = {};
        double size = 0, mass[2] = {0, 0};
        for (int i = 0; i < 8; ++i) {
            const int half = levels[0].parent[i];
            const auto first = std::find(levels[0].parent.begin(), levels[0].parent.end(), half) -
                               levels[0].parent.begin();
            const Vec<double> move = state.position(i) - x[i];
            CHECK(length(move - (state.position(static_cast<int>(first)) - x[first])) < 1e-6);
            sum += world.mass[i] * move;
            torque += world.mass[i] * cross(x[i], move);
            size += world.mass[i] * length(move);
            mean[half] += world.mass[i] * state.position(i);
            mass[half] += world.mass[i];
        }
        const double bound = std::is_same_v<TestType, float> ? 1e-6 : 1e-12;
        CHECK(size > 0.1);
        CHECK(report("resultant", length(sum) / size, bound));
        CHECK(report("torque", length(torque) / size, bound));
        const double apart = length((1 / mass[1]) * mean[1] - (1 / mass[0]) * mean[0]);
        CHECK(report("distance of means / bound - 1",
                     std::fabs(apart / levels[0].links[0].length - 1), bound));
    }
}

TEMPLATE_TEST_CASE("aggregates: a free sheet keeps its momentum", "[aggregates]", double, float) {
    for (const bool coarse : {false, true}) {
        World world;
        Random random(3);
        Shape shape = grid({.columns = 20, .rows = 20});
        Points velocity;
        for (const Vec<double>& x : shape.positions)
            velocity.push_back(Vec<double>{0.5 - x.y, x.x, std::sin(5 * x.x) * std::cos(4 * x.y)} +
                               random.point(0.3));
        world.add(shape, {.density = 0.2, .velocity = velocity});
        const Rows<Stretch> links = linksOf(world);
        world.constrain(links, {.name = "links"});
        if (coarse) aggregate(world, links, {.name = "aggregates"});
        Solver<TestType> solver(world, stepping(1200));
        const auto turn = [&] {
            return angularMomentum(world.mass, solver.positions(), solver.velocities(),
                                   {0.5, 0.5, 0});
        };
        const Vec<double> p = momentum(world.mass, solver.velocities()), l = turn();
        double size = 0;
        for (std::size_t i = 0; i < velocity.size(); ++i)
            size += world.mass[i] * length(velocity[i]);
        advance(solver, 100);
        const double bound = std::is_same_v<TestType, float> ? 1e-5 : 1e-12;
        CHECK(report(coarse ? "momentum, with aggregates" : "momentum",
                     length(momentum(world.mass, solver.velocities()) - p) / size, bound));
        note("angular momentum lost, part", length(turn() - l) / length(l));
    }
}

TEST_CASE("aggregates: with palindromes a hanging sheet gains no energy", "[aggregates]") {
    for (const int substeps : {10, 200})
        CHECK(hang<double>({.n = 16, .substeps = substeps, .frames = 40}).energy <= 0);
}

// What each is worth: the strain of a sheet that swings, the mean of its frames' largest.
TEST_CASE("aggregates and tethers hold a sheet of 32 x 32", "[aggregates]") {
    const Outcome plain = hang<float>({.n = 32, .substeps = 20, .tethers = false, .coarse = false});
    const Outcome tied = hang<float>({.n = 32, .substeps = 20, .coarse = false});
    const Outcome both = hang<float>({.n = 32, .substeps = 20});
    CHECK(plain.mean > 0.1);
    CHECK(tied.mean > 1.2 * both.mean);  // alike if aggregates did nothing; the more, the finer
    CHECK(both.mean < 0.01);
}

TEST_CASE("aggregates and tethers hold a sheet of 64 x 64", "[aggregates][long]") {
    const Outcome plain = hang<float>({.n = 64, .tethers = false, .coarse = false});
    const Outcome tied = hang<float>({.n = 64, .coarse = false});
    const Outcome both = hang<float>({.n = 64});
    CHECK(plain.mean > 0.1);
    CHECK(tied.mean > 1.5 * both.mean);
    CHECK(both.mean < 0.008);
    CHECK(both.peak < 0.025);
}

TEMPLATE_TEST_CASE("tethers hold at the shortest way and are slack within it", "[aggregates]",
                   double, float) {
    World world;
    const Range all = world.add(grid({.columns = 7, .rows = 6}));
    world.add(chain({.links = 2, .from = {5, 0, 0}, .to = {6, 0, 0}}));
    const std::vector<int> hoist{0, 7, 14};
    const Rows<Tether> rows = tethersOf(world.complex, all, world.rest, hoist).set;
    REQUIRE(rows.size() == all.size() - 3);  // and none on the chain, where no way leads
    for (const double scale : {0.9, 1.3}) {
        State<TestType> state = stateOf<TestType>(world);
        const auto apart = [&](int i) {
            return length(state.position(rows.ids[i]) - rows.rows[i].anchor);
        };
        for (int i = 0; i < rows.size(); ++i) {
            const Vec<double> from = rows.rows[i].anchor, at = world.rest[rows.ids[i]];
            CHECK(std::fabs(rows.rows[i].length - length(at - from)) < 1e-12);
            for (const int anchor : hoist)
                CHECK(length(at - world.rest[anchor]) >= length(at - from));
            state.particles[rows.ids[i]].x = narrowed<TestType>(from + scale * (at - from));
        }
        const State<TestType> before = state;
        ConstraintSet<Tether, TestType> set(rows, static_cast<int>(world.rest.size()),
                                            bestKernels());
        Workers workers(1);
        set.begin({0.01, 1}, workers);
        set.project({&state.particles[0].x.x, nullptr, 1e4, 1, 1}, Direction::forward, workers);
        double worst = 0;
        for (int i = 0; i < rows.size(); ++i)
            if (scale < 1)
                CHECK(state.position(rows.ids[i]) == before.position(rows.ids[i]));
            else
                worst = std::max(worst, std::fabs(apart(i) - rows.rows[i].length));
        CHECK(report("distance - shortest way, m", worst,
                     std::is_same_v<TestType, float> ? 1e-6 : 1e-14));
    }
}

TEST_CASE("tethers: anchors apart each hold every vertex", "[aggregates]") {
    World world;
    const Range all = world.add(grid({.columns = 7, .rows = 6}));
    const std::vector<int> anchors{20, 0, 1, 13};  // 13 and 20 are neighbours, 0 and 1 too
    const Rows<Tether> rows = tethersOf(world.complex, all, world.rest, anchors).set;
    CHECK(rows.size() == 2 * (all.size() - 4));
    const int outside = all.size();
    CHECK_THROWS_AS(tethersOf(world.complex, all, world.rest, std::span(&outside, 1)),
                    std::invalid_argument);
}
