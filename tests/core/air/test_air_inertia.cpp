// The inertia of the air round a sheet that turns: what it takes, and that a free sheet and its air
// never gain energy.
#include "air_run.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/sets/constraint_set.h>

using namespace plait;
using namespace plait::test;

namespace {

// Nothing but inertia.
const AirOptions still{.density = 0, .addedMass = 0.5};

// J, of a vertex of mass m (kg) with its share of the air: (w I - q q^T)^-1 = m I + m^2 q q^T / (1
// - m q^2).
double energyOf(double m, const Vec<double>& v, const Vec<double>& q) {
    const double along = m * dot(q, v);
    return (m * dot(v, v) + along * along / (1 - m * dot(q, q))) / 2;
}

template <class Real>
constexpr double rounding = std::is_same_v<Real, float> ? 0x1p-24 : 0x1p-53;

// A square metre, free, that turns about an axis in its plane and bends.
World tumbling() {
    World world;
    Shape shape = grid({.columns = 12, .rows = 12});
    Points velocity;
    for (const Vec<double>& x : shape.positions)
        velocity.push_back({0.3, 0, 6 * (x.y - 0.5) + 2 * std::sin(6 * x.x) * std::cos(5 * x.y)});
    world.add(shape, {.density = sigma, .velocity = velocity});
    world.constrain(linksOf(world), {.name = "links"});
    actAir(world, still);
    return world;
}

// How much energy of sheet and air a substep may add, J. Its links take the step d from x1 to x'
// with d.M(x' - y) = sum lambda J d, y the prediction, and |d|^2_M = |y - x1|^2_M - |x' - y|^2_M +
// 2 sum lambda J d. J d, wherever J was evaluated between x1 and x', differs from C(x') - C(x1) by
// no more than the second order of a length, d^2 over it. Air adds nothing: what turning brings it,
// it takes.
double allowance(const ConstraintSet<Stretch, double>& links, const Rows<Stretch>& rows,
                 const Points& from, const Points& to, double h) {
    double sum = 0;
    for (int i = 0; i < rows.size(); ++i) {
        const int a = rows.ids[2 * i], b = rows.ids[2 * i + 1];
        const Vec<double> before = from[b] - from[a], after = to[b] - to[a], d = after - before;
        const double rest = rows.rows[i].rest;
        sum += std::fabs(links.multiplier(i)) *
               (std::fabs(length(after) - length(before)) + dot(d, d) / rest);
    }
    return sum / (h * h);
}

}  // namespace

TEMPLATE_TEST_CASE("Inertia of air: what turning brings it, it takes along the normal", "[air]",
                   double, float) {
    Run<TestType> run(crumpled(), still);
    run.prepare();
    Random random(2);
    for (int trial = 0; trial < 20; ++trial) {
        const State<TestType> before = run.state;
        for (int i = 0; i < run.state.count(); ++i) {
            run.state.particles[i].d = narrowed<TestType>(random.point(0.1));
            run.state.velocity[i].v = narrowed<TestType>(random.point(10));
        }
        const State<TestType> turned = run.state;
        run.prepare();
        int taken = 0, left = 0;
        double gained = 0, aside = 0;
        for (int i = 0; i < run.state.count(); ++i) {
            const Vec<double> v = widened(turned.velocity[i].v),
                              is = widened(run.state.velocity[i].v);
            const Vec<double> from = widened(before.airAt(i)), q = widened(run.state.airAt(i));
            const double was2 = std::pow(dot(from, v), 2), now2 = std::pow(dot(q, v), 2);
            if (now2 <= was2) {
                ++left;
                REQUIRE(is == v);
                continue;
            }
            ++taken;
            const double m = 1 / double(run.state.particles[i].w), start = energyOf(m, v, from);
            gained = std::max(gained, std::fabs(energyOf(m, is, q) / start - 1));
            aside = std::max(aside, length(cross(is - v, q)) / (length(q) * length(v)));
            REQUIRE(dot(is, q) * dot(v, q) >= 0);
        }
        REQUIRE(taken > 20);
        REQUIRE(left > 20);
        // Light vertices carry 400 times their mass of air, and m a^2 / (m + a) cancels as much.
        REQUIRE(report("energy of sheet and air - 1", gained, 4000 * rounding<TestType>));
        REQUIRE(report("across the normal, of the speed", aside, 8 * rounding<TestType>));
    }
}

TEMPLATE_TEST_CASE("Inertia of air: a plate that only moves on keeps its velocity", "[air]", double,
                   float) {
    World world;
    const Vec<double> v{0.5, -0.25, 1};
    Shape shape = grid({.columns = 9, .rows = 9});
    world.add(shape, {.density = sigma, .velocity = Points(81, v)});
    world.constrain(linksOf(world), {.name = "links"});
    actAir(world, still);
    SolverOptions options = stepping(1024);
    Solver<TestType> solver(world, options);
    advance(solver, 1000);
    for (const Vec<double>& is : solver.velocities()) REQUIRE(is == v);  // every number is dyadic

    // Where numbers round the plate turns by so much, and back.
    Run<TestType> run(plate(0.6), still);
    const Vec<double> u{0.3, -1.1, 0.7};
    for (auto& velocity : run.state.velocity) velocity.v = narrowed<TestType>(u);
    for (int s = 0; s < 1000; ++s) {
        run.blow(1e-3);
        for (int i = 0; i < run.state.count(); ++i)
            run.state.particles[i].x += TestType(1e-3) * narrowed<TestType>(u);
    }
    CHECK(report("velocity lost in 1000 substeps", deviation(run.state, u),
                 1000 * 16 * rounding<TestType>));
}

TEST_CASE("Inertia of air: a free sheet that tumbles and bends gains no energy", "[air]") {
    const World world = tumbling();
    const Rows<Stretch> rows = linksOf(world);
    for (const int rate : {600, 1200, 2400}) {
        SolverOptions options = stepping(rate);
        options.schedule.iterations = 4;
        Solver<double> solver(world, options);
        const auto& links = dynamic_cast<const ConstraintSet<Stretch, double>&>(solver.set(0));
        const auto energy = [&] {
            double sum = 0;
            for (int i = 0; i < solver.state().count(); ++i)
                sum +=
                    energyOf(world.mass[i], solver.state().velocity[i].v, solver.state().airAt(i));
            return sum;
        };
        solver.frame();
        const double start = energy();
        double before = start, worst = -1, most = 0, allowed = 0;
        for (int s = 1; s < rate / 4; ++s) {
            const Points x = solver.positions();
            solver.frame();
            const double now = energy(),
                         bound = allowance(links, rows, x, solver.positions(), 1.0 / rate);
            worst = std::max(worst, (now - before) / bound);
            most = std::max(most, now - before);
            allowed = std::max(allowed, bound);
            before = now;
        }
        note("J at the start", start);
        note("J at the end", before);
        note("J gained in a substep, at most", most);
        note("J allowed", allowed);
        CHECK(report("gained in a substep / allowed, worst", worst, 1));
        CHECK(before < start);
    }
}

TEMPLATE_TEST_CASE("Inertia of air: how the sheet stood belongs to the state", "[air]", double,
                   float) {
    const World world = tumbling();
    const SolverOptions options = stepping(600);
    Solver<TestType> solver(world, options), resumed(world, options), forgetful(world, options);
    const std::uint64_t start = solver.hash();
    advance(solver, 20);
    State<TestType> state = solver.state();
    resumed.restore(state, solver.evaluations());
    CHECK(resumed.hash() == solver.hash());
    std::ranges::fill(state.kept[state.inertia].numbers, TestType(0));
    forgetful.restore(state, solver.evaluations());
    CHECK(forgetful.hash() != solver.hash());
    for (auto* each : {&solver, &resumed, &forgetful}) advance(*each, 5);
    CHECK(resumed.hash() == solver.hash());
    CHECK(forgetful.positions() != solver.positions());
    const std::uint64_t end = solver.hash();
    solver.rewind();
    CHECK(solver.hash() == start);
    advance(solver, 25);
    CHECK(solver.hash() == end);
}
