// Air through the whole solver: a strip that hangs in the wind, sheets that fall, and where the
// impulse of the wind goes (validation A4).
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/air/air.h>
#include <plait/constraints/constants.h>
#include <plait/measure/momentum.h>
#include <plait/sets/constraint_set.h>

#include <cmath>
#include <numeric>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, sigma = 0.2;  // m/s^2, kg/m^2
constexpr AirForm legacy = AirForm::legacy, physical = AirForm::physical;
constexpr int columns = 2, rows = 9;

std::string name(AirForm form) { return form == legacy ? "legacy" : "physical"; }

template <class Real>
std::string name(const std::string& what) {
    return what + (std::is_same_v<Real, float> ? ", float" : ", double");
}

std::function<Vec<double>(double)> steady(double speed) {
    return [speed](double) { return Vec<double>{0, 0, speed}; };
}

// The angle to the vertical at which wind and weight leave nothing along the normal: tan = r, or
// sin = r cos^2 where drag is quadratic.
double balance(AirForm form, double ratio) {
    if (form == legacy) return std::atan(ratio);
    return std::asin((std::sqrt(1 + 4 * ratio * ratio) - 1) / (2 * ratio));
}

// 1 m of the scene strip-in-wind, straight, at rest and at this angle to the vertical.
World strip(double angle) {
    const Shape shape = grid({.columns = columns, .rows = rows, .width = 0.1, .height = 1},
                             {.across = {1, 0, 0}, .up = {0, -1, 0}});
    Points start;
    for (const Vec<double>& p : shape.positions)
        start.push_back({p.x, p.y * std::cos(angle), -p.y * std::sin(angle)});
    World world;
    world.add(shape, {.density = sigma, .start = start});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    world.constrain(linksOf(world), {.name = "stretch"});
    return world;
}

// Drag broadside is `ratio` times the weight.
AirOptions air(AirForm form, double ratio, double speed) {
    const double c = ratio * sigma * g / speed;
    return {.form = form,
            .drag = form == legacy ? c : 2 * c / speed,
            .tangentialDrag = 0,
            .wind = {.velocity = steady(speed)}};
}

struct Hang {
    double angle;  // rad, to the vertical
    double bow;    // the largest distance from the line through both ends, by its length
};

Hang hang(const Points& x) {
    const Vec<double> down = x[columns * (rows - 1)] - x[0];
    const double l = std::hypot(down.y, down.z);
    double bow = 0;
    for (const Vec<double>& p : x)
        bow = std::max(bow, std::fabs((p.y - x[0].y) * down.z - (p.z - x[0].z) * down.y) / (l * l));
    return {std::atan2(down.z, -down.y), bow};
}

}  // namespace

// In `physical` the area is that of the sheet as it is: stretched by the error of the solver, which
// falls with h^2, it takes more wind.
TEMPLATE_TEST_CASE("a strip hangs straight in the wind at its angle [A4]", "[strip]", double,
                   float) {
    for (const AirForm form : {legacy, physical})
        for (const double ratio : {0.25, 0.5, 1.0, 2.0, 4.0}) {
            const double angle = balance(form, ratio);
            World world = strip(angle + 0.02);
            actAir(world, air(form, ratio, 1));
            world.pin({0, 1});
            Solver<TestType> solver(
                world, {.schedule = {.substeps = form == legacy ? 40 : 80, .iterations = 1},
                        .damping = ratio > 2 ? 0.5 : 0.3});
            advance(solver, 9 * 24);
            const Hang end = hang(solver.positions());
            const double degrees = std::fabs(end.angle - angle) * 180 / pi;
            char what[80];
            std::snprintf(what, sizeof what, "%s, ratio %g, %.3f degrees", name(form).c_str(),
                          ratio, angle * 180 / pi);
            CHECK(report(name<TestType>(what) + ": angle off by, degrees", degrees,
                         form == legacy ? 5e-5 : 1e-3));
            CHECK(report(name<TestType>(what) + ": bow", end.bow, form == legacy ? 1e-7 : 1e-5));
        }
}

// Why the strip above is damped. A string whose facets share drag and mass among their ends has
// complex frequencies where the ratio is above about 1.5, and its zigzags feel no drag: small
// motions of 8 links at ratio 4 in 4 m/s grow by exp(7.1 t) in an independent linear computation,
// more the finer they are. The force follows the facet, so this is the model's, not the solver's.
TEST_CASE("without damping a strip flutters in strong wind", "[strip][AR5]") {
    for (const auto& [ratio, flutters] : {std::pair{1.0, false}, {4.0, true}}) {
        World world = strip(balance(legacy, ratio) + 1e-6);
        actAir(world, air(legacy, ratio, 4));
        world.pin({0, 1});
        Solver<double> solver(world, {.schedule = {.substeps = 40, .iterations = 1}});
        advance(solver, 3 * 24);
        const double bow = hang(solver.positions()).bow;
        note("bow after 3 s, started 1e-6 off, ratio " + std::to_string(int(ratio)), bow);
        CHECK((bow > 1e-3) == flutters);
    }
}

TEMPLATE_TEST_CASE("a sheet falls at its terminal velocity, broadside and edge-on [A4]", "[strip]",
                   double, float) {
    const double drag = 3, tau = 0.25;
    for (const AirForm form : {legacy, physical})
        for (const bool edgeOn : {false, true}) {
            World world;
            const Vec<double> up = edgeOn ? Vec<double>{0, 1, 0} : Vec<double>{0, 0, -1};
            world.add(grid({.columns = 5, .rows = 4}, {.across = {1, 0, 0}, .up = up}),
                      {.density = sigma});
            world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
            actAir(world, {.form = form, .drag = drag, .tangentialDrag = tau});
            world.constrain(linksOf(world), {.name = "stretch"});
            Solver<TestType> solver(world, {.schedule = {.substeps = 4, .iterations = 2}});
            advance(solver, 8 * 24);
            const double c = (edgeOn ? tau : 1) * drag;
            const double v = form == legacy ? sigma * g / c : std::sqrt(2 * sigma * g / c);
            const double mass = std::accumulate(world.mass.begin(), world.mass.end(), 0.0);
            const Vec<double> mean = (1 / mass) * momentum(world.mass, solver.velocities());
            const std::string what =
                name<TestType>(name(form) + (edgeOn ? ", edge-on" : ", broadside"));
            const bool single = std::is_same_v<TestType, float>;
            CHECK(report(what, std::fabs(mean.y / -v - 1), single ? 1e-5 : 1e-10));
            // Rounding tilts the sheet, which no force rights, and so it glides a little.
            CHECK(
                report(what + ", sideways", std::hypot(mean.x, mean.z) / v, single ? 1e-4 : 1e-10));
        }
}

namespace {

// A strip on two soft pins whose forces can be told. They are registered as contacts, so that they
// are evaluated last: where a substep ends, multiplier and gradient are of one evaluation.
template <class Real>
class PinnedStrip {
public:
    PinnedStrip(World world, const AirOptions& options, double damping)
        : weight_(g * std::accumulate(world.mass.begin(), world.mass.end(), 0.0)) {
        const Rows<Attach> pins = restRows<Attach>({0, 1}, world.start, 1e-3);
        const int padding = static_cast<int>(world.start.size());
        for (const int v : pins.ids) targets_.push_back(world.start[static_cast<std::size_t>(v)]);
        world.forces.push_back(recipe<Force>([this, options](const World& w, KernelChoice) {
            auto made = std::make_unique<Air<Real>>(w, options);
            air_ = made.get();
            return made;
        }));
        world.constrain(recipe<Constraint>([this, pins, padding](const World&, KernelChoice k) {
                            auto made =
                                std::make_unique<ConstraintSet<Attach, Real>>(pins, padding, k);
                            pins_ = made.get();
                            return made;
                        }),
                        {.name = "pins"}, true);
        mass_ = world.mass;
        SolverOptions options1 = stepping(960);
        options1.damping = damping;
        solver_ = std::make_unique<Solver<Real>>(world, options1);
    }

    Solver<Real>& solver() { return *solver_; }
    double weight() const { return weight_; }
    Vec<double> wind() const { return air_->impulse(); }
    Vec<double> momentum() const { return plait::momentum(mass_, solver_->velocities()); }
    // N s, that the pins gave in the last substep.
    Vec<double> held() const {
        Vec<double> sum{0, 0, 0};
        for (int i = 0; i < 2; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Vec<double> from = solver_->state().position(i) - targets_[at];
            sum +=
                (double(pins_->multiplier(i)) / (solver_->substepLength() * length(from))) * from;
        }
        return sum;
    }

private:
    template <template <class> class Base, class Make>
    static Recipe<Base> recipe(const Make& make) {
        Recipe<Base> recipe;
        if constexpr (std::is_same_v<Real, float>)
            recipe.single = make;
        else
            recipe.full = make;
        return recipe;
    }
    double weight_;  // N
    Points targets_;
    std::vector<double> mass_;
    const Air<Real>* air_ = nullptr;
    const ConstraintSet<Attach, Real>* pins_ = nullptr;
    std::unique_ptr<Solver<Real>> solver_;
};

}  // namespace

TEMPLATE_TEST_CASE("the impulse of the wind is the momentum gained less what pins gave [A4]",
                   "[strip]", double, float) {
    for (const AirForm form : {legacy, physical}) {
        AirOptions options = air(form, 3, 5);
        options.tangentialDrag = 0.1;
        options.lift = 0.2 * options.drag;
        options.wind.noise = 2;
        options.wind.noiseLength = 0.2;
        PinnedStrip<TestType> run(strip(0.3), options, 0);
        const double h = run.solver().substepLength();
        Vec<double> wind{0, 0, 0}, held{0, 0, 0};
        double worst = 0;
        const int n = 960;
        for (int s = 1; s <= n; ++s) {
            run.solver().frame();
            wind += run.wind();
            held += run.held();
            const Vec<double> weight{0, -s * h * run.weight(), 0};
            worst = std::max(worst, length(run.momentum() - (wind + held + weight)));
        }
        const std::string at = name<TestType>(name(form));
        note(at + ": impulse of the wind in a second, N s", length(wind));
        note(at + ": momentum at its end, N s", length(run.momentum()));
        CHECK(length(held) > 0.1 * length(wind));
        CHECK(report(at + ": impulse lost / impulse of the wind", worst / length(wind),
                     std::is_same_v<TestType, float> ? 1e-5 : 1e-12));
    }
}

// Without tangential drag, wind and weight at the angle of balance leave the weight along the
// strip.
TEMPLATE_TEST_CASE("pins bear what wind and weight leave of a strip [A4]", "[strip]", double,
                   float) {
    const double ratio = 1, angle = balance(legacy, ratio);
    PinnedStrip<TestType> run(strip(angle), air(legacy, ratio, 1), 0.3);
    advance(run.solver(), 6 * 960);
    const Vec<double> force = (1 / run.solver().substepLength()) * run.held();
    const double pull = run.weight() * std::cos(angle);
    const Vec<double> expected{0, pull * std::cos(angle), -pull * std::sin(angle)};
    CHECK(report(name<TestType>("force of the pins"), length(force - expected) / pull,
                 std::is_same_v<TestType, float> ? 1e-4 : 1e-10));
}
