// Mending: what is too long is swept until it is not, and nothing else is touched.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/sheets/mend_set.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr int side = 20;

Points moved(double far, int seed) {
    Random random(seed);
    Points x = grid({.columns = side, .rows = side}).positions;
    for (Vec<double>& p : x) p += random.point(far);
    return x;
}

// A sheet of edges of 1/19 m that starts at `x`, free and without weight.
World sheetAt(const Points& x) {
    World world;
    world.add(grid({.columns = side, .rows = side}), {.density = 0.2, .start = x});
    return world;
}

// What one evaluation makes of `state`. Returns the counted work.
template <class Real>
long mend(const World& world, const Mending& mending, State<Real>& state, int threads = 1,
          KernelChoice kernels = bestKernels()) {
    MendSet<Real> set(linksOf(world), static_cast<int>(world.rest.size()), kernels, mending);
    Workers workers(threads);
    const Sweep<Real> sweep{&state.particles[0].x.x, nullptr, 1e4, 1, 1};
    set.project(sweep, Direction::forward, workers);
    REQUIRE(set.size() == 0);
    set.project(sweep, Direction::backward, workers);
    return set.size();
}

template <class Real>
Points positionsOf(const State<Real>& state) {
    Points x;
    for (int i = 0; i < state.count(); ++i) x.push_back(state.position(i));
    return x;
}

// By how much each link is too long, over its length.
std::vector<double> excesses(const World& world, const Points& x) {
    const Rows<Stretch> links = linksOf(world);
    std::vector<double> all;
    for (std::size_t i = 0; i < links.rows.size(); ++i)
        all.push_back(length(x[links.ids[2 * i + 1]] - x[links.ids[2 * i]]) / links.rows[i].rest -
                      1);
    return all;
}

double greatest(const std::vector<double>& all) {
    return *std::max_element(all.begin(), all.end());
}

}  // namespace

TEMPLATE_TEST_CASE("mending: what is within tolerance or too short stays to the bit", "[mending]",
                   double, float) {
    World world = sheetAt(moved(2e-4, 1));  // links of 53 mm, off by up to 1.3 %
    REQUIRE(greatest(excesses(world, world.start)) > 0.004);
    State<TestType> state = stateOf<TestType>(world);
    const Points before = positionsOf(state);
    CHECK(mend(world, {.tolerance = 0.02}, state) == 0);
    CHECK(positionsOf(state) == before);
    for (Vec<double>& x : world.start) x = 0.7 * x;
    State<TestType> shrunk = stateOf<TestType>(world);
    const Points small = positionsOf(shrunk);
    CHECK(mend(world, {.tolerance = 1e-3}, shrunk) == 0);
    CHECK(positionsOf(shrunk) == small);
}

// One vertex is pulled out of place, by half an edge: only so many rings of neighbours move.
TEMPLATE_TEST_CASE("mending: links that are too long are mended, and far from them nothing moves",
                   "[mending]", double, float) {
    World world = sheetAt(moved(0, 1));
    const int pulled = side / 2 * side + side / 2;
    world.start[pulled].z += 0.03;
    REQUIRE(greatest(excesses(world, world.start)) > 0.1);
    const Mending mending{.tolerance = 0.01, .rings = 3, .sweeps = 40, .rounds = 1};
    const double strain = greatest(excesses(world, world.start));
    State<TestType> state = stateOf<TestType>(world);
    const Points before = positionsOf(state);
    const long work = mend(world, mending, state);
    const Points after = positionsOf(state);
    CHECK(report("strain after one round", greatest(excesses(world, after)), strain / 2));
    int still = 0;
    for (int v = 0; v < side * side; ++v) {
        const int far = std::max(std::abs(v % side - side / 2), std::abs(v / side - side / 2));
        if (far > 1 + mending.rings) CHECK(after[v] == before[v]);
        still += after[v] == before[v];
    }
    CHECK(still > side * side / 2);
    // Every link between two vertices of the rings, and no other, in each of the sweeps.
    CHECK(work % mending.sweeps == 0);
    CHECK(work / mending.sweeps < world.complex.count(1) / 2);

    Vec<double> sum{0, 0, 0};
    double size = 0;
    for (int v = 0; v < side * side; ++v) {
        const Vec<double> move = world.mass[v] * (after[v] - before[v]);
        sum += move;
        size += length(move);
    }
    const double bound = std::is_same_v<TestType, float> ? 1e-5 : 1e-12;
    CHECK(report("resultant", length(sum) / size, bound));
}

TEST_CASE("mending: rounds go on until all is within tolerance", "[mending]") {
    World world = sheetAt(moved(0, 1));
    for (Vec<double>& x : world.start) x.x *= 1.3;  // all across is 30 % too long
    const auto left = [&](int rounds) {
        State<double> state = stateOf<double>(world);
        mend(world, {.tolerance = 0.01, .rounds = rounds}, state);
        return greatest(excesses(world, positionsOf(state)));
    };
    CHECK(left(40) < left(10));
    CHECK(report("strain after as many rounds as it takes", left(1000), 0.01));
}

TEST_CASE("mending: the same bits by any number of threads and lanes", "[mending]") {
    const World world = sheetAt(moved(0.02, 3));
    State<float> first = stateOf<float>(world);
    const long work = mend(world, {}, first, 1, {Isa::v2, 1});
    REQUIRE(work > 0);
    for (const int threads : {1, 2, 3})
        for (const KernelChoice kernels : {KernelChoice{Isa::v2, 4}, bestKernels()}) {
            State<float> state = stateOf<float>(world);
            CHECK(mend(world, {}, state, threads, kernels) == work);
            CHECK(positionsOf(state) == positionsOf(first));
        }
}

TEST_CASE("mending: links with compliance, and those that move, are refused", "[mending]") {
    World soft = sheetAt(moved(0, 1));
    mend(soft, linksOf(soft, 1e-3), {.name = "mending"});
    CHECK_THROWS_AS(Solver<float>(soft, {}), std::invalid_argument);
    World moving = sheetAt(moved(0, 1));
    Rows<Stretch> links = linksOf(moving);
    links.animate = [](double, std::span<Stretch::Row<double>>) {};
    mend(moving, links, {.name = "mending"});
    CHECK_THROWS_AS(Solver<float>(moving, {}), std::invalid_argument);
}
