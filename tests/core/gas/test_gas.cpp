// The multiplier is the gauge pressure, and the pressure follows the volume by the gas's own law.
#include "gas_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/forces/gravity.h>
#include <plait/sets/constraint_set.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

double relative(double value, double expected) { return std::fabs(value / expected - 1); }

std::vector<Gas> everyGas(double volume) {
    return {{.amount = 120000 * volume, .reference = 2 * volume, .law = GasLaw::isothermal},
            {.amount = 60000 * volume,
             .law = GasLaw::isothermal},  // below what is outside, as the next but one
            {.amount = 500 * volume, .outside = 0},
            {.amount = 90000 * volume, .reference = 0.7 * volume, .law = GasLaw::adiabatic},
            {.amount = 300000 * volume, .reference = 2 * volume, .law = GasLaw::constantPressure}};
}

// By vertex: a third of its triangles', along their normals, m^2; the gradient of a volume.
std::vector<Vec<double>> areasOf(const Enclosure& enclosure, std::span<const Vec<double>> x) {
    std::vector<Vec<double>> areas(x.size());
    for (const auto& [a, b, c] : enclosure.triangles) {
        const Vec<double> third = 1.0 / 6 * cross(x[b] - x[a], x[c] - x[a]);
        for (const int v : {a, b, c}) areas[v] += third;
    }
    return areas;
}

SolverOptions steps(int substeps, int iterations = 1) {
    return {.schedule = {.substeps = substeps, .iterations = iterations}};
}

// Contacts take turns with the rest, eight times.
SolverOptions alternating(int substeps) {
    SolverOptions options = steps(substeps, 8);
    options.schedule.collisionPasses = 8;
    return options;
}

std::string refusal(const Gas& gas) {
    World world;
    const Enclosure enclosure = enclose(world, {addBall(world, 1)});
    try {
        holdGas(world, enclosure, gas, named("air"));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEMPLATE_TEST_CASE("gas: at rest the multiplier is the gauge pressure of every law", "[gas]", float,
                   double) {
    World world;
    const Range ball = addBall(world, 0.3);
    pinScaled(world, ball, {}, [](double) { return 1; });
    const Enclosure enclosure = enclose(world, {ball});
    const double inside = volume(enclosure, world.rest);
    const std::vector<Gas> gases = everyGas(inside);
    for (const Gas& gas : gases) holdGas(world, enclosure, gas, named("air"));
    Solver<TestType> solver(world, steps(3));
    solver.frame();
    const double now = volume(enclosure, solver.positions());
    double worst = 0;
    for (std::size_t i = 0; i < gases.size(); ++i) {
        const double expected = gases[i].gauge(now);
        worst = std::max(worst, relative(pressureOf(solver, static_cast<int>(i)), expected));
        REQUIRE((expected < 0) == (i == 1 || i == 3));
    }
    // In float positions are rounded, and 1 / h^2 is.
    REQUIRE(report("multiplier / h^2 against Gas::gauge", worst,
                   std::is_same_v<TestType, float> ? 1e-6 : 1e-13));
}

// A ball is pressed by what moves it: each law by its own exponent, to second order in a substep.
TEST_CASE("gas: pressure follows a volume that is pressed", "[gas]") {
    const auto error = [](int substeps, bool atRest) {
        World world;
        const Range ball = addBall(world, 0.3);
        pinScaled(world, ball, {}, [](double t) { return 1 - 0.2 * std::min(t, 1.0); });
        const Enclosure enclosure = enclose(world, {ball});
        const std::vector<Gas> gases = everyGas(volume(enclosure, world.rest));
        for (const Gas& gas : gases) holdGas(world, enclosure, gas, named("air"));
        Solver<double> solver(world, steps(substeps));
        for (int frame = 0; frame < (atRest ? 25 : 20); ++frame) solver.frame();
        const double now = volume(enclosure, solver.positions());
        double worst = 0;
        for (std::size_t i = 0; i < gases.size(); ++i)
            worst = std::max(
                worst, relative(pressureOf(solver, static_cast<int>(i)), gases[i].gauge(now)));
        return worst;
    };
    const double coarse = error(5, false), fine = error(10, false);
    note("gauge pressure while it is pressed, 5 substeps", coarse);
    note("the same, 10 substeps", fine);
    REQUIRE(coarse / fine > 3.7);
    REQUIRE(coarse / fine < 4.3);
    REQUIRE(report("gauge pressure once it is pressed", error(5, true), 1e-12));
}

// Breathing of a sphere whose vertices' masses are as their areas: M s'' = 3 V (p(s) - p0) with
// M = sum m r^2, so omega^2 = 9 V p0 exponent / M about rest.
TEST_CASE("gas: a sphere of gas breathes at its frequency, isothermal and adiabatic", "[gas]") {
    for (const bool adiabatic : {false, true}) {
        World world;
        const Range ball = addBall(world, 0.3);
        const Enclosure enclosure = enclose(world, {ball});
        const double inside = volume(enclosure, world.rest);
        const std::vector<Vec<double>> areas = areasOf(enclosure, world.rest);
        double inertia = 0;
        for (std::size_t v = 0; v < areas.size(); ++v) {
            world.mass[v] = 10 * length(areas[v]);
            inertia += world.mass[v] * dot(world.rest[v], world.rest[v]);
            world.velocity[v] = 1e-3 * world.rest[v];  // small beside the radius in a period
        }
        holdGas(world, enclosure,
                {.amount = 101325 * inside,
                 .reference = inside,
                 .law = adiabatic ? GasLaw::adiabatic : GasLaw::isothermal},
                named("air"));
        const double exponent = adiabatic ? 1.4 : 1;
        const double omega = std::sqrt(9 * inside * 101325 * exponent / inertia);
        const int perPeriod = 800;
        SolverOptions options = steps(1);
        // Of first order implicit Euler lengthens a period by (omega h)^2 / 2 ... 3e-5 here.
        options.schedule.frameRate = {static_cast<int>(std::lround(perPeriod * omega / (2 * pi))),
                                      1};
        Solver<double> solver(world, options);
        double last = 0, crossed = 0;
        for (int step = 1; step < perPeriod; ++step) {
            solver.frame();
            const double off = volume(enclosure, solver.positions()) - inside;
            if (last > 0 && off <= 0) {
                crossed = (step - 1 + last / (last - off)) * solver.substepLength();
                break;
            }
            last = off;
        }
        // Half a period.
        REQUIRE(report(adiabatic ? "breathing, adiabatic" : "breathing, isothermal",
                       relative(pi / crossed, omega), 2e-3));
    }
}

TEST_CASE("gas: constant pressure is p times the areas, of either sign, on caps too",
          "[gas][AW13]") {
    for (const double gauge : {700.0, -700.0})
        for (const Shape& shape : {sphere({.subdivisions = 2, .radius = 0.3}),
                                   tube({.segments = 12, .rings = 5, .radius = 0.2})}) {
            World world;
            const Enclosure enclosure = enclose(world, {world.add(shape)}, {.cap = true});
            holdGas(world, enclosure, {.amount = 101325 + gauge, .law = GasLaw::constantPressure},
                    named("pump"));
            SolverOptions options = steps(1);
            options.schedule.frameRate = {2400, 1};
            Solver<double> solver(world, options);
            solver.frame();
            const auto areas = areasOf(enclosure, world.rest);
            const auto velocity = solver.velocities();
            Vec<double> momentum{};
            double worst = 0;
            for (std::size_t v = 0; v < velocity.size(); ++v) {
                const Vec<double> expected =
                    solver.substepLength() * gauge / world.mass[v] * areas[v];
                worst = std::max(worst, length(velocity[v] - expected) / length(expected));
                momentum += world.mass[v] * velocity[v];
            }
            REQUIRE(length(momentum) < 1e-12);
            REQUIRE(report("velocity after a substep under a steady pressure", worst, 1e-11));
            REQUIRE(report("multiplier of a pump", relative(pressureOf(solver, 0), gauge), 1e-11));
        }
}

TEST_CASE("gas: a volume that is held stays through a fall", "[gas]") {
    World world;
    const Range ball = addBall(world, 0.3, 3, {0, 0.32, 0}, 0.5);
    addSprings(world, ball, 20);
    const Enclosure enclosure = enclose(world, {ball});
    const double inside = volume(enclosure, world.rest);
    holdVolume(world, enclosure, inside, {.name = "water", .order = 1});
    auto floor = restRows<PlaneContact>(pointStencils(ball), world.rest);
    for (auto& row : floor.rows) row = {{0, 0, 0}, {0, 1, 0}, 0};
    world.constrain(floor, named("floor"));
    world.act<Gravity>(GravityOptions{});
    Solver<float> solver(world, alternating(10));
    double worst = 0, lowest = 1;
    for (int frame = 0; frame < 24; ++frame) {
        solver.frame();
        const auto x = solver.positions();
        worst = std::max(worst, relative(volume(enclosure, x), inside));
        double top = 0;
        for (const Vec<double>& at : x) top = std::max(top, at.y);
        lowest = std::min(lowest, top);
    }
    note("height of a ball of water, flattest, m", lowest);
    REQUIRE(lowest < 0.5);
    REQUIRE(report("volume that is held, through a fall", worst, 1e-4));
}

// Springs: p = 2 sqrt(3) k (lambda - 1) / (R lambda^2) on a sphere (validation A9).
TEST_CASE("gas: volume against pressure is one curve, up and down", "[gas][AW13][AW14][FX6]") {
    constexpr double radius = 0.3, k = 100;
    World world;
    const Range ball = addBall(world, radius);
    addSprings(world, ball, k, 0.999);
    const Enclosure enclosure = enclose(world, {ball});
    const auto inside = volume(enclosure, world.rest);
    constexpr int stages = 6, rest = 12;  // of frames
    const auto stageAt = [](double t) {
        const double stage = std::floor(t * 24 / rest - 1e-9) + 1;
        return std::min(stage, 2 * stages - stage);
    };
    const auto gaugeAt = [=](double stage) {
        const double lambda = 1 + 0.05 * stage;
        return 2 * std::sqrt(3) * k * (lambda - 1) / (radius * lambda * lambda);
    };
    holdGas(
        world, enclosure,
        [=](double t) {
            return Gas{
                .amount = gaugeAt(stageAt(t)), .outside = 0, .law = GasLaw::constantPressure};
        },
        named("pump"));
    Solver<double> solver(world, steps(20, 2));
    std::vector<double> volumes;
    double worst = 0;
    for (int stage = 1; stage < 2 * stages; ++stage) {
        for (int frame = 0; frame < rest; ++frame) solver.frame();
        volumes.push_back(volume(enclosure, solver.positions()));
        const double lambda = std::cbrt(volumes.back() / inside);
        worst = std::max(worst, relative(lambda, 1 + 0.05 * std::min(stage, 2 * stages - stage)));
    }
    double apart = 0;
    for (int i = 0; i + 1 < stages; ++i) {
        REQUIRE(volumes[i + 1] > 1.1 * volumes[i]);
        apart = std::max(apart, relative(volumes[2 * stages - 2 - i], volumes[i]));
    }
    REQUIRE(report("stretch against that of the sphere of springs", worst, 0.02));
    REQUIRE(report("volume on the way down against the way up", apart, 1e-3));
}

TEST_CASE("gas: two balls share one gas", "[gas]") {
    constexpr double radius = 0.3, k = 100;
    World world;
    const Range pressed = addBall(world, radius), other = addBall(world, radius, 2, {2, 0, 0});
    addSprings(world, other, k, 0.999);
    pinScaled(world, pressed, {}, [](double t) { return 1 - 0.3 * std::min(t, 1.0); });
    const Enclosure both = enclose(world, {pressed, other});
    const double amount = 2 * volume(both, world.rest) * 80;
    holdGas(world, both, {.amount = amount, .outside = 0}, named("gas"));
    Solver<double> solver(world, steps(20, 2));
    for (int frame = 0; frame < 60; ++frame) solver.frame();
    const auto x = solver.positions();
    const double pressure = pressureOf(solver, 1);
    REQUIRE(
        report("p V of both against n R T", relative(pressure * volume(both, x), amount), 1e-4));
    const double lambda =
        std::cbrt(volume(enclose(world, {other}), x) / volume(enclose(world, {other}), world.rest));
    note("stretch of the ball that nobody presses", lambda);
    REQUIRE(lambda > 1.1);
    REQUIRE(
        report("pressure against what its springs bear",
               relative(pressure, 2 * std::sqrt(3) * k * (lambda - 1) / (radius * lambda * lambda)),
               0.03));
}

TEST_CASE("gas: what is squeezed between plates keeps p V", "[gas][figures]") {
    World world;
    const Range ball = addBall(world, 0.3, 3);
    addSprings(world, ball, 300, 0.99);
    const Enclosure enclosure = enclose(world, {ball});
    const double amount = 1200 * volume(enclosure, world.rest);
    holdGas(world, enclosure, {.amount = amount, .outside = 1000}, named("gas"));
    for (const double side : {-1.0, 1.0}) {
        auto plate = restRows<PlaneContact>(pointStencils(ball), world.rest);
        plate.animate = [side](double t, std::span<PlaneContact::Row<double>> rows) {
            const double height = 0.35 - 0.2 * std::min(t, 1.0);
            for (auto& row : rows) row = {{0, side * height, 0}, {0, -side, 0}, 0};
        };
        plate.animate(0, plate.rows);
        world.constrain(plate, named("plate"));
    }
    Solver<float> solver(world, alternating(20));
    double first = 0;
    for (int frame = 0; frame < 48; ++frame) {
        solver.frame();
        if (frame == 0) first = pressureOf(solver, 1);
    }
    const double squeezed = pressureOf(solver, 1), now = volume(enclosure, solver.positions());
    note("gauge pressure before, Pa", first);
    note("gauge pressure between the plates, Pa", squeezed);
    REQUIRE(squeezed > first + 30);
    REQUIRE(report("p V between plates", relative((squeezed + 1000) * now, amount), 1e-4));
    const auto pushOf = [&](int set) {
        const auto& plate =
            dynamic_cast<const ConstraintSet<PlaneContact, float>&>(solver.set(set));
        double sum = 0;
        for (int v = 0; v < ball.size(); ++v) sum += double(plate.multiplier(v));
        return sum;
    };
    REQUIRE(pushOf(2) > 0);
    REQUIRE(report("push of one plate against that of the other", relative(pushOf(2), pushOf(3)),
                   0.02));
}

TEMPLATE_TEST_CASE("gas: the same bits for any threads and lanes, and from any frame on",
                   "[gas][determinism][threads]", float, double) {
    World world;
    const Range ball = addBall(world, 0.3, 4), small = addBall(world, 0.1, 2, {0.2, 1, 0});
    addSprings(world, ball, 100, 0.2);
    addSprings(world, small, 100);
    const Enclosure enclosure = enclose(world, {ball, small});
    const double inside = volume(enclosure, world.rest);
    SetOptions air = named("air");
    air.damping = 0.1;
    holdGas(
        world, enclosure,
        [inside](double t) { return Gas{.amount = inside * (101325 + 3000 * t)}; }, air);
    holdVolume(world, enclose(world, {small}), 1.05 * volume(enclose(world, {small}), world.rest),
               named("water"));
    const auto shared = std::make_shared<const World>(world);
    const auto made = [&](int threads, KernelChoice kernels) {
        SolverOptions options = steps(4, 2);
        options.threads = threads;
        options.kernels = kernels;
        return std::make_unique<Solver<TestType>>(shared, options);
    };
    constexpr int frames = 3;
    const auto whole = made(1, bestKernels());
    for (int frame = 0; frame < frames; ++frame) {
        const auto fresh = made(1, bestKernels());
        fresh->restore(whole->state(), whole->evaluations());
        fresh->frame();
        whole->frame();
        REQUIRE(fresh->hash() == whole->hash());
    }
    const auto other = [&](int threads, KernelChoice kernels) {
        const auto solver = made(threads, kernels);
        for (int frame = 0; frame < frames; ++frame) solver->frame();
        return solver->hash();
    };
    for (const int threads : {2, 3, 8}) REQUIRE(other(threads, bestKernels()) == whole->hash());
    for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
        for (const int lanes : {1, 4, 8, 16})
            if (available({isa, lanes})) REQUIRE(other(2, {isa, lanes}) == whole->hash());
}

TEST_CASE("gas: numbers out of range, and methods that cannot see it, are refused", "[gas]") {
    REQUIRE(refusal({.amount = 1}).empty());
    REQUIRE(refusal({.amount = -1}) == "air: the amount of gas is -1.000000");
    REQUIRE(refusal({.amount = 1, .reference = 0}) ==
            "air: the gas's reference volume is 0.000000");
    REQUIRE(refusal({.amount = 1, .outside = -5}) == "air: the pressure outside is -5.000000");
    REQUIRE(refusal({.amount = 1, .exponent = 1}) == "air: the gas's exponent is 1.000000");
    World world;
    const Range ball = addBall(world, 1);
    const Enclosure enclosure = enclose(world, {ball});
    REQUIRE_THROWS_AS(holdVolume(world, enclosure, std::nan(""), named("water")),
                      std::invalid_argument);
    holdVolume(world, enclosure, 1, named("water"));
    SolverOptions options = steps(1);
    options.method = Method::newton;
    REQUIRE_THROWS_AS(Solver<double>(world, options), std::invalid_argument);
    // Gas that is out of range later stops that frame, with everything put back.
    World leaking;
    const Enclosure leaky = enclose(leaking, {addBall(leaking, 1)});
    holdGas(leaking, leaky, [](double t) { return Gas{.amount = 0.05 - t}; }, named("air"));
    Solver<double> solver(leaking, steps(1));
    solver.frame();
    const auto hash = solver.hash();
    REQUIRE_THROWS_AS(solver.frame(), std::invalid_argument);
    REQUIRE(solver.hash() == hash);
}
