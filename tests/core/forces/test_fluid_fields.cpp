// A fluid stood for by a field of acceleration and drag, through the whole solver.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/air/air.h>
#include <plait/forces/field.h>
#include <plait/measure/momentum.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double sigma = 0.2;  // kg/m^2

// A sheet that hangs together and is held by nothing, in a field and then in still air of this
// drag.
World adrift(double drag, const Vec<double>& field = {}, AirForm form = AirForm::legacy) {
    World world;
    world.act<Field>(
        FieldOptions{.acceleration = [field](const Vec<double>&, double) { return field; }});
    world.add(grid({.columns = 7, .rows = 6}, {.up = {0, 0, -1}}), {.density = sigma});
    world.constrain(linksOf(world), {.name = "links"});
    if (drag > 0)
        world.act<Air>(AirOptions{.form = form, .density = 1, .drag = drag, .tangentialDrag = 1});
    return world;
}

Vec<double> meanVelocity(const World& world, const Solver<double>& solver) {
    double mass = 0;
    for (const double m : world.mass) mass += m;
    return 1 / mass * momentum(world.mass, solver.velocities());
}

}  // namespace

// Speed a sigma / c of the field's own, where drag c v balances a.
TEST_CASE("fluid fields: with drag what drifts goes as fast as the field, without ever faster",
          "[air][forces][AW16]") {
    const Vec<double> a{2, 1, -0.5};
    for (const double drag : {5.0, 20.0, 0.0}) {
        const World world = adrift(drag, a);
        Solver<double> solver(world, stepping(240));
        advance(solver, 240);
        const Vec<double> one = meanVelocity(world, solver);
        advance(solver, 240);
        const Vec<double> two = meanVelocity(world, solver);
        if (drag > 0) {
            CHECK(report("velocity after 1 s, of the field's",
                         length(one - sigma / drag * a) / length(sigma / drag * a), 1e-9));
            CHECK(report("after 2 s", length(two - sigma / drag * a) / length(sigma / drag * a),
                         1e-9));
        } else {
            CHECK(report("velocity after 1 s without drag, m/s", length(one - a), 1e-9));
            CHECK(report("after 2 s", length(two - 2 * a), 1e-9));
        }
    }
}

// Under water things hardly sink: gravity is left out, drag is not.
TEST_CASE("fluid fields: without gravity nothing sinks, with it all does", "[air][forces][AW17]") {
    for (const AirForm form : {AirForm::legacy, AirForm::physical})
        for (const bool weighs : {false, true}) {
            World world = adrift(10, {}, form);
            for (std::size_t v = 0; v < world.velocity.size(); ++v)
                world.velocity[v] = {0.3, 0, 0.1 * std::sin(3.0 * static_cast<double>(v))};
            if (weighs) world.act<Gravity>(GravityOptions{.acceleration = {0, -9.81, 0}});
            Solver<double> solver(world, stepping(240));
            const auto height = [&] {
                double sum = 0, mass = 0;
                const Points x = solver.positions();
                for (std::size_t v = 0; v < x.size(); ++v)
                    sum += world.mass[v] * x[v].y, mass += world.mass[v];
                return sum / mass;
            };
            const double before = height(), speed = meanVelocity(world, solver).x;
            advance(solver, 240);
            if (weighs)
                CHECK(height() < before - 0.1);
            else
                CHECK(report("sunk in a second, m", std::fabs(height() - before), 1e-12));
            CHECK(std::fabs(meanVelocity(world, solver).x) < 0.9 * speed);
        }
}
