// What meets colliders fast, or meets fast ones: nothing gets in or through.
#include "collider_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

using namespace plait;
using namespace plait::test;

namespace {

// How deep a straight way goes in, m; independent of when it first does.
double deepest(const Solid& solid, const Vec<double>& start, const Vec<double>& end) {
    double most = 0;
    constexpr int samples = 4000;
    for (int n = 0; n <= samples; ++n) {
        const double t = double(n) / samples;
        most = std::max(most, -sideOf(solid, start + t * (end - start)).distance);
    }
    return most;
}

}  // namespace

// Validation D 1 at solids: 1 to 10,000 thicknesses a step, at any angle.
TEST_CASE("colliders: bullets go through nothing", "[colliders]") {
    for (const auto& [name, solid] : solids)
        for (const double e : {0.0, 1.0}) {
            Random random(4);
            World world;
            Points places, velocities;
            for (int i = 0; i < 500; ++i) {
                const Vec<double> d = direction(random);
                const double step = skin * std::pow(10.0, random.uniform(0, 4));
                const Vec<double> aim{random.uniform(-0.9, 0.9) * (solid.half.x + solid.radius),
                                      random.uniform(-0.9, 0.9) * (solid.half.y + solid.radius),
                                      random.uniform(-0.9, 0.9) * (solid.half.z + solid.radius)};
                double away = 2;  // from outside, so that it arrives within its second step
                while (sideOf(solid, aim - away * d).distance > 2 * skin && away > 1e-3)
                    away *= 0.99;
                away /= 0.99;
                places.push_back(aim - (away + random.uniform(0.1, 1) * step) * d);
                velocities.push_back(24 * step * d);
            }
            const Range all = world.add({SimplicialComplex(500), places}, {.velocity = velocities});
            collide(world, {hard(solid, 0.2, e)}, {rough(all, 0.2, e)});
            Solver<float> solver(world, meeting(1, 1));
            int hit = 0;
            double worst = 0;
            Points before = solver.positions();
            for (int frame = 0; frame < 4; ++frame) {
                solver.frame();
                const Points now = solver.positions();
                for (int i = 0; i < 500; ++i) {
                    worst = std::max(worst, deepest(solid, before[i], now[i]));
                    worst = std::max(worst, skin - sideOf(solid, now[i]).distance - 1e-6);
                }
                before = now;
            }
            for (int i = 0; i < 500; ++i)
                hit +=
                    length(solver.velocities()[i] - velocities[i]) > 1e-3 * length(velocities[i]);
            CHECK(hit > 400);
            CHECK(report(name + ", e " + std::to_string(e) + ", deepest, m", worst, 0));
        }
}

// What flails about takes what is in its way along: nothing is inside, ever.
TEST_CASE("colliders: nothing gets into what turns fast", "[colliders]") {
    for (const auto& [name, solid] : solids) {
        Random random(5);
        World world;
        Points places;
        while (places.size() < 500) {
            const Vec<double> p = random.point(0.6);
            if (sideOf(solid, p).distance > 2 * skin) places.push_back(p);
        }
        const Range all = world.add({SimplicialComplex(500), places});
        Collider collider = hard(solid, 0.3);
        // 40 degrees and 0.1 m a step, and steps in between.
        collider.motion = [](double t) {
            return turnedAbout({0.6, 0, 0.8}, 0.7 * 24 * t, {0.1 * sine(24 * t), 0, 0});
        };
        collide(world, {collider}, {rough(all, 0.3)});
        Solver<double> solver(world, meeting(1, 1));
        double worst = 0;
        for (int frame = 1; frame <= 24; ++frame) {
            const Points before = solver.positions();
            const Placement was(collider.motion((frame - 1) / 24.0), "was");
            solver.frame();
            const Placement is(collider.motion(frame / 24.0), "is");
            const Points now = solver.positions();
            for (int i = 0; i < 500; ++i) {
                const Vec<double> end = is.own(now[i]);
                worst = std::max(worst, deepest(solid, was.own(before[i]), end));
                worst = std::max(worst, skin - sideOf(solid, end).distance - 1e-9);
            }
        }
        CHECK(report(name + ", deepest, m", worst, 0));
    }
}

// A ball on an arm of 1 m goes a third of a turn in a frame: straight, it misses the target on its
// circle by 0.5 m less both radii.
TEST_CASE("colliders: what turns hits its target with finer base steps only", "[colliders][IN28]") {
    for (const int baseSteps : {1, 2, 4, 8}) {
        World world;
        const Vec<double> target{std::cos(pi / 3), std::sin(pi / 3), 0};
        const Range point = addPoint(world, target);
        Collider club = hard(Solid::sphere(0.1), 0);
        club.motion = [](double t) {
            const double angle = 2 * pi / 3 * 24 * t;
            return Frame{.origin = {cosine(angle), sine(angle), 0}};
        };
        collide(world, {club}, {rough(point, 0)});
        SolverOptions options = meeting(8, 1);
        options.baseSteps = baseSteps;
        Solver<float> solver(world, options);
        solver.frame();
        const double moved = length(solver.positions()[0] - target);
        if (baseSteps == 1) CHECK(topSpeed(solver) == 0);
        if (baseSteps > 1) CHECK(moved > 0.1);
    }
    // By how much: the largest reach that still misses.
    const double miss = 1 - std::cos(pi / 3);
    for (const auto& [reach, hits] : {std::pair{miss - 0.001, false}, {miss + 0.001, true}}) {
        World world;
        const Range point = addPoint(world, {std::cos(pi / 3), std::sin(pi / 3), 0});
        Collider club = hard(Solid::sphere(reach - skin), 0);
        club.motion = [](double t) {
            const double angle = 2 * pi / 3 * 24 * t;
            return Frame{.origin = {cosine(angle), sine(angle), 0}};
        };
        collide(world, {club}, {rough(point, 0)});
        Solver<float> solver(world, meeting(8, 1));
        solver.frame();
        CHECK((topSpeed(solver) > 0) == hits);
    }
}

// A light sheet between a floor and a plate 10,000 times as heavy, which only the sheet keeps from
// the floor: what parts it from one presses it into the other, and no number of passes would settle
// it. Neither is gone through.
TEST_CASE("colliders: what falls on a sheet on a floor presses it into neither", "[colliders]") {
    const bool floorFirst = GENERATE(true, false);
    World world;
    const Frame above{.origin = {-0.2, 2 * skin, 0.2}, .up = {0, 0, -1}};
    const Range sheet = world.add(
        grid({.columns = 9, .rows = 9, .width = 0.4, .height = 0.4}, above), {.density = 0.1});
    Frame higher = above;
    higher.origin += Vec<double>{0.05, 0.3, -0.05};
    const Range plate = world.add(
        grid({.columns = 4, .rows = 4, .width = 0.3, .height = 0.3}, higher), {.density = 1000});
    for (const Range& part : {sheet, plate})
        world.constrain(restRows<Stretch>(edgeStencils(world.complex, part), world.rest),
                        {.name = part.first == sheet.first ? "sheet" : "plate"});
    world.act<Gravity>(GravityOptions{});
    const auto stand = [&] { collide(world, {hard(Solid::plane(), 0.3)}, {rough(sheet, 0.3)}); };
    if (floorFirst) stand();
    meet(world, {rough(sheet, 0.3), rough(plate, 0.3)});
    if (!floorFirst) stand();
    Solver<float> solver(world, meeting(2));
    double lowest = 1;
    int crossings = 0;
    for (int frame = 0; frame < 12; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        for (const Vec<double>& p : x) lowest = std::min(lowest, p.y);
        crossings += countIntersections(x, trianglesOf(world));
    }
    note("lowest, m", lowest);
    CHECK(lowest > 0);
    CHECK(crossings == 0);
    CHECK(solver.failures() == 0);
}

TEST_CASE("colliders: a vertex that two of them close on is counted as failed", "[colliders]") {
    World world;
    const Range point = addPoint(world, {0, 0.05, 0});
    Collider press = hard(Solid::box(1, 0.2, 1), 0);
    press.motion = [](double t) { return Frame{.origin = {0, 0.3 - 0.6 * t, 0}}; };
    collide(world, {hard(Solid::plane(), 0), press}, {rough(point, 0)});
    Solver<float> solver(world, meeting(4));
    for (int frame = 0; frame < 7; ++frame) {
        solver.frame();
        CHECK(solver.failures() == 0);  // it is pushed down, and there is room
    }
    solver.frame();
    CHECK(solver.failures() > 0);
}

TEST_CASE("colliders: what begins inside comes out, and slowly", "[colliders]") {
    for (const auto& [name, solid] : solids) {
        World world;
        Random random(6);
        Points places;
        while (places.size() < 200) {
            const Vec<double> p = random.point(0.5);
            if (sideOf(solid, p).distance < 0) places.push_back(p);
        }
        const Range all = world.add({SimplicialComplex(200), places});
        collide(world, {hard(solid, 0)}, {rough(all, 0)}, {.recovery = 0.5});
        Solver<float> solver(world, meeting(4));
        double fastest = 0, deep = 0;
        for (int frame = 0; frame < 48; ++frame) {
            solver.frame();
            fastest = std::max(fastest, topSpeed(solver));
        }
        for (const Vec<double>& p : solver.positions())
            deep = std::max(deep, -sideOf(solid, p).distance);
        CHECK(report(name + ", fastest, m/s", fastest, 0.5 + 1e-4));
        CHECK(report(name + ", deep after 2 s, m", deep, 0));
    }
}

namespace {

// A sheet that falls on a plane, a turning box, a pole and a ball.
World busy() {
    World world;
    const Range sheet =
        world.add(grid({.columns = 24, .rows = 24}, {.origin = {-0.5, 0.4, 0.5}, .up = {0, 0, -1}}),
                  {.density = 0.2});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest),
                    {.name = "stretch"});
    world.act<Gravity>(GravityOptions{});
    Collider turning = hard(Solid::box(0.5, 0.1, 0.3), 0.4, 0.3);
    turning.motion = [](double t) { return turnedAbout({0, 1, 0}, 3 * t, {0.2, 0.2, 0}); };
    Collider pole = hard(Solid::capsule(1, 0.05), 0.2);
    pole.frame = {.origin = {-0.3, 0.2, 0}, .across = {0, 1, 0}, .up = {0, 0, 1}};
    Collider ball = hard(Solid::sphere(0.15), 0.3);
    ball.frame.origin = {-0.1, 0.1, 0.3};
    collide(world, {hard(Solid::plane(), 0.5), turning, pole, ball}, {rough(sheet, 0.3, 0.2)});
    return world;
}

}  // namespace

TEMPLATE_TEST_CASE("colliders: the same bits from any number of threads, and resumed",
                   "[colliders][determinism][threads]", float, double) {
    const World world = busy();
    std::uint64_t expected = 0;
    for (const int threads : {1, 3}) {
        Solver<TestType> solver(world, meeting(8, 2, threads));
        advance(solver, 12);
        const State<TestType> half = solver.state();
        const long evaluations = solver.evaluations();
        advance(solver, 12);
        if (threads == 1) expected = solver.hash();
        CHECK(solver.hash() == expected);
        Solver<TestType> resumed(world, meeting(8, 2, threads));
        resumed.restore(half, evaluations);
        advance(resumed, 12);
        CHECK(resumed.hash() == expected);
    }
    double lowest = 1;
    Solver<TestType> solver(world, meeting(8));
    advance(solver, 24);
    for (const Vec<double>& p : solver.positions()) lowest = std::min(lowest, p.y);
    CHECK(lowest > 0.9 * skin);
}
