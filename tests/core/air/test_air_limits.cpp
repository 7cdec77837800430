// The air where it is hard on a scheme, and what it refuses.
#include "air_run.h"
#include "tests/catch.h"
#include "tests/report.h"

using namespace plait;
using namespace plait::test;

TEMPLATE_TEST_CASE("Drag never adds energy, however stiff and whatever the masses", "[air]", float,
                   double) {
    // c h / sigma reaches 1e6 on the mean vertex and far more on the lightest.
    for (const double h : {1e-3, 1.0, 1e3})
        for (const AirForm form : {legacy, physical}) {
            Run<TestType> run(crumpled(), {.form = form,
                                           .density = 200,
                                           .drag = 1,
                                           .tangentialDrag = 0.1,
                                           .lift = form == physical ? 0.5 : 0});
            double before = run.energy(), growth = 0;
            for (int s = 0; s < 300; ++s) {
                run.blow(h);
                growth = std::max(growth, run.energy() / before - 1);
                before = run.energy();
            }
            CHECK(report("growth of energy in a substep, h = " + std::to_string(h), growth,
                         sizeof(TestType) == 4 ? 1e-5 : 1e-12));
        }
}

TEST_CASE("Lift gains energy at high speed in legacy, never in physical", "[air][AW6]") {
    for (const auto& [speed, stable] : {std::pair{1.0, true}, {1000.0, false}})
        for (const AirForm form : {legacy, physical}) {
            World world = plate(0.7);
            for (Vec<double>& v : world.velocity) v = {0, speed, 0};
            Run run(world, {.form = form, .drag = 0.01, .tangentialDrag = 0, .lift = 1});
            double most = 0;
            const double start = run.energy();
            for (int s = 0; s < 20; ++s) {
                run.blow(0.01);
                const double now = run.energy();
                most = std::max(most, std::isfinite(now) ? now / start : INFINITY);
            }
            note(std::string(form == legacy ? "legacy" : "physical") + ": energy gained at " +
                     std::to_string(int(speed)) + " m/s",
                 most);
            if (form == legacy && !stable) CHECK(most > 100);
            if (form == physical || stable) CHECK(most < (form == legacy ? 1.01 : 1 + 1e-12));
        }
}

TEST_CASE("The sheet gains the impulse that the air gives", "[air]") {
    Wind gusty{steady({8, 0, 1}), 3};
    Run run(crumpled(), {.lift = 0.5, .wind = gusty});
    Vec<double> given{0, 0, 0}, before{0, 0, 0}, after{0, 0, 0};
    const auto momentum = [&] {
        Vec<double> sum{0, 0, 0};
        for (std::size_t i = 0; i < run.world.mass.size(); ++i)
            sum += run.world.mass[i] * run.state.velocity[i].v;
        return sum;
    };
    for (const int v : run.world.pins[0].vertices)  // free for once, so that they count
        run.state.particles[static_cast<std::size_t>(v)].w = 1 / run.world.mass[std::size_t(v)];
    before = momentum();
    for (int s = 0; s < 50; ++s) {
        run.blow(0.01);
        given += run.air.impulse();
    }
    after = momentum();
    CHECK(report("momentum gained / impulse given - 1",
                 length(after - before - given) / length(given), 1e-12));
}

TEST_CASE("Area is fixed in legacy and counts in physical; objects are chosen; solids have a skin",
          "[air][AW5]") {
    const auto blown = [](const World& world, AirForm form, double stretch,
                          const std::vector<Range>& objects) {
        Run run(world, {.form = form, .drag = 2, .objects = objects, .wind = {steady({0, 1, 0})}});
        for (Particle<double>& p : run.state.particles) p.x = stretch * p.x;
        run.blow(1e-9);
        return 1e9 * run.air.impulse().y;
    };
    World world = plate(0);
    CHECK(blown(world, legacy, 1, {}) == Approx(2));
    CHECK(blown(world, physical, 1, {}) == Approx(1));
    CHECK(blown(world, legacy, 3, {}) == Approx(2));
    CHECK(blown(world, physical, 3, {}) == Approx(9));
    world.add(grid({.width = 2}, {.up = {0, 0, -1}}), {});
    CHECK(blown(world, legacy, 1, {}) == Approx(6));
    CHECK(blown(world, legacy, 1, {{30, 34}}) == Approx(4));
    CHECK(blown(world, legacy, 1, {{30, 33}}) == 0);  // no triangle lies wholly in it
    World solid;
    solid.add(block({.columns = 3, .rows = 3, .layers = 3}), {.density = 1});
    CHECK(blown(solid, legacy, 1, {}) == Approx(2 * 2 + 4 * 2 * 0.05));
}

TEST_CASE("Nothing breaks on triangles and edges without area", "[air]") {
    World world = crumpled();
    for (std::size_t i = 0; i < 60; ++i) world.start[i] = {1, 2, 3};
    world.rest[100] = world.rest[101];
    world.rest[88] = world.rest[89] = world.rest[101];
    world.add(chain({.links = 3}), {.density = 1, .start = std::vector<Vec<double>>(4)});
    for (const AirForm form : {legacy, physical}) {
        const double lift = form == legacy ? 0 : 1;
        Run run(world, {.form = form, .lift = lift, .wind = {steady({5, 0, 0}), 2}});
        run.fall(20, 0.1);
        CHECK(std::isfinite(run.energy()));
    }
}

TEST_CASE("Wind is asked once a substep, and gusts differ from place to place", "[air][AW2][AW4]") {
    int calls = 0;
    Wind wind{[&](double t) {
        ++calls;
        return Vec<double>{t, 0, 0};
    }};
    Run run(plate(0), {.form = legacy, .tangentialDrag = 1, .wind = wind});
    for (int s = 0; s < 7; ++s) act<double>(run.state, {&run.air}, 0.1, run.workers, s);
    CHECK(calls == 7);

    World world;
    world.add(grid({.columns = 41, .rows = 41, .width = 40, .height = 40}, {.origin = {0, 0, 1.3}}),
              {.density = 1e-6});
    const auto gusts = [&](const Wind& of, double t) {
        Run light(world, {.form = legacy, .tangentialDrag = 1, .wind = of});
        act<double>(light.state, {&light.air}, 1, light.workers, t);
        return light.state.velocity;
    };
    const Wind gusty{{}, 2.0, 3.0, 0.5, {4, 0, 0}};
    double square = 0, moved = 0;
    const auto now = gusts(gusty, 10.2), later = gusts(gusty, 10.7);
    Wind other = gusty;
    other.seed = 2;
    const auto third = gusts(other, 10.2);
    Wind frozen = gusty;
    frozen.noiseTime = 1e9;
    const auto from = gusts(frozen, 10), to = gusts(frozen, 10.5);
    for (std::size_t i = 0; i < 41 * 41; ++i) {
        square += dot(now[i].v, now[i].v) / (41 * 41);
        if (i % 41 >= 3 && i % 41 < 38)  // 4 m/s for 0.5 s are two columns
            moved = std::max(moved, length(to[i].v - from[i - 2].v));
    }
    note("root mean square of gusts of 2 m/s (a component)", std::sqrt(square / 3));
    CHECK(std::sqrt(square / 3) == Approx(2).epsilon(0.25));
    CHECK(report("frozen gusts travel with the drift", moved, 1e-6));
    CHECK(length(now[800].v - later[800].v) > 0.1);
    CHECK(length(now[800].v - third[800].v) > 0.1);
}

TEMPLATE_TEST_CASE("Any number of threads gives the same bits", "[air]", float, double) {
    World world;
    world.add(grid({.columns = 60, .rows = 50}), {.density = sigma});
    world.add(chain({.links = 700}), {.density = 0.01});
    std::vector<Padded<TestType>> first;
    for (const int threads : {1, 2, 3, 8}) {
        Run<TestType> run(world, {.lift = 0.5, .wind = {steady({8, 0, 3}), 2}}, threads);
        run.fall(20, 0.01);
        if (first.empty()) first = run.state.velocity;
        bool same = true;
        for (std::size_t i = 0; i < first.size(); ++i)
            same = same && first[i].v == run.state.velocity[i].v;
        CHECK(same);
        CHECK(std::isfinite(run.energy()));
        CHECK(run.energy() > 0);
    }
}

TEST_CASE("Values outside their range are warned of by name; nonsense is refused", "[air]") {
    const auto warnings = [](const AirOptions& options) {
        World world = plate(0);
        actAir(world, options);
        CHECK(world.forces.size() == 1);
        return world.warnings;
    };
    using Lines = std::vector<std::string>;
    CHECK(warnings({}).empty());
    CHECK(warnings({.density = -1}) == Lines{"air density = -1 is outside [0, inf]"});
    CHECK(warnings({.drag = -2}) == Lines{"air drag = -2 is outside [0, inf]"});
    CHECK(warnings({.tangentialDrag = 1.5}) ==
          Lines{"air tangential drag = 1.5 is outside [0, 1]"});
    CHECK(warnings({.form = legacy, .lift = 2}) == Lines{"air lift = 2 is outside [0, 1]"});
    CHECK(warnings({.drag = 0, .lift = 7}) == Lines{"air lift = 7 is outside [0, 6.28319]"});

    const auto refuses = [](const AirOptions& options, const std::string& words) {
        World world = plate(0);
        CHECK_THROWS_WITH(actAir(world, options), words);
        CHECK_THROWS_WITH(Air<float>(world, options), words);
    };
    refuses({.drag = NAN}, "air: all numbers must be finite");
    refuses({.lift = INFINITY}, "air: all numbers must be finite");
    refuses({.width = -1}, "air: width must not be negative");
    refuses({.interval = 0}, "air: interval must be at least 1");
    refuses({.wind = {{}, -1}}, "air: noise must not be negative");
    refuses({.wind = {{}, 1, 0}}, "air: noise length must be positive");
    refuses({.wind = {{}, 1, 1, 0}}, "air: noise time must be positive");
    CHECK_THROWS_WITH(Air<float>(plate(0), {.objects = {{0, 31}}}),
                      "air: no such vertices: 0 to 31");
}
