// Neither the order in which a scene is told nor the colours that its constraints get show in the
// result (validation D 26).
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/numbers/finite.h>

#include <cmath>
#include <numeric>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

double distance(const Points& a, const Points& b) {
    REQUIRE(allFinite(a));
    REQUIRE(allFinite(b));
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += dot(a[i] - b[i], a[i] - b[i]);
    return std::sqrt(squares / static_cast<double>(a.size()));
}

// The places in which a set's constraints and a world's vertices stand.
std::vector<int> shuffled(int n, std::uint64_t seed) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    Random random(seed);
    for (int i = n; i-- > 1;)
        std::swap(order[static_cast<std::size_t>(i)],
                  order[static_cast<std::size_t>(random.below(i + 1))]);
    return order;
}

// A sheet in a world whose vertices and links are in no order; `place` of a vertex of the grid.
struct Disorder {
    World world;
    std::vector<int> place;
};

enum class Coloring { greedy, oneLinkEach };

template <class Kind>
Rows<Kind> ordered(const std::vector<int>& ids, const Points& rest, double compliance,
                   std::uint64_t seed, Coloring coloring) {
    Rows<Kind> rows = restRows<Kind>(ids, rest, compliance);
    Rows<Kind> mixed = rows;
    std::vector<int> order = shuffled(rows.size(), seed + 1000);
    if (seed == 0) std::iota(order.begin(), order.end(), 0);
    for (int i = 0; i < rows.size(); ++i) {
        mixed.rows[i] = rows.rows[order[i]];
        for (int a = 0; a < Kind::arity; ++a)
            mixed.ids[Kind::arity * i + a] = ids[Kind::arity * order[i] + a];
    }
    if (coloring == Coloring::oneLinkEach) {
        mixed.colors.resize(mixed.rows.size());
        std::iota(mixed.colors.begin(), mixed.colors.end(), 0);
    }
    return mixed;
}

// Warp and weft, both diagonals and joints along the threads: left and right are alike.
struct Weave {
    std::vector<int> threads, diagonals, joints;

    Weave(int n, const std::vector<int>& place) {
        const auto join = [&](std::vector<int>& ids, std::initializer_list<int> vertices) {
            for (const int v : vertices) ids.push_back(place[static_cast<std::size_t>(v)]);
        };
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c) {
                const int v = r * n + c;
                if (c + 1 < n) join(threads, {v, v + 1});
                if (r + 1 < n) join(threads, {v, v + n});
                if (c + 2 < n) join(joints, {v, v + 1, v + 2});
                if (r + 2 < n) join(joints, {v, v + n, v + 2 * n});
                if (c + 1 == n || r + 1 == n) continue;
                join(diagonals, {v, v + n + 1});
                join(diagonals, {v + 1, v + n});
            }
    }
};

Disorder disorder(int n, std::uint64_t seed, Coloring coloring = Coloring::greedy) {
    const Shape shape = grid({.columns = n, .rows = n});
    const int count = n * n;
    std::vector<int> place = shuffled(count, seed);
    if (seed == 0) std::iota(place.begin(), place.end(), 0);
    Points rest(static_cast<std::size_t>(count)), start = rest;
    for (int i = 0; i < count; ++i) {
        const Vec<double> p = shape.positions[static_cast<std::size_t>(i)];
        rest[static_cast<std::size_t>(place[i])] = p;
        start[static_cast<std::size_t>(place[i])] = {
            p.x, -p.y * std::cos(0.5), p.y * std::sin(0.5) + 0.02 * std::sin(pi * p.x) * p.y};
    }
    Disorder result{{}, place};
    World& world = result.world;
    world.add({SimplicialComplex(count), rest}, {.density = 0.2 / count, .start = start});
    world.pin(std::vector<int>(place.begin(), place.begin() + n));
    world.act<Gravity>(GravityOptions{});
    const Weave weave(n, place);
    world.constrain(ordered<Stretch>(weave.threads, rest, 0, seed, coloring), {.name = "threads"});
    world.constrain(ordered<Stretch>(weave.diagonals, rest, 1e-2, seed, coloring),
                    {.name = "diagonals", .order = 1});
    world.constrain(ordered<Angle>(weave.joints, rest, 1e1, seed, coloring),
                    {.name = "bend", .order = 2});
    return result;
}

// By vertex of the grid.
Points fallen(const Disorder& d, int substeps, int frames = 12) {
    Solver<double> solver(d.world, {.schedule = {.substeps = substeps, .iterations = 1}});
    advance(solver, frames);
    Points x;
    for (const int p : d.place) x.push_back(solver.positions()[static_cast<std::size_t>(p)]);
    return x;
}

// Of the sheet and its mirror image, m.
double asymmetry(const Points& x, int n) {
    double worst = 0;
    for (int i = 0; i < n * n; ++i) {
        Vec<double> other = x[static_cast<std::size_t>(i / n * n + n - 1 - i % n)];
        other.x = 1 - other.x;
        worst = std::max(worst, length(x[static_cast<std::size_t>(i)] - other));
    }
    return worst;
}

}  // namespace

TEST_CASE("stress 26: neither the order of a scene nor its colours show", "[stress]") {
    const int n = 9, substeps = 50, orders = 20;
    const Points plain = fallen(disorder(n, 0), substeps);
    const double errorBar = distance(plain, fallen(disorder(n, 0), 8 * substeps));
    CHECK(report("error of the substep, of the size", errorBar, 5e-3));
    note("    of a substep of a quarter",
         distance(fallen(disorder(n, 0), 4 * substeps), fallen(disorder(n, 0), 8 * substeps)));
    double worst = 0;
    for (int seed = 1; seed <= orders; ++seed)
        worst = std::max(worst, distance(fallen(disorder(n, seed), substeps), plain));
    CHECK(report("20 orders of vertices and constraints, over that error", worst / errorBar, 1));
    const Points serial = fallen(disorder(n, 0, Coloring::oneLinkEach), substeps);
    CHECK(report("one link a colour, over that error", distance(serial, plain) / errorBar, 1));
    for (const int frames : {12, 24, 48})
        CHECK(report("a symmetric scene's asymmetry after " + std::to_string(frames) + " frames",
                     asymmetry(fallen(disorder(n, 0), substeps, frames), n), 1e-3));
}
