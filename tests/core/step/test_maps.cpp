// Maps: what is painted on a mesh multiplies what it is made with.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/maps.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

const auto& plain = [](const Vec<double>&) { return 1.0; };

// A strip of 1 m by 0.2 m whose threads are springs, hung by its upper edge: how far its lower edge
// has gone, at rest. `stiffness` is that of a thread of 1 m, N, a metre of width.
double sag(int n, const std::function<double(const Vec<double>&)>& texture, long* work = nullptr) {
    World world;
    const int across = n / 5 + 1;
    const Range strip = world.add(
        grid({.columns = across, .rows = n + 1, .width = 0.2, .height = 1}, {.up = {0, -1, 0}}),
        {.density = 0.2});
    std::vector<int> upper;
    for (int v = 0; v < across; ++v) upper.push_back(v);
    world.pin(upper);
    std::vector<int> ids;
    for (int v = 0; v + across < strip.size(); ++v) ids.insert(ids.end(), {v, v + across});
    // Of the two at the border half as much, as they stand for half the width.
    Rows<Stretch> threads = restRows<Stretch>(ids, world.rest);
    for (int i = 0; i < threads.size(); ++i) {
        const int column = i % across;
        const double width = 0.2 / (across - 1) * (column == 0 || column == across - 1 ? 0.5 : 1);
        auto& row = threads.rows[static_cast<std::size_t>(i)];
        row.compliance = row.compression = 1 / (20 * width * n);
    }
    multiplyStiffness(threads, texturedMap(world, "stiffness", strip, texture));
    world.constrain(threads, {.name = "threads"});
    world.act<Gravity>(GravityOptions{});
    SolverOptions options;
    options.schedule = {.substeps = 4, .iterations = 4 * n};
    options.damping = 0.1;
    Solver<double> solver(world, options);
    for (int frame = 0; frame < 120; ++frame) solver.frame();
    if (work) *work = solver.evaluations();
    double lowest = 0;  // m below 0
    for (const Vec<double>& x : solver.positions()) lowest = std::max(lowest, -x.y);
    return lowest - 1;
}

}  // namespace

// A texture says the same on any mesh, and what is painted is of one.
TEST_CASE("maps: a texture outlives its mesh, and what is painted is refused on another",
          "[maps][UN8]") {
    const auto texture = [](const Vec<double>& x) { return 0.3 + 0.6 * std::fabs(x.y); };
    const double coarse = sag(10, texture), fine = sag(20, texture), finer = sag(40, texture),
                 even = sag(20, plain);
    note("sag with an even stiffness, m", even);
    note("sag by a texture, 10, 20, 40 cells: m", coarse);
    note("", fine);
    note("", finer);
    CHECK(fine > 1.2 * even);
    // Of the first order in the cells: what hangs at a vertex is half a cell's too much.
    CHECK(std::fabs(finer - fine) < 0.6 * std::fabs(fine - coarse));
    CHECK(std::fabs(finer - fine) < 0.03 * fine);

    World world;
    const Range sheet = world.add(grid({.columns = 4, .rows = 4}));
    CHECK_THROWS_WITH(paintedMap(world, "stiffness", sheet, std::vector<double>(15, 1.0)),
                      "stiffness: a map of 15 vertices for a mesh of 16");
    CHECK_THROWS_AS(paintedMap(world, "stiffness", sheet, std::vector<double>(16, -0.1)),
                    std::invalid_argument);
}

TEST_CASE("maps: they multiply: 0 and no base do nothing, 1 is as before, above 1 is warned of",
          "[maps][UN7][FH15]") {
    World world;
    const Range sheet = world.add(grid({.columns = 3, .rows = 3}));
    std::vector<double> painted(9, 1.0);
    painted[4] = 0;
    const Map map = paintedMap(world, "shear", sheet, painted);
    CHECK(world.warnings.empty());
    const Rows<Stretch> links =
        restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest, 0.01);
    Rows<Stretch> set = links;
    multiplyStiffness(set, map);
    REQUIRE(set.size() == links.size());
    for (int i = 0; i < set.size(); ++i) {
        const bool half = set.ids[2 * i] == 4 || set.ids[2 * i + 1] == 4;
        CHECK(set.rows[i].compliance == Approx(half ? 0.02 : 0.01).epsilon(1e-15));
        CHECK(set.rows[i].rest == links.rows[i].rest);
    }
    multiplyStiffness(set, paintedMap(world, "shear", sheet, std::vector<double>(9, 0.0)));
    CHECK(set.size() == 0);
    Rows<Stretch> loose = links;
    for (auto& row : loose.rows) row.compliance = row.compression = infinity;
    multiplyStiffness(loose, map);
    CHECK(loose.size() == 0);
    Rows<Stretch> rigid = restRows<Stretch>(links.ids, world.rest);
    multiplyStiffness(rigid, map);
    for (const auto& row : rigid.rows) CHECK(row.compliance == 0);

    multiplyStiffness(loose = links,
                      paintedMap(world, "shear", sheet, std::vector<double>(9, 3.0)));
    CHECK(loose.rows[0].compliance == Approx(0.01 / 3).epsilon(1e-15));
    REQUIRE(world.warnings.size() == 1);
    CHECK(world.warnings[0].find("shear") != std::string::npos);

    // What is painted costs what it did.
    long before = 0, after = 0;
    sag(10, plain, &before);
    sag(10, [](const Vec<double>&) { return 0.5; }, &after);
    CHECK(before == after);
}

// A sheet begins flat and free; by its rest shape it has a bump, out or in.
TEST_CASE("maps: a rest shape that is displaced wrinkles the way the map says", "[maps][DC18]") {
    constexpr int n = 9;
    for (const double sign : {1.0, -1.0}) {
        const Shape flat = grid({.columns = n, .rows = n});
        std::vector<double> along(n * n, 0.0);
        for (int v = 0; v < n * n; ++v) {
            const Vec<double> from =
                flat.positions[static_cast<std::size_t>(v)] - flat.positions[n * n / 2];
            along[static_cast<std::size_t>(v)] = sign * 0.05 * std::exp(-20 * dot(from, from));
        }
        const Shape bump = displaced(flat, along);
        for (int v = 0; v < n * n; ++v)
            CHECK(length(bump.positions[static_cast<std::size_t>(v)] -
                         flat.positions[static_cast<std::size_t>(v)]) ==
                  Approx(std::fabs(along[static_cast<std::size_t>(v)])).margin(1e-15));
        World world;
        const Range sheet = world.add(bump, {.density = 0.2, .start = flat.positions});
        // Rubber, so that it can leave the plane that it begins in.
        world.constrain(linksOf(world, 0.01), {.name = "links"});
        world.constrain(bendRows(world.complex, sheet, world.rest, 0.01),
                        {.name = "bend", .order = 1});
        SolverOptions options;
        options.schedule = {.substeps = 10, .iterations = 20};
        options.damping = 0.1;
        Solver<double> solver(world, options);
        for (int frame = 0; frame < 180; ++frame) solver.frame();
        const Points x = solver.positions();
        const auto height = [&](const Points& at) {
            const Vec<double> middle = at[n * n / 2],
                              corners = 0.25 * (at[0] + at[n - 1] + at[n * n - n] + at[n * n - 1]);
            const Vec<double> normal = cross(at[n - 1] - at[0], at[n * n - n] - at[0]);
            return dot(middle - corners, normal) / length(normal);
        };
        const double is = height(x), meant = height(bump.positions);
        note("height of the bump, m", is);
        CHECK(report("height of the bump, off", std::fabs(is / meant - 1), 1e-4));
    }
    CHECK_THROWS_AS(displaced(grid({.columns = 2, .rows = 2}), std::vector<double>(3)),
                    std::invalid_argument);
}
