// What is laid over the integration: frame rates and time scale, damping of velocities and of
// links, the limit on acceleration, and what BDF2 does at a contact.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/measure/momentum.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

using Point = Vec<double>;

constexpr double g = 9.81;

const char* name(Integrator integrator) {
    return integrator == Integrator::first ? "first order" : "BDF2";
}

constexpr Integrator integrators[] = {Integrator::first, Integrator::bdf2};

World pendulum() {
    World world = linkedPoints({{0, 0, 0}, {0.6, -0.8, 0}}, {1, 1});
    world.act<Gravity>(GravityOptions{});
    return world;
}

SolverOptions with(Integrator integrator, int substeps) {
    return {.integrator = integrator, .schedule = {.substeps = substeps, .iterations = 1}};
}

// Where the bob is after a second of its own time.
Point scaledPendulum(Integrator integrator, double scale, int substeps) {
    SolverOptions options = with(integrator, substeps);
    options.timeScale = scale;
    Solver<double> solver(pendulum(), options);
    advance(solver, static_cast<int>(std::lround(24 / scale)));
    return solver.positions()[1];
}

// What BDF2 makes of rounding in float is more than that, with and without damping, and only noted.
template <class Real>
void expectSmall(Integrator integrator, const std::string& what, double error) {
    if (std::is_same_v<Real, float> && integrator == Integrator::bdf2)
        note(what + ", float", error);
    else
        CHECK(report(what + (std::is_same_v<Real, float> ? ", float" : ", double"), error, 1e-6));
}

}  // namespace

TEST_CASE("frame rates with one substep length give the same bits",
          "[integration][determinism][IN14]") {
    for (const char* const scene : {"pendulum", "chain", "hanging-sheet", "band"}) {
        std::uint64_t hash = 0;
        long evaluations = 0;
        for (const int fps : {24, 30, 48, 60}) {
            Scene built = build(findScene(scene));
            built.options.schedule.frameRate = {fps, 1};
            built.options.schedule.substeps = 240 / fps;
            Solver<float> solver(built.world, built.options);
            advance(solver, fps / 2);
            if (fps == 24) hash = solver.hash(), evaluations = solver.evaluations();
            CHECK(solver.hash() == hash);
            CHECK(solver.evaluations() == evaluations);  // importance is by 1/24 s
        }
    }
}

TEST_CASE("time scale", "[integration][IN25]") {
    for (const double scale : {2.0, 0.1}) {
        // A fall: what the scheme does with a substep of that many times the length.
        World world = loosePoints({{0, 0, 0}});
        world.act<Gravity>(GravityOptions{});
        SolverOptions options = with(Integrator::first, 10);
        options.timeScale = scale;
        Solver<double> solver(world, options);
        advance(solver, 24);
        const double h = solver.substepLength(), exact = -g * h * h * 240 * 241 / 2;
        const std::string at = "time scale " + std::to_string(scale).substr(0, 3);
        CHECK(report(at + ", fall", std::fabs(solver.positions()[0].y / exact - 1), 1e-12));
        CHECK(solver.time() == Approx(scale).epsilon(1e-14));

        for (const Integrator integrator : integrators) {
            // Substeps as long as without it: the same motion.
            const int substeps = 20;
            const Point same =
                scaledPendulum(integrator, scale, static_cast<int>(substeps * scale));
            const Point plain = scaledPendulum(integrator, 1, substeps);
            CHECK(report(at + ", same substeps, " + name(integrator), length(same - plain), 1e-12));
            // Longer or shorter ones: the same but for the error of integration.
            const double coarse =
                length(scaledPendulum(integrator, scale, 40) - scaledPendulum(integrator, 1, 40));
            const double fine =
                length(scaledPendulum(integrator, scale, 80) - scaledPendulum(integrator, 1, 80));
            note(at + ", 80 substeps, m, " + name(integrator), fine);
            CHECK(std::log2(coarse / fine) > (integrator == Integrator::first ? 0.9 : 1.8));
        }
    }
}

TEMPLATE_TEST_CASE("velocity damping does not depend on substeps", "[integration][IN23]", double,
                   float) {
    for (const Integrator integrator : integrators)
        for (const double damping : {0.1, 0.5}) {
            double worst = 0;
            for (const int substeps : {1, 2, 3, 10, 30, 100}) {
                World world = loosePoints({{0, 0, 0}});
                world.velocity[0] = {3, -4, 12};
                SolverOptions options = with(integrator, substeps);
                options.damping = damping;
                Solver<TestType> solver(world, options);
                for (int frame = 1; frame <= 5; ++frame) {
                    const double before = length(solver.velocities()[0]);
                    solver.frame();
                    const double kept = length(solver.velocities()[0]) / before;
                    worst = std::max(worst, std::fabs(kept / (1 - damping) - 1));
                }
            }
            const std::string at = "damping " + std::to_string(damping).substr(0, 3) + ", ";
            expectSmall<TestType>(integrator, at + name(integrator), worst);
        }
}

// Links so soft that they do nothing else.
TEMPLATE_TEST_CASE("damping of links does not depend on substeps", "[integration]", double, float) {
    for (const Integrator integrator : integrators) {
        double worst = 0;
        for (const int substeps : {1, 2, 3, 10, 30}) {
            World world = loosePoints({{0, 0, 0}, {1, 0, 0}});
            world.velocity[1] = {1, 0, 0};
            world.constrain(restRows<Stretch>({0, 1}, world.rest, 1e12),
                            {.name = "link", .damping = 0.3});
            Solver<TestType> solver(world, with(integrator, substeps));
            const auto rate = [&] { return (solver.velocities()[1] - solver.velocities()[0]).x; };
            for (int frame = 1; frame <= 5; ++frame) {
                const double before = rate();
                solver.frame();
                worst = std::max(worst, std::fabs(rate() / before / 0.7 - 1));
            }
        }
        expectSmall<TestType>(integrator, std::string("damping of a link, ") + name(integrator),
                              worst);
    }
}

// A spring that bounces while it flies and turns.
TEST_CASE("damping of a link leaves rigid motion, damping of velocities does not",
          "[integration][IN24]") {
    struct End {
        double bounce;  // m, largest change of length over the last quarter of a second
        Point momentum, spin;
    };
    const auto fly = [](double ofLink, double ofVelocity, int substeps = 100) {
        World world = loosePoints({{-0.5, 0, 0}, {0.5, 0, 0}});
        world.velocity = {{0, -0.5, 1}, {0, 0.5, 1}};
        world.constrain(restRows<Stretch>({0, 1}, world.rest, 1.0 / 400),
                        {.name = "spring", .damping = ofLink});
        world.start[1].x = 0.6;
        SolverOptions options = with(Integrator::bdf2, substeps);
        options.damping = ofVelocity;
        Solver<double> solver(world, options);
        double shortest = 10, longest = 0;
        for (int frame = 0; frame < 48; ++frame) {
            solver.frame();
            const Points x = solver.positions();
            if (frame < 42) continue;
            shortest = std::min(shortest, length(x[1] - x[0]));
            longest = std::max(longest, length(x[1] - x[0]));
        }
        const Points x = solver.positions(), v = solver.velocities();
        return End{longest - shortest, momentum(world.mass, v),
                   angularMomentum(world.mass, x, v, 0.5 * (x[0] + x[1]))};
    };
    const End free = fly(0, 0), link = fly(0.5, 0), velocity = fly(0, 0.05);
    const double spin = 0.55, kept = std::pow(0.95, 48);
    note("spring, undamped: bounce, m", free.bounce);
    CHECK(free.bounce > 0.1);
    CHECK(report("spring, its link damped: bounce, m", link.bounce, 1e-6));
    CHECK(
        report("spring, its link damped: momentum", length(link.momentum - Point{0, 0, 2}), 1e-12));
    // What spin it loses, it loses to the error of integration: half as much at half the step.
    const double lost = spin - link.spin.z, half = spin - fly(0.5, 0, 200).spin.z;
    CHECK(report("spring, its link damped: part of the spin lost", std::fabs(lost) / spin, 5e-4));
    CHECK(report("spring, its link damped: part lost as h goes to 0",
                 std::fabs(2 * half - lost) / spin, 1e-5));
    CHECK(report("spring, velocities damped: momentum",
                 length(velocity.momentum - kept * Point{0, 0, 2}), 1e-12));
    CHECK(report("spring, velocities damped: spin",
                 length(velocity.spin - kept * Point{0, 0, spin}), 1e-4));
}

// A chain that starts half as long again as it may be.
TEST_CASE("the limit on acceleration holds", "[integration][IN21][IN22]") {
    for (const Integrator integrator : integrators) {
        double largest[2] = {};
        for (const bool limited : {false, true}) {
            const int steps = 480;
            Points at;
            for (int i = 0; i <= 10; ++i) at.push_back({0.1 * i, 0, 0});
            World world = linkedPoints(at, std::vector<double>(11, 0.1));
            for (Point& x : world.start) x = 1.5 * x;
            world.act<Gravity>(GravityOptions{});
            SolverOptions options = stepping(steps, integrator);
            options.maxAcceleration = 50;
            options.limitAcceleration = limited;
            Solver<double> solver(world, options);
            for (int i = 0; i < steps; ++i) {
                const Points before = solver.velocities();
                solver.frame();
                const Points now = solver.velocities();
                for (std::size_t v = 0; v < now.size(); ++v)
                    largest[limited] =
                        std::max(largest[limited], steps * length(now[v] - before[v]));
            }
        }
        note(std::string("acceleration without a limit, m/s^2, ") + name(integrator), largest[0]);
        CHECK(largest[0] > 500);
        CHECK(report(std::string("acceleration over a limit of 50, ") + name(integrator),
                     largest[1] / 50 - 1, 1e-9));
    }
}

// Points dropped on a floor from many heights, so that they meet it in every part of a substep; the
// highest that any of them comes back, in units of its drop.
template <class Real>
double rebound(double maxAcceleration) {
    const int count = 64, steps = 240;
    Random random(20);
    Points at;
    for (int i = 0; i < count; ++i) at.push_back({0, random.uniform(0.5, 1.5), 0});
    World world = loosePoints(at);
    world.act<Gravity>(GravityOptions{});
    auto floor = restRows<PlaneContact>(pointStencils({0, count}), at);
    for (auto& row : floor.rows) row = {{0, 0, 0}, {0, 1, 0}, 0};
    world.constrain(floor, {.name = "floor"});
    SolverOptions options = stepping(steps, Integrator::bdf2);
    options.maxAcceleration = maxAcceleration;
    Solver<Real> solver(world, options);
    std::vector<bool> met(count, false);
    double highest = 0;
    for (int i = 0; i < 3 * steps; ++i) {
        solver.frame();
        const Points x = solver.positions();
        for (std::size_t p = 0; p < count; ++p) {
            if (x[p].y < 1e-6) met[p] = true;
            if (met[p]) highest = std::max(highest, x[p].y / at[p].y);
        }
    }
    return highest;
}

TEMPLATE_TEST_CASE("BDF2 falls back at contacts", "[integration][IN20][IN21]", double, float) {
    const double without = rebound<TestType>(std::numeric_limits<double>::infinity());
    note("rebound without the fall-back, of the drop", without);
    CHECK(without > 1);
    for (const double limit : {20.0, 100.0, 500.0})
        CHECK(report("rebound with it, beyond " + std::to_string(static_cast<int>(limit)) +
                         " m/s^2, of the drop",
                     rebound<TestType>(limit), 1));
}

// Errors of the arithmetic alone: against the same rounded positions in double. V says that
// the second form loses less than the first; it does not.
TEST_CASE("forms of the velocity of BDF2 in float", "[integration][IN17]") {
    Random random(17);
    const float h = 0.001f;
    double naive = 0, vellum = 0, differences = 0;
    const int n = 100000;
    for (int i = 0; i < n; ++i) {
        const double x0 = random.uniform(-10, 10), v = random.uniform(-5, 5);
        const float last = float(x0), past = float(x0 + v * h), now = float(x0 + 2.01 * v * h);
        const double exact = (1.5 * now - 2.0 * past + 0.5 * last) / h;
        const auto add = [&](double& sum, float form) { sum += (form - exact) * (form - exact); };
        add(naive, (3 * now / 2 - 2 * past + last / 2) / h);
        add(vellum, ((2 * now + (now + last)) - 4 * past) / (2 * h));
        const float step = now - past;
        add(differences, (step + 0.5f * (step - (past - last))) / h);
    }
    note("v = (3/2 x - 2 x1 + x2 / 2) / h, rms, m/s", std::sqrt(naive / n));
    note("v = (2 x + (x + x2) - 4 x1) / 2 h (V), rms, m/s", std::sqrt(vellum / n));
    note("v by differences of neighbours (ours), rms, m/s", std::sqrt(differences / n));
    CHECK(1e6 * differences < std::min(vellum, naive));
}
