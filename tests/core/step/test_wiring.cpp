// What the solver hands to forces, and when; and the work it counts.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/small_scenes.h"
#include "tests/worlds.h"

#include <plait/air/air.h>
#include <plait/forces/field.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

using Point = Vec<double>;

constexpr double g = 9.81;

std::vector<double> multiples(double step, int count, int every = 1) {
    std::vector<double> times;
    for (int i = 0; i < count; i += every) times.push_back(i * step);
    return times;
}

}  // namespace

TEST_CASE("wiring: the space scale is the size of a unit in metres", "[wiring][UN1]") {
    for (const double scale : {0.01, 1.0, 100.0}) {
        World world = loosePoints({{0, 0, 0}});
        world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}, .spaceScale = scale});
        Solver<double> solver(world, {.schedule = {.substeps = 10}});
        advance(solver, 24);
        const double h = solver.substepLength(), n = 240;
        const double exact = -g / scale * h * h * n * (n + 1) / 2;
        char what[80];
        std::snprintf(what, sizeof what, "fall of a second where a unit is %g m", scale);
        CHECK(report(what, std::fabs(solver.positions()[0].y / exact - 1), 1e-12));
    }
}

// Time runs as the time scale says, and frames and substeps with it.
TEST_CASE("wiring: fields are asked once a frame, wind once a substep", "[wiring][IN29]") {
    const int frames = 3, substeps = 5;
    for (const double scale : {1.0, 0.25})
        for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
            World world = loosePoints({{0, 0, 0}, {4, 0, 0}});
            world.add(grid({}), {});
            std::vector<double> windTimes, fieldTimes;
            actAir(world, {.wind = {.velocity = [&](double t) {
                               windTimes.push_back(t);
                               return Point{0, 0, 0};
                           }}});
            world.act<Field>(FieldOptions{.acceleration =
                                              [&](const Point&, double t) {
                                                  fieldTimes.push_back(t);
                                                  return Point{1, 0, 0};
                                              },
                                          .objects = {{1, 2}}});
            Solver<double> solver(world, {.integrator = integrator,
                                          .schedule = {.substeps = substeps, .iterations = 1},
                                          .timeScale = scale});
            CHECK(solver.substepLength() == Approx(scale / 24 / substeps).epsilon(1e-15));
            advance(solver, frames);
            const int all = frames * substeps;
            const double h = solver.substepLength();
            CHECK(windTimes == multiples(h, all));
            CHECK(fieldTimes == multiples(h, all, substeps));
            CHECK(solver.time() == all * h);
        }
}

// The field of a frame is that of where the vertex was at its start; the wind of a substep is that
// of its start, and drag is implicit.
TEST_CASE("wiring: a field is constant in a frame, wind changes within it", "[wiring][IN29]") {
    const int substeps = 8;
    const auto wind = [](double t) { return Point{0, 0, std::sin(40 * t)}; };
    World world = loosePoints({{2, 0, 0}});
    const Range plate = world.add(grid({}), {.density = 1});
    world.act<Field>(
        FieldOptions{.acceleration = [](const Point& x, double) { return Point{-30 * x.x, 0, 0}; },
                     .objects = {{0, 1}}});
    const double c = 3;
    actAir(world, {.form = AirForm::legacy, .drag = c, .objects = {plate}, .wind = {wind}});
    Solver<double> solver(world, {.schedule = {.substeps = substeps}});
    const double h = solver.substepLength();
    double x = 2, v = 0, blown = 0, fieldError = 0, windError = 0;
    for (int frame = 0; frame < 12; ++frame) {
        const double a = -30 * x;
        for (int s = 0; s < substeps; ++s) {
            v += h * a;
            x += h * v;
            blown = (blown + h * c * wind((frame * substeps + s) * h).z) / (1 + h * c);
        }
        solver.frame();
        fieldError = std::max(fieldError, std::fabs(solver.positions()[0].x - x));
        windError = std::max(windError, std::fabs(solver.velocities()[2].z - blown));
    }
    CHECK(report("field, m", fieldError, 1e-12));
    CHECK(report("wind, m/s", windError, 1e-12));
}

TEST_CASE("wiring: a world tells of values out of range, and runs", "[wiring]") {
    World world;
    world.add(grid({}), {});
    world.act<Gravity>(GravityOptions{});
    CHECK(world.warnings.empty());
    actAir(world, {.drag = -0.1});
    actAir(world, {.tangentialDrag = 2, .lift = 9});
    CHECK(world.warnings == std::vector<std::string>{"air drag = -0.1 is outside [0, inf]",
                                                     "air tangential drag = 2 is outside [0, 1]",
                                                     "air lift = 9 is outside [0, 6.28319]"});
    Solver<float> solver(world, {});
    advance(solver, 3);
    for (const SceneEntry& entry : scenes())
        CHECK(build(entry, Quality::draft).world.warnings.empty());
}

TEST_CASE("wiring: the work counted is that of the log, sets by sweeps", "[wiring]") {
    for (const SceneEntry& entry : smallScenes()) {
        const Scene scene = build(entry, Quality::draft);
        if (matterMeets(scene) || !scene.world.spare.empty()) continue;
        for (const Sweeps sweeps : {Sweeps::palindrome, Sweeps::oneWay}) {
            SolverOptions options = scene.options;
            options.sweeps = sweeps;
            Solver<float> solver(scene.world, options);
            std::vector<LogMark> log;
            solver.log = &log;
            advance(solver, 2);

            long expected = 0, inSmoothing = 0;
            for (int s = 0; s < static_cast<int>(scene.world.sets.size()); ++s)
                inSmoothing += solver.set(s).size();
            expected += options.smoothing * 2 * options.schedule.substeps * inSmoothing;
            SubstepPlan plan;
            for (const LogMark& mark : log) {
                solver.schedule().plan(mark.substep, plan);
                // Contacts once more after smoothing, in one sweep.
                const bool last = mark.column == static_cast<int>(plan.columns.size());
                const int each = sweeps == Sweeps::palindrome && !last ? 2 : 1;
                expected += each * solver.set(mark.set).size();
            }
            INFO(entry.name);
            CHECK(solver.evaluations() == expected);
            CHECK((expected > 0) == !scene.world.sets.empty());
        }
    }
}
