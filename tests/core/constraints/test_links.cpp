// Links between lists of vertices.
#include "tests/catch.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/links.h>

#include <set>

using namespace plait;
using namespace plait::test;

namespace {

using Lists = std::vector<std::vector<int>>;

std::vector<int> linked(const Lists& components, Relation relation) {
    return linkStencils(components, Points(10), {.relation = relation});
}

Points scattered(int count) {
    Random random(4);
    Points x;
    for (int i = 0; i < count; ++i) x.push_back(random.point(1));
    return x;
}

Lists halves(int count) {
    Lists lists(2);
    for (int v = 0; v < count; ++v) lists[v < count / 2 ? 0 : 1].push_back(v);
    return lists;
}

}  // namespace

TEST_CASE("links: those of a relation are those written by hand", "[links][AT9][AT23]") {
    const Lists three{{0, 1}, {2}, {3, 4}};
    CHECK(linked(three, Relation::allToAll) ==
          std::vector<int>{0, 2, 1, 2, 0, 3, 0, 4, 1, 3, 1, 4, 2, 3, 2, 4});
    CHECK(linked(three, Relation::allToFirst) ==
          std::vector<int>{0, 2, 1, 2, 0, 3, 0, 4, 1, 3, 1, 4});
    CHECK(linked(three, Relation::chain) == std::vector<int>{0, 2, 1, 2, 2, 3, 2, 4});
    // Lists of one object, in any order, that have vertices in common.
    CHECK(linked({{7, 5}, {5, 7, 6}}, Relation::chain) == std::vector<int>{7, 5, 7, 6, 5, 6});
    CHECK(linked({{3}, {}}, Relation::allToAll).empty());
    CHECK(linked({}, Relation::within).empty());
}

TEST_CASE("links: within a component each vertex is linked to each, and to no other",
          "[links][AT10]") {
    CHECK(linked({{1, 2, 4}, {8, 9}}, Relation::within) ==
          std::vector<int>{1, 2, 1, 4, 2, 4, 8, 9});
}

TEST_CASE("links: within a distance are those of all that are as near", "[links][AT12]") {
    constexpr int count = 200;
    Points x = scattered(count);
    x[150] = x[20], x[151] = x[21];
    for (const double most : {0.0, 0.1, 0.5, 10.0}) {
        int expected = 0;
        for (int a = 0; a < count / 2; ++a)
            for (int b = count / 2; b < count; ++b) expected += length(x[b] - x[a]) <= most;
        const auto links = linkStencils(halves(count), x, {.maxDistance = most});
        CHECK(std::ssize(links) == 2 * expected);
        for (std::size_t i = 0; i < links.size(); i += 2)
            CHECK(length(x[links[i]] - x[links[i + 1]]) <= most);
    }
    CHECK(linkStencils(halves(count), x, {.maxDistance = 0}) == std::vector<int>{20, 150, 21, 151});
}

TEST_CASE("links: a density keeps its part, the same by a seed", "[links][AT13]") {
    constexpr int count = 200;
    const Points x = scattered(count);
    const auto some = [&](double density, std::uint64_t seed) {
        return linkStencils(halves(count), x, {.density = density, .seed = seed});
    };
    const auto all = some(1, 1);
    CHECK(all.size() == 2 * 100 * 100);
    CHECK(some(0, 1).empty());
    for (const double density : {0.1, 0.5, 0.9}) {
        const double part = static_cast<double>(some(density, 3).size()) / 20000;
        const double sigma = std::sqrt(density * (1 - density) / 10000);
        CHECK(report("part of the links, off", std::fabs(part - density), 4 * sigma));
        CHECK(some(density, 3) == some(density, 3));
        CHECK(some(density, 3) != some(density, 4));
    }
}

// A patch that flies is sewn to a sheet by links of no length: buttons, M 11.3.
TEST_CASE("links: what they draw together stays so, and both give way alike", "[links][AT3]") {
    World world;
    const Range sheet = world.add(grid({.columns = 9, .rows = 9}), {.density = 0.2});
    const Range patch = world.add(grid({.columns = 3, .rows = 3, .width = 0.25, .height = 0.25},
                                       {.origin = {0.375, 0.375, 0}}),
                                  {.density = 1, .velocity = Points(9, Vec<double>{1, 0.5, 3})});
    world.constrain(linksOf(world), {.name = "links"});
    Lists both(2);
    for (int v = sheet.first; v < sheet.last; ++v) both[0].push_back(v);
    for (int v = patch.first; v < patch.last; ++v) both[1].push_back(v);
    const std::vector<int> sewn = linkStencils(both, world.rest, {.maxDistance = 1e-9});
    REQUIRE(sewn.size() == 2 * 9);
    world.constrain(restRows<Stretch>(sewn, world.rest), {.name = "seam", .order = 1});
    Solver<double> solver(world, {.schedule = {.substeps = 20, .iterations = 40}});
    const auto momentumOf = [&](Range range) {
        const Points v = solver.velocities();
        Vec<double> sum{};
        for (int i = range.first; i < range.last; ++i) sum += world.mass[i] * v[i];
        return sum;
    };
    const Vec<double> given = momentumOf(patch);
    double gap = 0;
    for (int frame = 0; frame < 24; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        for (std::size_t i = 0; i < sewn.size(); i += 2)
            gap = std::max(gap, length(x[sewn[i]] - x[sewn[i + 1]]));
    }
    const Vec<double> taken = momentumOf(sheet);
    note("part of its momentum that the patch gave to the sheet", length(taken) / length(given));
    CHECK(length(taken) > 0.3 * length(given));
    CHECK(report("gap of the seam, of the patch", gap / 0.25, 1e-3));
    CHECK(report("given less taken, of all",
                 length(given - taken - momentumOf(patch)) / length(given), 1e-12));
}

TEST_CASE("links: what is out of range is refused by name", "[links]") {
    const Points x(3);
    const Lists wrong{{0}, {3}}, right{{0}, {1}};
    CHECK_THROWS_WITH(linkStencils(wrong, x), "links: there is no vertex 3");
    CHECK_THROWS_WITH(linkStencils(right, x, {.density = 1.5}), "links: the density is 1.500000");
    CHECK_THROWS_WITH(linkStencils(right, x, {.maxDistance = -1}),
                      "links: the distance is -1.000000");
}
