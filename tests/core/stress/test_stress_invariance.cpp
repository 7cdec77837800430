// What a result must not depend on (validation D 6, 27, 28): units, place, frame rate, substep, the
// number of elements.
#include "tests/catch.h"
#include "tests/core/physics/cantilever.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/air/air.h>
#include <plait/numbers/finite.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81;

// Root mean square over vertices of the sheet's size.
double distance(const Points& a, const Points& b, double size = 1) {
    REQUIRE(allFinite(a));
    REQUIRE(allFinite(b));
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += dot(a[i] - b[i], a[i] - b[i]);
    return std::sqrt(squares / static_cast<double>(a.size())) / size;
}

// How a sheet of a metre and a tenth of a kilogram is told: in which units, where.
struct Units {
    double metre = 1, second = 1;
    Vec<double> origin{0, 0, 0};
};

// Held along its upper edge, let go from near horizontal, in wind; stiff enough not to crumple,
// which would amplify rounding ten thousand times in a second.
World windySheet(const Units& units) {
    const double m = units.metre, s = units.second;
    World world;
    const int n = 12;
    Shape shape = grid({.columns = n, .rows = n, .width = m, .height = m});
    std::vector<Vec<double>> start;
    for (const Vec<double>& p : shape.positions)
        start.push_back({p.x + units.origin.x, units.origin.y + 0.1 * m * std::sin(3 * p.y / m),
                         p.y + units.origin.z});
    const Range all = world.add(shape, {.density = 0.1 / (m * m), .start = start});
    world.pin(pointStencils({0, n}));
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g * m / (s * s), 0}});
    actAir(world, {.density = 1.2 / (m * m * m),
                   .wind = {.velocity = [=](double) { return Vec<double>{0, 0, 2 * m / s}; }}});
    world.constrain(linksOf(world), {.name = "stretch"});
    world.constrain(bendRows(world.complex, all, world.rest, 1e-3 * m * m / (s * s)),
                    {.name = "bend", .order = 1});
    return world;
}

// After a second of the first units, in metres.
template <class Real>
Points flown(const Units& units) {
    Solver<Real> solver(windySheet(units),
                        {.schedule = {.substeps = 30, .iterations = 1}, .timeScale = units.second});
    advance(solver, 24);
    Points x = solver.positions();
    for (Vec<double>& p : x) p = 1 / units.metre * (p - units.origin);
    return x;
}

// How far a compliant strip hangs over what it does at rest, m, for frames of ten substeps.
double extension(int framesPerSecond, Method method, int evaluations) {
    World world;
    world.add(grid({.columns = 3, .rows = 11, .width = 0.2}, {.up = {0, -1, 0}}));
    world.pin({0, 1, 2});
    world.act<Gravity>(GravityOptions{});
    world.constrain(linksOf(world, 1e-3), {.name = "stretch"});
    Solver<double> solver(
        world,
        {.method = method,
         .schedule = {.substeps = 10, .frameRate = {framesPerSecond, 1}, .iterations = evaluations},
         .damping = 0.3});
    advance(solver, 3 * framesPerSecond);
    REQUIRE(topSpeed(solver) < 1e-4);
    double lowest = 0;
    for (const Vec<double>& p : solver.positions()) lowest = std::min(lowest, p.y);
    return -lowest - 1;
}

}  // namespace

TEST_CASE("stress 27: a sheet told in other units, or far away", "[stress]") {
    const Points here = flown<float>({});
    note("float against double, of its size", distance(here, flown<double>({})));
    const std::pair<std::string, Units> others[] = {
        {"in mm", {.metre = 1e3}},
        {"in km", {.metre = 1e-3}},
        {"in mm and 1/60 s", {.metre = 1e3, .second = 60}},
        {"in km and h", {.metre = 1e-3, .second = 1 / 3600.0}},
        {"10 km away", {.origin = {1e4, 1e4, -1e4}}}};
    for (const auto& [name, units] : others)
        CHECK(report("a sheet " + name + ", difference of its size",
                     distance(flown<float>(units), here), 1e-4));
}

TEST_CASE("stress 28: frames as one likes, of substeps as long", "[stress]") {
    std::uint64_t hash = 0;
    for (const int rate : {24, 30, 60, 120}) {
        Solver<float> solver(
            windySheet({}),
            {.schedule = {.substeps = 1200 / rate, .frameRate = {rate, 1}, .iterations = 1}});
        advance(solver, rate / 2);
        if (rate == 24) hash = solver.hash();
        CHECK(solver.hash() == hash);
    }
}

TEST_CASE("stress 28: stiffness does not depend on the substep", "[stress]") {
    const auto change = [](Method method, int evaluations) {
        const double at24 = extension(24, method, evaluations);
        double worst = 0;
        for (const int rate : {60, 120})
            worst = std::max(worst, std::fabs(extension(rate, method, evaluations) / at24 - 1));
        return worst;
    };
    CHECK(report("24 to 120 frames a second, change of a strip's extension",
                 change(Method::xpbd, 16), 0.02));
    note("    before it converges, in 4 evaluations a substep", change(Method::xpbd, 4));
    const double nucleus = change(Method::nucleus, 16);
    note("    nucleus", nucleus);
    CHECK(nucleus > 0.5);
}

// H / W of Gamma = 10 is 1.066802 (A3).
namespace {

double droopError(int links, int substeps, bool held = false) {
    const Droop d = cantilever(10, links, {.substeps = substeps, .iterations = 1}, held);
    REQUIRE(d.rests);
    return std::fabs(d.drop / d.reach / 1.066802 - 1);
}

void checkDroop(int links, int substeps) {
    for (const bool held : {false, true})
        CHECK(report("cantilever of " + std::to_string(links) + " links" +
                         (held ? ", held, " : ", ") + std::to_string(substeps) +
                         " substeps a frame: error",
                     droopError(links, substeps, held), 0.03));
}

}  // namespace

// What a sweep a substep needs grows as the square of the elements, so the same work fails; also
// where lengths are held, since bending is swept.
TEST_CASE("stress 6: elements of a cantilever", "[stress]") {
    for (const int links : {8, 16, 32}) checkDroop(links, 200);
    const double missed = droopError(64, 200);
    note("cantilever of 64 links, 200 substeps a frame: error", missed);
    CHECK(missed > 0.1);
    note("    held", droopError(64, 200, true));
}

TEST_CASE("stress 6: what finer cantilevers need", "[stress][long]") {
    checkDroop(16, 50);
    checkDroop(64, 800);
    checkDroop(128, 3200);
}
