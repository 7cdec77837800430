// What goes wrong is named, and leaves everything as it was.
#include "tests/catch.h"
#include "tests/worlds.h"

#include <plait/air/air.h>
#include <plait/contacts/surface.h>
#include <plait/forces/field.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
const SolverOptions tenSubsteps{.schedule = {.substeps = 10, .iterations = 1}};

// Two linked weights that fall, the third on a pin that is carried about by `motion`.
World weights(Motion motion = {}) {
    World world = loosePoints({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    world.act<Gravity>(GravityOptions{});
    world.constrain(restRows<Stretch>({0, 1}, world.rest), {.name = "links"});
    if (motion) world.pin({2}, std::move(motion));
    return world;
}

// Spoils a vertex while `on`: in its projections, or where it damps rates.
template <class Real>
struct Poison : Constraint<Real> {
    Poison(const bool& on, bool ofRates) : on_(on), ofRates_(ofRates) {}
    void project(const Sweep<Real>& sweep, Direction, Workers&) override {
        if (on_ && !ofRates_) sweep.particles[4] = static_cast<Real>(notANumber);
    }
    void damp(const Sweep<Real>& sweep, Workers&) override {
        if (on_ && ofRates_) sweep.out[0] = static_cast<Real>(notANumber);
    }
    long size() const override { return 1; }

private:
    const bool& on_;
    bool ofRates_;
};

Recipe<Constraint> poison(const bool& on, bool ofRates = false) {
    return {[&on, ofRates](const World&, KernelChoice) {
                return std::make_unique<Poison<float>>(on, ofRates);
            },
            [&on, ofRates](const World&, KernelChoice) {
                return std::make_unique<Poison<double>>(on, ofRates);
            }};
}

struct Failure {
    std::string culprit = "nothing";
    long substep = -1;
};

// What breaks the world in its first three frames.
template <class Real = double>
Failure failureOf(const World& world, const SolverOptions& options = tenSubsteps) {
    Solver<Real> solver(world, options);
    std::uint64_t before = solver.hash();
    for (int frame = 0; frame < 3; ++frame) {
        before = solver.hash();
        const long evaluations = solver.evaluations();
        try {
            solver.frame();
        } catch (const Diverged& diverged) {
            CHECK(solver.hash() == before);
            CHECK(solver.evaluations() == evaluations);
            return {diverged.culprit, diverged.substep};
        }
    }
    return {};
}

void checkFailure(const Failure& failure, const std::string& culprit, long substep) {
    CHECK(failure.culprit == culprit);
    CHECK(failure.substep == substep);
}

double late(double t) { return t > 1.49 / 24 ? notANumber : 0; }  // from the fifteenth substep on

}  // namespace

TEMPLATE_TEST_CASE("failures: what is given and not a number is laid to who gave it", "[failures]",
                   float, double) {
    checkFailure(failureOf<TestType>(weights()), "nothing", -1);

    World windy = weights();
    windy.add(grid({}), {});
    actAir(windy, {.wind = {.velocity = [](double t) { return Vec<double>{late(t), 0, 0}; }}});
    checkFailure(failureOf<TestType>(windy), "air", 15);

    World pulled = weights();
    pulled.act<Field>(FieldOptions{
        .acceleration = [](const Vec<double>&, double t) { return Vec<double>{late(t), 0, 0}; },
        .name = "vortex"});
    checkFailure(failureOf<TestType>(pulled), "vortex", 20);  // asked once a frame

    World carried = weights([](const Vec<double>& x, double t) { return x + late(t) * x; });
    checkFailure(failureOf<TestType>(carried), "the motion of a pin", 10);

    World attached = weights();
    auto hook = restRows<Attach>({0}, attached.rest);
    hook.animate = [](double t, auto rows) { rows[0].target = {0, late(t), 0}; };
    attached.constrain(hook, {.name = "hook"});
    checkFailure(failureOf<TestType>(attached), "hook", 10);

    World stretched = weights();
    auto links = restRows<Stretch>({1, 2}, stretched.rest);
    links.rows[0].rest = infinity;
    stretched.constrain(links, {.name = "endless link", .order = 2});
    checkFailure(failureOf<TestType>(stretched), "endless link", 0);
}

TEST_CASE("failures: a set of one's own is named in projection and in damping", "[failures]") {
    bool on = true;
    for (const bool ofRates : {false, true}) {
        World world = weights();
        world.constrain(poison(on, ofRates), {.name = "poison", .order = -1, .damping = 0.1});
        for (const int smoothing : {0, 2}) {
            SolverOptions options = tenSubsteps;
            options.smoothing = smoothing;
            checkFailure(failureOf(world, options), "poison", 0);
        }
    }
}

// A query of contact refuses what is not a number, on whatever thread it finds it.
TEST_CASE("failures: what contact refuses is laid to who made it", "[failures]") {
    World world;
    const Range first = world.add(grid({.columns = 24, .rows = 24}, {}), {.density = 0.1});
    const Range second =
        world.add(grid({.columns = 24, .rows = 24}, {.origin = {0, 0, 0.001}}), {.density = 0.1});
    bool on = true;
    world.constrain(poison(on), {.name = "poison"});
    meet(world, {{.vertices = first}, {.vertices = second}}, {.order = 1});
    for (const int threads : {1, 4}) {
        SolverOptions options = tenSubsteps;
        options.threads = threads;
        checkFailure(failureOf<float>(world, options), "poison", 0);
    }
}

// Each step is given numbers that a float holds, and makes one that it does not.
TEST_CASE("failures: a run that leaves the range of its numbers names the step", "[failures]") {
    const auto fast = [](double x, double v, double timeScale) {
        World world = loosePoints({{x, 0, 0}});
        world.velocity[0] = {v, 0, 0};
        return failureOf<float>(world, {.schedule = {.substeps = 1}, .timeScale = timeScale});
    };
    checkFailure(fast(0, 3e38, 48), "the prediction", 0);
    checkFailure(fast(3e38, 3e38, 12), "the update", 0);
    checkFailure(fast(1, 1, 1), "nothing", -1);
}

TEMPLATE_TEST_CASE("failures: a run goes on where it was once the cause is gone", "[failures]",
                   float, double) {
    bool on = false;
    World world = weights();
    world.constrain(poison(on), {.name = "poison"});
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        SolverOptions options = tenSubsteps;
        options.integrator = integrator;
        Solver<TestType> broken(world, options), whole(world, options);
        for (int frame = 0; frame < 4; ++frame) {
            on = true;
            CHECK_THROWS_AS(broken.frame(), Diverged);
            on = false;
            broken.frame();
            whole.frame();
            CHECK(broken.hash() == whole.hash());
            CHECK(broken.evaluations() == whole.evaluations());
            CHECK(broken.time() == whole.time());
        }
    }
}

// Also what only BDF2 reads.
TEMPLATE_TEST_CASE("failures: what is not finite has no hash", "[failures]", float, double) {
    SolverOptions options = tenSubsteps;
    options.integrator = Integrator::bdf2;
    Solver<TestType> solver(weights(), options);
    solver.frame();
    solver.hash();
    State<TestType> state = solver.state();
    state.lastVelocity[0].v.x = static_cast<TestType>(notANumber);
    solver.restore(state, 0);
    CHECK_THROWS_AS(solver.hash(), std::logic_error);
    CHECK_THROWS_AS(solver.frame(), Diverged);
}

TEST_CASE("failures: what makes no sense is refused by name", "[failures]") {
    const auto refusal = [](const World& world, const SolverOptions& options = {}) -> std::string {
        try {
            Solver<float> solver(world, options);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    const World good = weights();
    const auto spoilt = [&](const auto& spoil) {
        World world = good;
        spoil(world);
        return refusal(world);
    };
    CHECK(refusal(good) == "accepted");
    for (const double bad : {-1.0, 0.0, notANumber, infinity}) {
        CHECK(refusal(good, {.timeScale = bad}) == "time scale must be positive");
        CHECK(spoilt([&](World& w) { w.mass[1] = bad; }) == "vertex 1 has no mass");
    }
    CHECK(refusal(good, {.damping = notANumber}) == "damping must be in [0, 1]");
    CHECK(refusal(good, {.maxAcceleration = notANumber}) == "max acceleration must be positive");
    CHECK_THAT(refusal(good, {.schedule = {.substeps = 1, .iterations = -1}}),
               Catch::Contains("iterations"));
    CHECK_THAT(refusal(good, {.schedule = {.frameRate = {0, 1}}}), Catch::Contains("frame"));

    // What a float cannot hold is no number either.
    for (const double bad : {notANumber, infinity, 1e40}) {
        CHECK(spoilt([&](World& w) { w.start[2].z = bad; }) ==
              "vertex 2 does not start at a number");
        CHECK(spoilt([&](World& w) { w.velocity[0].x = bad; }) ==
              "vertex 0 does not start at a number");
    }
    CHECK(spoilt([](World& w) { w.mass[0] = 1e-40; }) == "vertex 0 has no mass");

    for (const auto& spoil : std::initializer_list<void (*)(World&)>{
             [](World& w) { w.mass.pop_back(); }, [](World& w) { w.velocity.pop_back(); },
             [](World& w) { w.pinned.pop_back(); }, [](World& w) { w.rest.pop_back(); }})
        CHECK(spoilt(spoil) == "a world must have one entry a vertex in each of its arrays");

    World world = good;
    CHECK_THROWS_WITH(world.pin({0, 3}), "pin: there is no vertex 3");
    CHECK_THROWS_WITH(world.pin({-1}), "pin: there is no vertex -1");
    CHECK(world.pinned == good.pinned);

    Solver<double> solver(good, {});
    const Points here = solver.positions();
    Points nowhere = here;
    nowhere[1].y = notANumber;
    CHECK_THROWS_AS(solver.setPast({here.data(), 2}, here), std::invalid_argument);
    CHECK_THROWS_AS(solver.setPast(nowhere, here), std::invalid_argument);
    CHECK_THROWS_AS(solver.setPast(here, nowhere), std::invalid_argument);
    CHECK_NOTHROW(solver.hash());
}

// Wherever in a frame it comes: in predictions, sweeps, searches and rounds of contacts.
TEST_CASE("failures: an interrupt within a frame leaves it as it began", "[failures][strangers]") {
    World world;
    const Range floor =
        world.add(grid({.columns = 3, .rows = 3}, {.origin = {0, 0, 1}, .up = {0, 0, -1}}));
    world.pin(pointStencils(floor));
    const Range sheet =
        world.add(grid({.columns = 8, .rows = 8}, {.origin = {0, 0.004, 1}, .up = {0, 0, -1}}));
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest),
                    {.name = "links"});
    world.act<Gravity>(GravityOptions{});
    meet(world, {{.vertices = floor}, {.vertices = sheet}});
    struct Enough {};
    SolverOptions options = tenSubsteps;
    long calls = 0, last = -1;
    options.interrupt = [&] {
        if (++calls == last) throw Enough();
    };
    Solver<float> whole(world, tenSubsteps), broken(world, options);
    for (int frame = 0; frame < 3; ++frame) {
        whole.frame();
        if (frame == 0) {
            Solver<float>(world, options).frame();
            REQUIRE(calls > 10 * 6);  // several times a substep
        }
        const long most = calls;
        for (const long at : {1L, most / 3, most / 2}) {  // less, once pairs are known
            calls = 0, last = at;
            const auto before = broken.hash();
            CHECK_THROWS_AS(broken.frame(), Enough);
            CHECK(broken.hash() == before);
        }
        calls = 0, last = -1;
        broken.frame();
        CHECK(broken.hash() == whole.hash());
    }
}
