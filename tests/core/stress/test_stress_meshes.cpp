// Meshes that no one would draw, and some export (validation D 31, 32): twins and orphans among
// vertices, needles, hubs of valence 50, corners of valence 3. Numbers that make no sense are
// refused in test_failures.cpp and test_solver.cpp.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/air/air.h>
#include <plait/constraints/constants.h>
#include <plait/numbers/finite.h>
#include <plait/sheets/strands/strand_set.h>

#include <cmath>
#include <limits>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

enum class Links { swept, strands };

// Every kind that a sheet can have, in moving air, held by its first vertices.
World clothOf(const Shape& shape, int pins, Links how = Links::swept) {
    World world;
    const Range all = world.add(shape, {.density = 0.2});
    world.pin(pointStencils({0, pins}));
    world.act<Gravity>(GravityOptions{});
    actAir(world, {.wind = {.velocity = [](double) { return Vec<double>{0, 0, 2}; }}});
    if (how == Links::strands)
        strand(world, linksOf(world), {.name = "stretch", .order = 2});
    else
        world.constrain(linksOf(world), {.name = "stretch", .order = 2});
    world.constrain(restRows<Shear>(triangleStencils(world.complex, all), world.rest, 1e-3),
                    {.name = "shear"});
    world.constrain(bendRows(world.complex, all, world.rest, 1e-4), {.name = "bend", .order = 1});
    return world;
}

// 64 sweeps in 1/60 s.
const SolverOptions budget{
    .schedule = {.substeps = 32, .frameRate = {.frames = 60}, .iterations = 1}};

double largestStrain(const World& world) {
    Solver<float> solver(world, budget);
    const Rows<Stretch> links = linksOf(world);
    double most = 0;
    for (int frame = 0; frame < 120; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        REQUIRE(allFinite(x));
        for (const double e : strainsOf(links, x)) most = std::max(most, std::fabs(e));
    }
    return most;
}

constexpr Frame down{.across = {1, 0, 0}, .up = {0, -1, 0}};

std::vector<std::array<int, 3>> trianglesOf(const SimplicialComplex& complex) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < complex.count(2); ++t) triangles.push_back(complex.triangle(t));
    return triangles;
}

// Each triangle of a grid cut in three: corners of valence 3.
Shape cutInThree(const Shape& whole) {
    Shape cut = whole;
    Simplices simplices;
    for (const auto& [a, b, c] : trianglesOf(whole.complex)) {
        const int middle = static_cast<int>(cut.positions.size());
        cut.positions.push_back(1.0 / 3 *
                                (whole.positions[a] + whole.positions[b] + whole.positions[c]));
        for (const auto& corner :
             {std::array{a, b, middle}, std::array{b, c, middle}, std::array{c, a, middle}})
            simplices.triangles.push_back(corner);
    }
    cut.complex = SimplicialComplex(static_cast<int>(cut.positions.size()), simplices);
    return cut;
}

// A hub and its rim.
Shape wheel(int spokes) {
    Shape shape{{}, {{0, 0, 0}}};
    Simplices simplices;
    for (int i = 0; i < spokes; ++i) {
        const double a = 2 * pi * i / spokes;
        shape.positions.push_back({std::cos(a), std::sin(a), 0});
        simplices.triangles.push_back({0, 1 + i, 1 + (i + 1) % spokes});
    }
    shape.complex = SimplicialComplex(spokes + 1, simplices);
    return shape;
}

}  // namespace

TEST_CASE("stress 31: twins and orphans among vertices, and rows of no number", "[stress]") {
    Shape torn = grid({.columns = 5, .rows = 5}, down);
    for (const int twin : {7, 12}) torn.positions[twin] = torn.positions[8];
    torn.positions[23] = torn.positions[24];
    Simplices simplices;
    simplices.triangles = trianglesOf(torn.complex);
    torn.complex = SimplicialComplex(28, simplices);
    torn.positions.resize(28, {5, 5, 5});  // three in no triangle
    World world = clothOf(torn, 5);
    for (int v = 25; v < 28; ++v) world.mass[static_cast<std::size_t>(v)] = 1;
    Solver<float> solver(world, budget);
    advance(solver, 60);
    const Points x = solver.positions();
    CHECK(report("twins: distance after 1 s, m", length(x[7] - x[8]), 1e-4));
    CHECK(topSpeed(solver) < 20);  // of the orphans
    const double h = solver.substepLength(), n = 60 * 32;
    CHECK(report("an orphan falls freely, m",
                 std::fabs(x[27].y - 5 + 9.81 * h * h * n * (n + 1) / 2), 5e-5));
    REQUIRE(allFinite(x));

    for (const Stretch::Row<double>& row :
         {Stretch::Row<double>{notANumber, 0, 0}, {1, notANumber, 0}, {1, 0, notANumber}})
        for (const bool strand : {false, true}) {
            World wrong;
            wrong.add(chain({}));
            const Rows<Stretch> rows{{0, 1}, {row}, {}, {}};
            if (strand)
                plait::strand(wrong, rows, {.name = "thread"});
            else
                wrong.constrain(rows, {.name = "thread"});
            CHECK_THROWS_WITH(Solver<float>(wrong, {}), "thread: a row holds no number");
        }
}

TEST_CASE("stress 32: needles, hubs and corners of valence 3", "[stress]") {
    const auto check = [](const std::string& name, const World& world) {
        CHECK(report(name + ": largest strain in 2 s", largestStrain(world), 0.05));
    };
    check("needles of 1 m by 1 mm, hung by an end",
          clothOf(grid({.columns = 21, .rows = 2, .width = 0.02}, down), 21));
    const Shape across = grid({.columns = 2, .rows = 31, .height = 0.03}, down);
    check("needles hung by a side, in strands", clothOf(across, 2, Links::strands));
    // g h^2 N^2 / 2 (A1), where lengths are in mm.
    const double missed = largestStrain(clothOf(across, 2));
    note("needles hung by a side, swept, missed", missed);
    CHECK(missed > 0.05);
    check("corners of valence 3", clothOf(cutInThree(grid({.columns = 7, .rows = 7}, down)), 7));
    World hung = clothOf(wheel(50), 0);
    hung.pin({1});
    check("a hub of valence 50, hung by its rim", hung);
    check("a hub of valence 50, held", clothOf(wheel(50), 1));
}
