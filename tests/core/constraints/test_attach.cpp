// Pins, hard and soft, at rest and moving.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81;
const SolverOptions settled{.schedule = {.substeps = 10, .iterations = 1}, .damping = 0.3};

// Notes where vertex 0 is at the end of every substep: as a contact it is evaluated last.
template <class Real>
struct Recorder : Constraint<Real> {
    Points* path;

    explicit Recorder(Points* to) : path(to) {}
    void project(const Sweep<Real>& sweep, Direction direction, Workers&) override {
        if (direction == Direction::forward) return;
        const Real* p = sweep.particles;
        path->push_back({double(p[0]) + double(p[4]), double(p[1]) + double(p[5]),
                         double(p[2]) + double(p[6])});
    }
    long size() const override { return 0; }
};

void record(World& world, Points& path) {
    Points* to = &path;
    world.constrain(
        {[to](const World&, KernelChoice) { return std::make_unique<Recorder<float>>(to); },
         [to](const World&, KernelChoice) { return std::make_unique<Recorder<double>>(to); }},
        {.name = "recorder", .importance = 1}, true);
}

// A path that is far from straight within a frame.
Vec<double> orbit(double t) {
    return {3.1 + 0.4 * std::sin(20 * t), 0.4 * std::cos(20 * t), 0.1 * t};
}

enum class Pin { massless, attached };

// Largest distance of the pinned vertex from the chord of each frame's motion, over all substeps.
template <class Real>
double distanceFromChords(Pin pin) {
    const int substeps = 8, frames = 20;
    World world = loosePoints({orbit(0)});
    world.act<Gravity>(GravityOptions{});
    if (pin == Pin::massless) {
        world.pin({0}, [](const Vec<double>&, double t) { return orbit(t); });
    } else {
        Rows<Attach> rows = restRows<Attach>({0}, world.rest);
        rows.animate = [](double t, std::span<Attach::Row<double>> r) { r[0].target = orbit(t); };
        world.constrain(rows, {.name = "pin"});
    }
    Points path;
    record(world, path);
    Solver<Real> solver(world, {.schedule = {.substeps = substeps, .iterations = 1}});
    advance(solver, frames);
    REQUIRE(path.size() == substeps * frames);
    double worst = 0;
    for (int i = 0; i < substeps * frames; ++i) {
        const double from = i / substeps / 24.0, f = (i % substeps + 1.0) / substeps;
        const Vec<double> a = orbit(from), b = orbit(from + 1 / 24.0);
        worst = std::max(worst, length(path[static_cast<std::size_t>(i)] - (a + f * (b - a))));
    }
    return worst;
}

}  // namespace

TEST_CASE("a hard pin holds whatever hangs on it", "[statics][attach][AT25]") {
    World world = plumbLine({.links = 5, .top = {0.1, 0.2, 0.3}, .down = {0.6, -0.8, 0}});
    world.constrain(linksOf(world), {.name = "stretch"});
    Solver<double> solver(world, settled);
    advance(solver, 100);
    REQUIRE(solver.positions()[0] == world.start[0]);

    World loose = loosePoints({{0.1, 0.2, 0.3}});
    loose.act<Gravity>(GravityOptions{});
    loose.constrain(restRows<Attach>({0}, loose.rest), {.name = "pin"});
    Solver<double> held(loose, settled);
    advance(held, 100);
    REQUIRE(report("hard pin of a mass, m", length(held.positions()[0] - loose.start[0]), 1e-15));
}

// Of the sets of a column the first is also the last: its constraints hold exactly when the others
// are done. A pin that comes after the links gives way to what hangs on it, N masses by g h^2.
TEST_CASE("a hard attachment holds a chain where it is evaluated first",
          "[statics][attach][AT25]") {
    for (const int links : {1, 5, 20}) {
        const auto pinError = [&](int order) {
            World world = plumbLine({.links = links});
            world.pinned[0] = 0;
            world.pins.clear();
            world.constrain(linksOf(world), {.name = "stretch"});
            world.constrain(restRows<Attach>({0}, world.rest), {.name = "pin", .order = order});
            Solver<double> solver(world, settled);
            advance(solver, 100);
            const double h = solver.substepLength();
            return length(solver.positions()[0]) / (g * h * h);
        };
        const std::string chain = " for a chain of " + std::to_string(links) + ", in g h2";
        REQUIRE(report("hard attachment first" + chain, pinError(-1), 1e-12));
        note("hard attachment last" + chain, pinError(1));
    }
}

TEST_CASE("a soft pin gives way by load times compliance", "[statics][attach][AT25]") {
    for (const int evaluations : {1, 5}) {
        double worst = 0;
        for (const double compliance : {1e-4, 1e-3, 1e-2})
            for (const double mass : {0.1, 2.0}) {
                World world = loosePoints({{0.1, 10.2, 0.3}});
                world.mass = {mass};
                world.act<Gravity>(GravityOptions{.acceleration = {0.6 * g, -0.8 * g, 0}});
                world.constrain(restRows<Attach>({0}, world.rest, compliance), {.name = "pin"});
                SolverOptions options = settled;
                options.schedule.iterations = evaluations;
                Solver<double> solver(world, options);
                advance(solver, 200);
                const double moved = length(solver.positions()[0] - world.start[0]);
                worst = std::max(worst, std::fabs(moved / (mass * g * compliance) - 1));
            }
        REQUIRE(report("soft pins, evaluations: " + std::to_string(evaluations), worst, 1e-6));
    }
}

TEST_CASE("a moving pin is where it should be at frame ends and goes straight between",
          "[statics][attach][AT25][AT2][IN27]") {
    const Pin pins[] = {Pin::massless, Pin::attached};
    for (const Pin pin : pins) {
        const std::string name = pin == Pin::massless ? "moving pin, " : "moving hard attachment, ";
        REQUIRE(report(name + "double, m", distanceFromChords<double>(pin), 4e-15));
        REQUIRE(report(name + "float, m", distanceFromChords<float>(pin), 1e-8));
    }
}

namespace {

// A strip folded at a right angle by its held ends, which its stiff bending denies. Root mean
// square of speeds (m/s) in the fourth and fifth second; compliance 0 takes the mass away instead.
double jitter(double compliance, Sweeps sweeps, Integrator integrator) {
    World world;
    Shape shape = grid({.columns = 3, .rows = 11, .width = 0.2, .height = 1},
                       {.across = {0, 0, 1}, .up = {1, 0, 0}});
    Points start = shape.positions;
    for (Vec<double>& x : start)
        if (x.x > 0.5) x = {0.5, x.x - 0.5, x.z};
    const Range strip = world.add(shape, {.density = 0.2, .start = start});
    world.act<Gravity>(GravityOptions{});
    const std::vector<int> ends{0, 1, 2, 3, 4, 5, 27, 28, 29, 30, 31, 32};
    if (compliance > 0)
        world.constrain(restRows<Attach>(ends, world.start, compliance), {.name = "pins"});
    else
        world.pin(ends);
    world.constrain(linksOf(world), {.name = "stretch", .order = 1});
    world.constrain(bendRows(world.complex, strip, world.rest, 1e4), {.name = "bend", .order = 2});
    Solver<double> solver(world, {.integrator = integrator,
                                  .sweeps = sweeps,
                                  .schedule = {.substeps = 10, .iterations = 1},
                                  .damping = 0.1});
    advance(solver, 72);
    double squares = 0;
    for (int frame = 0; frame < 48; ++frame) {
        solver.frame();
        for (const Vec<double>& v : solver.velocities()) squares += dot(v, v);
    }
    return std::sqrt(squares / static_cast<double>(48 * world.start.size()));
}

}  // namespace

// Vellum's advice, on Vellum's terms: second order, one sweep in one direction. Palindromes
// need no advice.
TEST_CASE("strong bending shakes hard pins loose, but not soft ones", "[statics][attach][DC19]") {
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2})
        for (const Sweeps sweeps : {Sweeps::oneWay, Sweeps::palindrome}) {
            const bool second = integrator == Integrator::bdf2;
            const bool there = sweeps == Sweeps::oneWay;
            const std::string name = std::string("jitter, m/s: ") +
                                     (second ? "BDF2, " : "first order, ") +
                                     (there ? "one-way, " : "palindromes, ");
            const double hard = jitter(0, sweeps, integrator);
            note(name + "hard pins", hard);
            for (const double compliance : {1e-6, 1e-4}) {
                const double soft = jitter(compliance, sweeps, integrator);
                note(name + (compliance < 1e-5 ? "1e-6 m/N" : "1e-4 m/N"), soft);
                REQUIRE(soft < 1e-2);
            }
            if (second && there) REQUIRE(hard > 10);
            if (!there) REQUIRE(hard < 1e-3);
        }
}
