// The solver as a machine: failures with a name, bad input refused, work counted.

#include <limits>

#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/solver.h>

using namespace plait;
using plait::test::linksOf;
using plait::test::loosePoints;
using plait::test::plumbLine;

namespace {

template <class Real>
struct PoisonWind : Force<Real> {
    PoisonWind(const World&, double from) : from_(from) {}
    std::string name() const override { return "poison wind"; }
    void apply(State<Real>& state, double t, double, Workers&) override {
        if (t >= from_) state.velocity[0].v.x = std::numeric_limits<Real>::infinity();
    }
    double from_;
};

// A poison by time rather than by count, because the frame is taken twice to find it.
template <class Real>
struct TimedPoison : Constraint<Real> {
    explicit TimedPoison(double time) : from(time) {}
    void beginFrame(double t0, double t1) override { start = t0, length = t1 - t0; }
    void begin(const Substep& substep, Workers&) override {
        bad = start + substep.frameFraction * length > from;
    }
    void project(const Sweep<Real>& sweep, Direction, Workers&) override {
        if (bad) sweep.particles[4] = std::numeric_limits<Real>::quiet_NaN();
    }
    long size() const override { return 1; }
    double from, start = 0, length = 0;
    bool bad = false;
};

Recipe<Constraint> poisonFrom(double time) {
    return {
        [time](const World&, KernelChoice) { return std::make_unique<TimedPoison<float>>(time); },
        [time](const World&, KernelChoice) { return std::make_unique<TimedPoison<double>>(time); }};
}

World fallingPoints() {
    World world = loosePoints({{0, 0, 0}, {1, 0, 0}});
    world.act<Gravity>(GravityOptions{});
    world.constrain(restRows<Stretch>({0, 1}, world.rest), {.name = "links"});
    return world;
}

std::string refusal(const World& world, const SolverOptions& options) {
    try {
        Solver<double> solver(world, options);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("solver: what makes a number that is not finite is named", "[solver]") {
    const SolverOptions options{.schedule = {.substeps = 10, .iterations = 1}};
    World world = fallingPoints();
    world.constrain(poisonFrom(2.55 / 24), {.name = "poison", .order = 3});
    Solver<float> solver(world, options);
    solver.frame();
    solver.frame();
    const std::uint64_t before = solver.hash();
    try {
        solver.frame();
        FAIL("no exception");
    } catch (const Diverged& diverged) {
        REQUIRE(diverged.culprit == "poison");
        REQUIRE(diverged.substep == 25);
        REQUIRE(std::string(diverged.what()).find("poison") != std::string::npos);
    }
    REQUIRE(solver.hash() == before);  // and the state is that of the frame's start

    World blown = fallingPoints();
    blown.act<PoisonWind>(1.0 / 24);
    Solver<double> windy(blown, options);
    windy.frame();
    REQUIRE_THROWS_WITH(windy.frame(), Catch::Contains("poison wind"));
}

TEST_CASE("solver: bad input is refused with one line that names it", "[solver]") {
    const World world = fallingPoints();
    REQUIRE(refusal(world, {}) == "accepted");
    REQUIRE_THAT(refusal(world, {.timeScale = 0}), Catch::Contains("time scale"));
    REQUIRE_THAT(refusal(world, {.damping = 1.5}), Catch::Contains("damping"));
    REQUIRE_THAT(refusal(world, {.smoothing = -1}), Catch::Contains("smoothing"));
    REQUIRE_THAT(refusal(world, {.maxAcceleration = -1}), Catch::Contains("acceleration"));
    REQUIRE_THAT(refusal(world, {.threads = 0}), Catch::Contains("threads"));
    REQUIRE_THAT(refusal(world, {.schedule = {.substeps = 0}}), Catch::Contains("substeps"));
    REQUIRE_THAT(refusal(world, {.kernels = {Isa::v2, 3}}), Catch::Contains("3 lanes"));

    World heavy = world;
    heavy.mass[1] = 0;
    REQUIRE_THAT(refusal(heavy, {}), Catch::Contains("vertex 1 has no mass"));
    heavy.pin({1});
    REQUIRE(refusal(heavy, {}) == "accepted");
    World nowhere = world;
    nowhere.start[0].y = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_THAT(refusal(nowhere, {}), Catch::Contains("vertex 0"));

    World far = world;
    far.constrain(Rows<Stretch>{{0, 7}, {{1, 0, 0}}, {}, {}}, {.name = "far links"});
    REQUIRE_THAT(refusal(far, {}), Catch::Contains("far links"));
    World mixed = world;
    mixed.constrain(Rows<Stretch>{{0, 1, 1, 0}, {{1, 0, 0}, {1, 0, 0}}, {0, 0}, {}},
                    {.name = "one colour"});
    REQUIRE_THAT(refusal(mixed, {}), Catch::Contains("one colour"));
    World short_ = world;
    short_.constrain(Rows<Stretch>{{0}, {{1, 0, 0}}, {}, {}}, {.name = "half a link"});
    REQUIRE_THAT(refusal(short_, {}), Catch::Contains("half a link"));

    World bad;
    REQUIRE_THROWS_WITH(bad.add(chain({}), {.density = 0}), Catch::Contains("density"));
    REQUIRE_THROWS_WITH(bad.add(chain({}), {.start = {{0, 0, 0}}}), Catch::Contains("start"));
    REQUIRE_THROWS_WITH(bad.constrain(Rows<Stretch>{}, {.name = "x", .damping = 2}),
                        Catch::Contains("damping"));
}

TEST_CASE("solver: worlds with nothing in them run", "[solver]") {
    Solver<float> empty(World{}, {});
    empty.frame();
    World alone = loosePoints({{0, 1, 0}});
    Solver<double> still(alone, {});
    still.frame();
    REQUIRE(still.positions()[0] == Vec<double>{0, 1, 0});
    World unlinked = loosePoints({{0, 1, 0}, {2, 0, 0}});
    unlinked.constrain(Rows<Stretch>{}, {.name = "none"});
    Solver<float> none(unlinked, {.smoothing = 3, .threads = 2});
    none.frame();
    REQUIRE(none.evaluations() == 0);
}

TEST_CASE("solver: counted work is rows times sweeps", "[solver]") {
    const World world = fallingPoints();
    for (const Sweeps sweeps : {Sweeps::palindrome, Sweeps::oneWay, Sweeps::alternating}) {
        Solver<double> solver(world,
                              {.sweeps = sweeps, .schedule = {.substeps = 7, .iterations = 3}});
        std::vector<LogMark> log;
        solver.log = &log;
        solver.frame();
        REQUIRE(log.size() == 21);  // one mark an evaluation, whichever its direction
        REQUIRE(solver.evaluations() == (sweeps == Sweeps::palindrome ? 42 : 21));
    }
}

// Plain loops in double, no colours, no lanes, no multipliers' tricks: the readable twin. Links in
// the order of their colours, forward and backward, then the floor.
TEST_CASE("solver: agrees with a serial twin", "[solver][IN9][MS7]") {
    const int n = 12;
    World world = plumbLine({.links = n, .length = 0.1, .mass = 0.3});
    for (std::size_t i = 1; i < world.start.size(); ++i)
        world.velocity[i] = {0.4 * double(i), 0, 0.1};
    Rows<Stretch> links = linksOf(world, 1e-4);
    for (int i = 0; i < n; ++i) links.colors.push_back((i * 5) % n);
    world.constrain(links, {.name = "links"});
    auto floor = restRows<PlaneContact>(pointStencils({0, n + 1}), world.rest);
    for (auto& row : floor.rows) row = {{0, -1.15, 0}, {0, 1, 0}, 0};
    world.constrain(floor, {.name = "floor", .order = 1});
    const int substeps = 20;
    Solver<double> solver(
        world, {.schedule = {.substeps = substeps, .iterations = 2, .collisionPasses = 1}});

    const double h = 1.0 / (24 * substeps);
    std::vector<Vec<double>> x = world.start, v = world.velocity;
    std::vector<double> lambda, push;
    const auto link = [&](int i) {
        const auto a = static_cast<std::size_t>(i), b = a + 1;
        const double wa = a == 0 ? 0 : 1 / world.mass[a], wb = 1 / world.mass[b];
        const Vec<double> d = x[b] - x[a];
        const double C = length(d) - 0.1, alpha = 1e-4 / (h * h);
        const double change = (-C - alpha * lambda[a]) / (wa + wb + alpha);  // (XPBD Eq. 18)
        lambda[a] += change;
        x[a] -= (wa * change / length(d)) * d;
        x[b] += (wb * change / length(d)) * d;
    };
    const auto floorAt = [&](std::size_t i) {
        if (i == 0) return;
        const double w = 1 / world.mass[i], C = x[i].y + 1.15;
        const double lifted = std::max(0.0, push[i] - C / w);
        x[i].y += w * (lifted - push[i]);
        push[i] = lifted;
    };
    double worst = 0;
    for (int frame = 0; frame < 6; ++frame) {
        solver.frame();
        for (int s = 0; s < substeps; ++s) {
            const std::vector<Vec<double>> before = x;
            lambda.assign(n, 0);
            push.assign(x.size(), 0);
            for (std::size_t i = 1; i < x.size(); ++i) {
                v[i].y -= 9.81 * h;
                x[i] += h * v[i];
            }
            for (int column = 0; column < 2; ++column) {
                std::vector<int> order(n);
                for (int i = 0; i < n; ++i) order[static_cast<std::size_t>((i * 5) % n)] = i;
                for (int i = 0; i < n; ++i) link(order[static_cast<std::size_t>(i)]);
                for (int i = n; i-- > 0;) link(order[static_cast<std::size_t>(i)]);
                if (column == 0) continue;  // one collision pass: in the last column
                for (int pass = 0; pass < 2; ++pass)
                    for (std::size_t i = 0; i < x.size(); ++i) floorAt(i);
            }
            for (std::size_t i = 0; i < x.size(); ++i) v[i] = (1 / h) * (x[i] - before[i]);
        }
        const std::vector<Vec<double>> fast = solver.positions();
        for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, length(fast[i] - x[i]));
    }
    REQUIRE(test::report("solver against its serial twin, m", worst, 1e-12));
}
