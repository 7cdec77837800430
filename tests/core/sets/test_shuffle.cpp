// Rows in an order by chance.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/sets/shuffle.h>

#include <map>

using namespace plait;
using namespace plait::test;

namespace {

// A sheet whose links are told apart by their rest lengths, none of which fits.
World sheet() {
    World world;
    world.add(grid({.columns = 9, .rows = 9}));
    world.pin({0, 8});
    world.act<Gravity>(GravityOptions{});
    return world;
}

Rows<Stretch> told(const World& world) {
    Rows<Stretch> links = linksOf(world);
    for (int i = 0; i < links.size(); ++i)
        links.rows[static_cast<std::size_t>(i)].rest *= 0.9 + 0.2 * i / links.size();
    return links;
}

std::map<std::array<int, 2>, double> asMap(const Rows<Stretch>& links) {
    std::map<std::array<int, 2>, double> map;
    for (std::size_t i = 0; i < links.rows.size(); ++i)
        map[{links.ids[2 * i], links.ids[2 * i + 1]}] = links.rows[i].rest;
    return map;
}

Points run(const Rows<Stretch>& links) {
    World world = sheet();
    world.constrain(links, {.name = "links"});
    Solver<float> solver(world, {.schedule = {.substeps = 4, .iterations = 2}});
    advance(solver, 24);
    return solver.positions();
}

}  // namespace

TEST_CASE("shuffle: the same rows in another order, the same by its seed", "[shuffle][PD2]") {
    const World world = sheet();
    const Rows<Stretch> links = told(world);
    const Rows<Stretch> one = shuffled(links, 1), again = shuffled(links, 1),
                        other = shuffled(links, 2);
    CHECK(asMap(one) == asMap(links));
    CHECK(one.ids == again.ids);
    CHECK(one.ids != links.ids);
    CHECK(one.ids != other.ids);
    // Of 8 rows each is about as often in each place.
    Rows<Stretch> few = links;
    few.rows.resize(8), few.ids.resize(16);
    std::array<int, 8> first{};
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        for (int i = 0; i < 8; ++i)
            if (shuffled(few, seed).rows[0].rest == few.rows[static_cast<std::size_t>(i)].rest)
                ++first[static_cast<std::size_t>(i)];
    for (const int count : first) CHECK(std::abs(count - 500) < 4 * 21);  // sigma is 20.9
    // Order matters to what is not solved, and is no chance once it is told.
    CHECK(run(one) == run(again));
    CHECK(run(one) != run(other));
}

TEST_CASE("shuffle: colours and what moves go with their rows", "[shuffle][PD2]") {
    const World world = sheet();
    Rows<Stretch> links = told(world);
    for (int i = 0; i < links.size(); ++i) links.colors.push_back(i);
    links.animate = [](double t, std::span<Stretch::Row<double>> rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].rest = t + static_cast<double>(i);
    };
    Rows<Stretch> order = shuffled(links, 3);
    std::vector<Stretch::Row<double>> rows = links.rows;
    links.animate(0.25, rows);
    order.animate(0.25, order.rows);
    for (std::size_t i = 0; i < order.rows.size(); ++i) {
        const auto was = static_cast<std::size_t>(order.colors[i]);
        CHECK(order.ids[2 * i] == links.ids[2 * was]);
        CHECK(order.rows[i].rest == rows[was].rest);
    }
}
