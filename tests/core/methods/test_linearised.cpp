// All constraints at once, made linear: what Stam 2009, section 5, tried and gave up.
#include "spring.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

double largestStrain(const Rows<Stretch>& links, const Points& x) {
    double worst = 0;
    for (const double s : strainsOf(links, x)) worst = std::max(worst, std::fabs(s));
    return worst;
}

// A zigzag of rigid links that turns about its pin by `turn` radians in the one substep taken, as
// the prediction has it: the largest strain after the substep over that of the prediction.
double leftOf(double turn) {
    Points at;
    for (int i = 0; i <= 8; ++i) at.push_back({0.8 * i, i % 2 ? 0.6 : 0.0, 0});
    World world = linkedPoints(at, std::vector<double>(at.size(), 1.0));
    for (std::size_t i = 0; i < at.size(); ++i)
        world.velocity[i] = turn * Vec<double>{-at[i].y, at[i].x, 0};
    Solver<double> solver(world, steppingBy(1, Method::linearised));
    solver.frame();
    return largestStrain(linksOf(world), solver.positions()) / (std::sqrt(1 + turn * turn) - 1);
}

}  // namespace

TEST_CASE("linearised: one constraint is met exactly and keeps momentum", "[linearised][IN7]") {
    World world = loosePoints({{0, 0, 0}, {1, 0, 0}});
    world.mass = {1, 3};
    world.velocity = {{0.3, -2, 1}, {-0.1, 4, 0.5}};
    world.constrain(restRows<Stretch>({0, 1}, world.rest), {.name = "link"});
    Solver<double> solver(world, steppingBy(0.5, Method::linearised));
    const Vec<double> before = momentum(world.mass, world.velocity);
    solver.frame();
    const auto x = solver.positions();
    CHECK(report("length of the link, from 1", std::fabs(length(x[1] - x[0]) - 1), 1e-15));
    const Vec<double> lost = momentum(world.mass, solver.velocities()) - before;
    CHECK(report("its momentum", length(lost) / length(before), 1e-15));
}

TEST_CASE("linearised: it works for small steps and makes things worse at large turns",
          "[linearised][IN8]") {
    // What is left is of second order in what the prediction leaves.
    CHECK(report("strain left of a turn of 0.01", leftOf(0.01), 1e-4));
    CHECK(report("strain left of a turn of 0.1", leftOf(0.1), 1e-2));
    CHECK(leftOf(0.1) / leftOf(0.01) == Approx(100).epsilon(0.02));
    for (const double turn : {2.0, 3.0, 5.0}) {
        note("strain left of a turn of " + std::to_string(turn), leftOf(turn));
        CHECK(leftOf(turn) > 1.1);
    }
}

TEST_CASE("linearised: a compliance is that of XPBD, solved as a whole", "[linearised]") {
    const auto ends = [](Method method, int iterations) {
        World world = plumbLine({.links = 12, .length = 0.1});
        world.constrain(linksOf(world, 1e-4), {.name = "links"});
        SolverOptions options = steppingBy(0.01, method);
        options.schedule.iterations = iterations;
        Solver<double> solver(world, options);
        solver.frame();  // along a line, where nothing turns
        return solver.positions();
    };
    const Points x = ends(Method::linearised, 1), y = ends(Method::xpbd, 4000);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, length(x[i] - y[i]));
    CHECK(length(x[12] - Vec<double>{0, -1.2, 0}) > 5e-4);
    CHECK(report("distance from 4000 sweeps of XPBD", worst, 1e-12));
}

TEST_CASE("linearised: where constraints contradict each other it halves the error",
          "[linearised]") {
    World world = loosePoints({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    world.pin({0, 2});
    Rows<Stretch> links = linksOf(world);
    links = restRows<Stretch>({0, 1, 1, 2}, world.rest);
    for (auto& row : links.rows) row.rest = 0.7;
    world.start[1] = {1.2, 0, 0};
    world.constrain(links, {.name = "short links"});
    Solver<double> solver(world, steppingBy(0.1, Method::linearised));
    solver.frame();
    CHECK(report("the middle, from half way", length(solver.positions()[1] - Vec<double>{1, 0, 0}),
                 1e-14));
}

TEST_CASE("linearised: a contact pushes and does not pull", "[linearised]") {
    World world = loosePoints({{0, 0.5, 0}, {1, 2, 0}});
    world.velocity = {{0, -4, 0}, {0, -4, 0}};
    auto floor = restRows<PlaneContact>({0, 1}, world.rest);
    for (auto& row : floor.rows) row = {{0, 0, 0}, {0, 1, 0}, 0};
    world.constrain(floor, {.name = "floor"});
    Solver<double> solver(world, steppingBy(0.25, Method::linearised));
    solver.frame();
    CHECK(solver.positions()[0].y == Approx(0).margin(1e-15));
    CHECK(solver.positions()[1].y == 1);
}
