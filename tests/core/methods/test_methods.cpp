// What every method owes: the laws of free fall, momentum, pins, the same bits for any number of
// threads, finite numbers, and a clear line where it lacks what a world has.
#include "scenes/scene.h"
#include "spring.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/sheet.h"

#include <plait/measure/momentum.h>
#include <plait/numbers/finite.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

struct Entry {
    Method method;
    const char* name;
};
constexpr Entry methods[] = {{Method::xpbd, "xpbd"},
                             {Method::explicitEuler, "explicit"},
                             {Method::symplectic, "symplectic"},
                             {Method::implicit, "implicit"},
                             {Method::linearised, "linearised"},
                             {Method::block, "block"},
                             {Method::global, "global"}};

// A free cloth of soft constraints of all kinds that have a compliance.
World softCloth() {
    World world;
    Shape shape = grid({.columns = 5, .rows = 5});
    for (Vec<double>& p : shape.positions) p = {p.x, 0.1 * std::sin(3 * p.x) + 0.05 * p.y, p.y};
    const Range all = world.add(shape, {.density = 0.5});
    Random random(31);
    for (auto& v : world.velocity) v = random.point(0.5);
    world.constrain(linksOf(world, 1e-2), {.name = "stretch"});
    world.constrain(restRows<Shear>(triangleStencils(world.complex, all), world.rest, 1),
                    {.name = "shear"});
    world.constrain(bendRows(world.complex, all, world.rest, 1e-3), {.name = "bend"});
    return world;
}

template <class Real>
double fallError(Method method) {
    World world = loosePoints({{0.3, 2, 0}, {1, 2, 0}});
    world.constrain(restRows<Stretch>({0, 1}, world.rest, 1e-3), {.name = "link"});
    world.act<Gravity>(GravityOptions{});
    constexpr int n = 60;
    Solver<Real> solver(world, steppingBy(1.0 / n, method));
    advance(solver, n);
    // Explicit Euler falls with the velocity before gravity, all others with that after it.
    const double steps = method == Method::explicitEuler ? n * (n - 1) : n * (n + 1);
    return std::fabs(2 - solver.positions()[0].y - 0.5 * 9.81 / (n * n) * steps);
}

std::string refusal(const World& world, const SolverOptions& options) {
    try {
        Solver<float> solver(world, options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("methods: free fall is the scheme's own sum", "[methods]") {
    for (const auto& [method, name] : methods) {
        CHECK(report(std::string("fall of 4.98675 m, ") + name, fallError<double>(method), 1e-12));
        CHECK(report(std::string("in float, ") + name, fallError<float>(method), 1e-6 * 4.98675));
    }
}

TEST_CASE("methods: soft cloth keeps its momentum", "[methods][conservation]") {
    for (const auto& [method, name] : methods) {
        World world = softCloth();
        SolverOptions options = steppingBy(1e-3, method);
        options.schedule.iterations = method == Method::block ? 8 : 1;
        Solver<double> solver(world, options);
        const Vec<double> before = momentum(world.mass, world.velocity);
        double size = 0;
        for (std::size_t i = 0; i < world.mass.size(); ++i)
            size += world.mass[i] * length(world.velocity[i]);
        advance(solver, 25);
        const double lost = length(momentum(world.mass, solver.velocities()) - before) / size;
        // What solves a system to a tolerance keeps momentum to it.
        const bool solves = method == Method::implicit || method == Method::block;
        CHECK(report(std::string("momentum lost in 25 substeps, ") + name, lost,
                     method == Method::global ? 1e-8
                     : solves                 ? 1e-11
                                              : 1e-14));
        REQUIRE(allFinite(solver.positions()));
    }
}

TEST_CASE("methods: symplectic springs keep their angular momentum", "[methods][conservation]") {
    World world = softCloth();
    Solver<double> solver(world, steppingBy(1e-3, Method::symplectic));
    const auto spin = [&] {
        return angularMomentum(world.mass, solver.positions(), solver.velocities());
    };
    const Vec<double> before = spin();
    advance(solver, 200);
    CHECK(report("angular momentum lost in 200 substeps", length(spin() - before) / length(before),
                 1e-13));
}

// Where soft cloth is after 20 ms, in substeps of h.
static Points endOf(Method method, double h) {
    World world = softCloth();
    world.pin({0});
    SolverOptions options = steppingBy(h, method);
    options.schedule.iterations = 3;
    Solver<double> solver(world, options);
    advance(solver, static_cast<int>(std::lround(0.02 / h)));
    return solver.positions();
}

static double distance(const Points& a, const Points& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, length(a[i] - b[i]));
    return worst;
}

TEST_CASE("methods: as the step shrinks all of them end in the same place", "[methods]") {
    const Points coarse = endOf(Method::xpbd, 4e-4), fine = endOf(Method::xpbd, 2e-4);
    REQUIRE(distance(fine, softCloth().start) > 0.01);
    for (const auto& [method, name] : methods) {
        const double far = distance(endOf(method, 4e-4), coarse);
        const double near = distance(endOf(method, 2e-4), fine);
        const std::string what = std::string("distance from XPBD, m, ") + name;
        if (method == Method::explicitEuler || method == Method::symplectic ||
            method == Method::implicit) {  // of first order, each in a way of its own
            note(what, near);
            CHECK(far / near == Approx(2).epsilon(0.1));
        } else {  // the same implicit Euler, but for what has not converged
            CHECK(report(what, near, 1e-7));
        }
    }
}

TEST_CASE("methods: a pin moves as told and takes its neighbours along", "[methods]") {
    for (const auto& [method, name] : methods) {
        World world = loosePoints({{0, 0, 0}, {1, 0, 0}});
        world.pin({0},
                  [](const Vec<double>& start, double t) { return start + Vec<double>{0, 0, t}; });
        world.constrain(restRows<Stretch>({0, 1}, world.rest, 1e-2), {.name = "link"});
        SolverOptions options = steppingBy(1e-3, method, 10);
        options.schedule.iterations = 20;
        Solver<double> solver(world, options);
        advance(solver, 100);
        INFO(name);
        CHECK(solver.positions()[0].z == Approx(1).epsilon(1e-12));
        CHECK(solver.velocities()[0].z == Approx(1).epsilon(1e-9));
        CHECK(solver.positions()[1].z > 0.1);
    }
}

TEST_CASE("methods: the same bits for any number of threads, and after a rewind",
          "[methods][determinism]") {
    for (const auto& [method, name] : methods) {
        std::uint64_t hash = 0;
        for (const int threads : {1, 2, 3}) {
            SolverOptions options = steppingBy(1e-3, method, 5);
            options.threads = threads;
            Solver<float> solver(softCloth(), options);
            advance(solver, 3);
            if (hash == 0) hash = solver.hash();
            INFO(name);
            CHECK(solver.hash() == hash);
            solver.rewind();
            advance(solver, 1);
            const State<float> state = solver.state();
            Solver<float> other(softCloth(), options);
            other.restore(state, solver.evaluations());
            advance(other, 2);
            CHECK(other.hash() == hash);
        }
    }
}

TEST_CASE("methods: degenerate input stays finite", "[methods]") {
    for (const auto& [method, name] : methods) {
        for (const double size : {0.0, 1e-3, 1.0}) {
            World world = softCloth();
            Random random(32);
            for (auto& x : world.start) x = {size * random.below(2), size * random.below(2), 0};
            world.pin({3, 4, 5});
            SolverOptions options = steppingBy(1e-3, method);
            options.schedule.iterations = 2;
            Solver<float> solver(world, options);
            INFO(name << " size " << size);
            advance(solver, 5);
            REQUIRE(allFinite(solver.positions()));
        }
    }
}

TEST_CASE("methods: every scene is taken on, or refused in a line that names the method",
          "[methods]") {
    for (const SceneEntry& entry : scenes()) {
        Scene scene = build(entry, Quality::draft);
        int taken = 0;
        for (const auto& [method, name] : methods) {
            scene.options.method = method;
            const std::string why = refusal(scene.world, scene.options);
            INFO(entry.name << ": " << why);
            if (why.empty()) {
                ++taken;
            } else {
                CHECK(why.starts_with(std::string("method ") + name + " "));
                CHECK(why.find('\n') == std::string::npos);
            }
        }
        CHECK(taken > 0);
    }
}

TEST_CASE("methods: what one lacks is said in a line, with what to do", "[methods]") {
    const auto lacking = [](Method method, const World& world) {
        return refusal(world, steppingBy(0.01, method));
    };
    World rigid = linkedPoints({{0, 0, 0}, {1, 0, 0}}, {1, 1});
    const std::string link =
        " has no rigid constraints, and set links has: give it a compliance, or take xpbd or block";
    CHECK(lacking(Method::explicitEuler, rigid) == "method explicit" + link);
    CHECK(lacking(Method::symplectic, rigid) == "method symplectic" + link);
    CHECK(lacking(Method::implicit, rigid) == "method implicit" + link);
    CHECK(lacking(Method::linearised, rigid) == "");
    CHECK(lacking(Method::block, rigid) == "");

    World floor = loosePoints({{0, 0, 0}});
    floor.constrain(restRows<PlaneContact>({0}, floor.rest), {.name = "floor"});
    CHECK(lacking(Method::implicit, floor) ==
          "method implicit has no contacts, and set floor is one: leave it out, or take xpbd or "
          "block");
    CHECK(lacking(Method::block, floor) == "");

    SolverOptions second = steppingBy(0.01, Method::symplectic);
    second.integrator = Integrator::bdf2;
    CHECK(refusal(unitSpring(), second) ==
          "method symplectic has an integrator of its own: choose the integrator \"first\"");
    second.method = Method::block;
    CHECK(refusal(unitSpring(), second) == "");
}
