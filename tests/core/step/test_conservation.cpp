// Momentum and angular momentum of a free body through the whole solver, for every kind that joins
// vertices to each other (validation A10).
//
// Momentum is kept by every rule of the step. Angular momentum is not: every correction is without
// torque about the points where it is evaluated, but these move on within the substep. With A(a, b)
// = sum m a x b, corrections D of which A(x', D) = 0 where each was evaluated at x', and the
// first-order rule v = (x - x1) / h,
//
//     L' - L = A(x, v') - A(x1, v) = (1/h) sum over corrections of A(x1 - x', D)
//
// exactly: 0 were all evaluated where the substep began (Verlet), h A(v', v) were all evaluated
// where it ended (implicit Euler, which slows a rotor). Damping of rates is without torque too.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/constraints/constants.h>
#include <plait/measure/momentum.h>
#include <plait/sets/constraint_set.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

using Point = Vec<double>;

// A free body of uneven shape and mass, thrown in disorder.
World thrown(Shape shape) {
    World world;
    Random random(3);
    Points velocity;
    for (Point& p : shape.positions) {
        p += random.point(0.02);
        velocity.push_back(random.point(0.3) + Point{0.5, 0, 0});
    }
    world.add(shape, {.velocity = velocity});
    for (double& mass : world.mass) mass *= random.uniform(0.2, 5);
    return world;
}

// Calls visit(name, world, rows, direct) for every kind, hard and soft.
template <class Visit>
void everyKind(const Visit& visit) {
    const World sheet = thrown(grid({.columns = 7, .rows = 6, .width = 0.6, .height = 0.5}));
    const World coil = thrown(helix({.links = 20, .radius = 0.2, .turns = 2}));
    const Range inSheet{0, 42}, inCoil{0, 21};
    const auto triangles = triangleStencils(sheet.complex, inSheet);
    const auto corners = cornerStencils(sheet.complex, inSheet);
    const auto hinges = hingeStencils(sheet.complex, inSheet);
    Rows<Stretch> buckling = linksOf(sheet);
    for (auto& row : buckling.rows) row.compression = slack;
    visit("stretch", sheet, linksOf(sheet), false);
    visit("stretch, soft", sheet, linksOf(sheet, 1e-3), false);
    visit("stretch, buckling", sheet, buckling, false);
    visit("stretch, direct", coil, linksOf(coil), true);
    visit("shear", sheet, restRows<Shear>(triangles, sheet.rest), false);
    visit("shear, soft", sheet, restRows<Shear>(triangles, sheet.rest, 0.1), false);
    visit("angle, of corners", sheet, restRows<Angle>(corners, sheet.rest), false);
    visit("angle, of a curve", coil, curveBendRows(coil.complex, inCoil, coil.rest, 1e-2), false);
    visit("bend", sheet, restRows<Bend>(hinges, sheet.rest), false);
    visit("bend, soft", sheet, bendRows(sheet.complex, inSheet, sheet.rest, 1e-2), false);
}

struct Variant {
    const char* name;
    SolverOptions options = {};
    double damping = 0;  // of the sets

    bool isPlain() const {
        return damping == 0 && options.smoothing == 0 && options.method == Method::xpbd &&
               options.sweeps != Sweeps::alternating;
    }
};

const std::vector<Variant>& variants() {
    static const std::vector<Variant> all = [] {
        std::vector<Variant> v{
            {"palindrome"},
            {"one-way", {.sweeps = Sweeps::oneWay}},
            {"alternating", {.sweeps = Sweeps::alternating}},
            {"smoothing", {.smoothing = 3}},
            {"damping", {}, 0.5},
            {"nucleus", {.method = Method::nucleus}},
            {"BDF2", {.integrator = Integrator::bdf2}},
            {"BDF2, smoothing, damping", {.integrator = Integrator::bdf2, .smoothing = 3}, 0.5}};
        for (Variant& variant : v)
            variant.options.schedule = {.substeps = 1, .frameRate = {480, 1}, .iterations = 2};
        return v;
    }();
    return all;
}

// The masses that a run has: 1 / w, w in its precision.
template <class Real>
std::vector<double> massesOf(const Solver<Real>& solver) {
    std::vector<double> mass;
    for (int i = 0; i < solver.state().count(); ++i)
        mass.push_back(1 / double(solver.state().particles[static_cast<std::size_t>(i)].w));
    return mass;
}

double sizeOf(const std::vector<double>& mass, const Points& v) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += mass[i] * length(v[i]);
    return sum;
}

template <class Real>
std::string precision(const std::string& what) {
    return what + (std::is_same_v<Real, float> ? ", float" : ", double");
}

template <class Real>
constexpr double tolerance = std::is_same_v<Real, float> ? 1e-6 : 1e-12;

}  // namespace

TEMPLATE_TEST_CASE("every kind keeps momentum, whatever the rules [A10]", "[conservation][MS6]",
                   double, float) {
    everyKind([](const std::string& kind, const World& start, const auto& rows, bool direct) {
        double worst = 0, bdf2 = 0;
        for (const Variant& variant : variants()) {
            World world = start;
            world.constrain(rows, {.name = kind, .damping = variant.damping, .direct = direct});
            Solver<TestType> solver(world, variant.options);
            const std::vector<double> mass = massesOf(solver);
            const Points v = solver.velocities();
            const Point before = momentum(mass, v);
            advance(solver, 100);
            const Points after = solver.velocities();
            CHECK(after != v);
            double& error = variant.options.integrator == Integrator::bdf2 ? bdf2 : worst;
            error = std::max(error, length(momentum(mass, after) - before) / sizeOf(mass, v));
        }
        const std::string what = precision<TestType>(kind + ": momentum in 100 substeps");
        CHECK(report(what, worst, tolerance<TestType>));
        // BDF2 makes more than twice as much of what rounding does.
        CHECK(report(what + ", BDF2", bdf2, 2.5 * tolerance<TestType>));
    });
}

namespace {

// What the corrections of a run were, told by the sets below.
struct Ledger {
    Points start;        // where the substep began
    double torque = 0;   // the largest |A(x', D)|, kg m^2
    double damped = 0;   // the same for changes of velocity, kg m^2/s
    Point lag{0, 0, 0};  // the sum of A(x1 - x', D)
    long corrections = 0, dampings = 0;
};

// A set that is all evaluated at the same positions, and what it tells the ledger.
template <class Real>
class Witness : public Constraint<Real> {
public:
    Witness(std::unique_ptr<Constraint<Real>> set, std::size_t vertices, Ledger& ledger)
        : set_(std::move(set)), vertices_(vertices), ledger_(ledger) {}

    void begin(const Substep& substep, Workers& workers) override { set_->begin(substep, workers); }
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override {
        watch(sweep, sweep.particles + 4, 8, [&] { set_->project(sweep, direction, workers); });
    }
    void smooth(const Sweep<Real>& sweep, Workers& workers) override {
        watch(sweep, sweep.out, 4, [&] { set_->smooth(sweep, workers); });
    }
    void damp(const Sweep<Real>& sweep, Workers& workers) override {
        const double torque =
            changeBy(sweep, sweep.out, 4, [&] { set_->damp(sweep, workers); }).torque;
        ledger_.damped = std::max(ledger_.damped, torque);
        ++ledger_.dampings;
    }
    void countAt(std::vector<int>& counts) const override { set_->countAt(counts); }
    void relaxBy(const std::vector<int>& counts) override { set_->relaxBy(counts); }
    long size() const override { return set_->size(); }

private:
    struct Change {
        double torque;
        Point lag;
    };

    static Point at(const Real* p) { return {double(p[0]), double(p[1]), double(p[2])}; }

    template <class Act>
    Change changeBy(const Sweep<Real>& sweep, const Real* changed, std::size_t stride,
                    const Act& act) {
        Points x, before;
        for (std::size_t i = 0; i < vertices_; ++i) {
            const Real* const p = sweep.particles + 8 * i;
            x.push_back(at(p) + at(p + 4));
            before.push_back(at(changed + stride * i));
        }
        act();
        Point torque{0, 0, 0}, lag{0, 0, 0};
        for (std::size_t i = 0; i < vertices_; ++i) {
            const double mass = 1 / double(sweep.particles[8 * i + 3]);
            const Point d = mass * (at(changed + stride * i) - before[i]);
            torque += cross(x[i], d);
            lag += cross(ledger_.start[i] - x[i], d);
        }
        return {length(torque), lag};
    }

    template <class Act>
    void watch(const Sweep<Real>& sweep, const Real* changed, std::size_t stride, const Act& act) {
        const Change change = changeBy(sweep, changed, stride, act);
        ledger_.torque = std::max(ledger_.torque, change.torque);
        ledger_.lag += change.lag;
        ++ledger_.corrections;
    }

    std::unique_ptr<Constraint<Real>> set_;
    std::size_t vertices_;
    Ledger& ledger_;
};

// Registers each colour of the rows as a set of its own, whose constraints share no vertex; or all
// at once those that are solved at once.
template <class Real, class Kind>
void constrainWatched(World& world, const Rows<Kind>& rows, const SetOptions& options,
                      Ledger& ledger) {
    const int vertices = static_cast<int>(world.start.size());
    std::vector<int> colors = greedyColors(rows.ids, Kind::arity, vertices);
    if (options.direct) std::ranges::fill(colors, 0);
    for (int c = 0; c <= *std::ranges::max_element(colors); ++c) {
        Rows<Kind> color;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            if (colors[i] != c) continue;
            color.rows.push_back(rows.rows[i]);
            for (std::size_t a = 0; a < Kind::arity; ++a)
                color.ids.push_back(rows.ids[i * Kind::arity + a]);
        }
        world.constrain(color, options);
        Recipe<Constraint>& recipe = world.sets.back().recipe;
        const auto make = [inner = recipe, &ledger](const World& w, KernelChoice kernels) {
            return std::make_unique<Witness<Real>>(inner.template make<Real>(w, kernels),
                                                   w.start.size(), ledger);
        };
        if constexpr (std::is_same_v<Real, float>)
            recipe.single = make;
        else
            recipe.full = make;
    }
}

}  // namespace

TEMPLATE_TEST_CASE("angular momentum changes by what corrections lag behind, and no more [A10]",
                   "[conservation][figures]", double, float) {
    everyKind([](const std::string& kind, const World& body, const auto& rows, bool direct) {
        double torque = 0, damped = 0, unexplained = 0;
        for (const Variant& variant : variants()) {
            Ledger ledger;
            World world = body;
            constrainWatched<TestType>(
                world, rows, {.name = kind, .damping = variant.damping, .direct = direct}, ledger);
            Solver<TestType> solver(world, variant.options);
            const std::vector<double> mass = massesOf(solver);
            const double h = solver.substepLength();
            const double size = sizeOf(mass, solver.velocities());  // within 1 m of the origin
            const auto spin = [&] {
                return angularMomentum(mass, solver.positions(), solver.velocities());
            };
            const Point start = spin();
            Point last = start;
            for (int s = 0; s < 100; ++s) {
                ledger.start = solver.positions();
                ledger.lag = {0, 0, 0};
                solver.frame();
                const Point change = spin() - last;
                last += change;
                if (variant.options.integrator == Integrator::first)
                    unexplained =
                        std::max(unexplained, length(change - (1 / h) * ledger.lag) / size);
            }
            if (std::is_same_v<TestType, double> && variant.isPlain())
                note(kind + ", " + variant.name + ": angular momentum lost a second",
                     length(last - start) / size / (100 * h));
            CHECK(ledger.corrections > 0);
            CHECK((ledger.dampings > 0) == (variant.damping > 0));
            torque = std::max(torque, ledger.torque / (h * size));
            damped = std::max(damped, ledger.damped / size);
        }
        const std::string at = precision<TestType>(kind);
        CHECK(report(at + ": torque of a correction", torque, tolerance<TestType>));
        CHECK(report(at + ": torque of damping", damped, tolerance<TestType>));
        CHECK(report(at + ": change not explained", unexplained, tolerance<TestType>));
    });
}

// A sheet of soft links that spins and stretches.
TEST_CASE("what angular momentum is lost falls with the substep, by the order of the scheme",
          "[conservation]") {
    World world;
    const Shape shape = grid({.columns = 5, .rows = 5}, {.origin = {-0.5, -0.5, 0}});
    Points velocity;
    for (const Point& p : shape.positions) velocity.push_back(cross({0, 0, 3}, p));
    world.add(shape, {.velocity = velocity});
    world.constrain(linksOf(world, 1e-2), {.name = "stretch"});
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        const auto lost = [&](int stepsPerSecond) {
            SolverOptions options = stepping(stepsPerSecond, integrator);
            options.schedule.iterations = 10;
            Solver<double> solver(world, options);
            advance(solver, stepsPerSecond / 2);
            const auto spin = [&](const Points& x, const Points& v) {
                return angularMomentum(world.mass, x, v).z;
            };
            return 1 - spin(solver.positions(), solver.velocities()) /
                           spin(world.start, world.velocity);
        };
        const std::string name = integrator == Integrator::first ? "first order" : "BDF2";
        const double coarse = lost(480), fine = lost(960);
        note(name + ": angular momentum lost in 0.5 s, 960 steps a second", fine);
        const double order = std::log2(coarse / fine);
        note("    order", order);
        CHECK((integrator == Integrator::first ? std::fabs(order - 1) < 0.1 : order > 1.8));
    }
}
