// What the schedule (design section 5) does in the solver: which set is evaluated when, by the log;
// what is left of stiffness where evaluations are weakened, left out, or followed by smoothing.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/sheet.h"

#include <plait/measure/momentum.h>

#include <cmath>
#include <memory>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// A set of a user's own: it only notes its calls (S figure 13).
template <class Real>
class Probe : public Constraint<Real> {
public:
    explicit Probe(std::shared_ptr<std::vector<Direction>> calls) : calls_(std::move(calls)) {}
    void project(const Sweep<Real>&, Direction direction, Workers&) override {
        calls_->push_back(direction);
    }
    long size() const override { return 1; }

private:
    std::shared_ptr<std::vector<Direction>> calls_;
};

Recipe<Constraint> probe(const std::shared_ptr<std::vector<Direction>>& calls) {
    return {[=](const World&, KernelChoice) { return std::make_unique<Probe<float>>(calls); },
            [=](const World&, KernelChoice) { return std::make_unique<Probe<double>>(calls); }};
}

Recipe<Constraint> probe() { return probe(std::make_shared<std::vector<Direction>>()); }

Rows<PlaneContact> floorUnder(const World& world) {
    auto rows = restRows<PlaneContact>(pointStencils({0, static_cast<int>(world.start.size())}),
                                       world.start);
    for (auto& row : rows.rows) row = {{0, -2, 0}, {0, 1, 0}, 0};
    return rows;
}

// Sets as of S figure 9, not in their order, by importances; bend would be last but for contacts.
World figureWorld(int bend, int stretch, int floor, int other) {
    World world = plumbLine({.links = 2});
    world.constrain(probe(), {.name = "collisions", .order = 4, .importance = other}, true);
    world.constrain(linksOf(world), {.name = "stretch", .order = 2, .importance = stretch});
    world.constrain(floorUnder(world), {.name = "floor", .order = 3, .importance = floor});
    world.constrain(probe(), {.name = "bend", .order = 9, .importance = bend});
    return world;
}

// The log as the schedule has it: set by set in the order run.
std::vector<LogMark> planned(const Schedule& schedule, long substeps, Sweeps sweeps) {
    std::vector<LogMark> marks;
    SubstepPlan plan;
    for (long s = 0; s < substeps; ++s) {
        schedule.plan(s, plan);
        for (int c = 0; c < static_cast<int>(plan.columns.size()); ++c)
            for (const auto sets : {plan.constraints(plan.columns[static_cast<std::size_t>(c)]),
                                    plan.contacts(plan.columns[static_cast<std::size_t>(c)])}) {
                std::vector<int> order(sets.begin(), sets.end());
                if (sweeps == Sweeps::alternating && s % 2 == 1)
                    std::reverse(order.begin(), order.end());
                for (const int set : order) marks.push_back({s, c, set});
            }
    }
    return marks;
}

bool same(const std::vector<LogMark>& a, const std::vector<LogMark>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const LogMark& x, const LogMark& y) {
                          return x.substep == y.substep && x.column == y.column && x.set == y.set;
                      });
}

int countOf(const std::vector<LogMark>& log, int set) {
    return static_cast<int>(
        std::count_if(log.begin(), log.end(), [=](const LogMark& m) { return m.set == set; }));
}

}  // namespace

TEST_CASE("the solver runs its schedule, mark for mark",
          "[interleaving][SC1][SC7][SC9][SC14][SC5]") {
    int runs = 0;
    for (const int substeps : {1, 2, 3, 5, 10, 20, 30})
        for (const int stretch : {1, 4, 10, 26, 500})
            for (const int floor : {1, 4, 10, 20, 37}) {
                const World world = figureWorld(9, stretch, floor, 6);
                const auto sweeps =
                    std::array{Sweeps::palindrome, Sweeps::oneWay, Sweeps::alternating}[runs++ % 3];
                for (const ScheduleMode mode :
                     {ScheduleMode::interleaved, ScheduleMode::sequential}) {
                    SolverOptions options{.sweeps = sweeps};
                    options.schedule = {.substeps = substeps, .mode = mode};
                    Solver<float> solver(world, options);
                    std::vector<LogMark> log;
                    solver.log = &log;
                    advance(solver, 2);
                    REQUIRE(same(log, planned(solver.schedule(), 2 * substeps, sweeps)));
                    for (const auto& [set, importance] :
                         {std::pair{0, 6}, {1, stretch}, {2, floor}, {3, 9}})
                        REQUIRE(countOf(log, set) == 2 * std::max(importance, substeps));
                    for (std::size_t i = 1; i <= log.size(); ++i)  // contact is the last word
                        if (i == log.size() || log[i].substep != log[i - 1].substep)
                            REQUIRE((log[i - 1].set == 0 || log[i - 1].set == 2));
                }
            }
}

TEST_CASE("collision passes lie evenly among iterations", "[interleaving][SC17]") {
    const World world = figureWorld(9, 26, 4, 6);
    SolverOptions options;
    options.schedule = {.substeps = 2, .iterations = 100, .collisionPasses = 10};
    Solver<double> solver(world, options);
    std::vector<LogMark> log;
    solver.log = &log;
    solver.frame();
    REQUIRE(same(log, planned(solver.schedule(), 2, Sweeps::palindrome)));
    REQUIRE(countOf(log, 1) == 200);
    REQUIRE(countOf(log, 3) == 200);
    REQUIRE(countOf(log, 2) == 20);
    for (const LogMark& mark : log)
        if (mark.set == 2) REQUIRE(mark.column % 10 == 9);
}

// S figure 13: an order above a contact's and its importance put a set behind every evaluation of
// it. Under palindromes an evaluation is there and back, so the set is called in the middle of it,
// twice.
TEST_CASE("a set from outside follows the set it is registered behind", "[interleaving][AR12]") {
    for (const int substeps : {1, 2, 3, 7, 10, 20})
        for (const Sweeps sweeps : {Sweeps::palindrome, Sweeps::oneWay}) {
            World world = figureWorld(9, 26, 7, 6);
            world.sets[0].options.order = 5;
            const auto calls = std::make_shared<std::vector<Direction>>();
            world.constrain(probe(calls), {.name = "custom", .order = 4, .importance = 7}, true);
            SolverOptions options{.sweeps = sweeps};
            options.schedule = {.substeps = substeps};
            Solver<double> solver(world, options);
            std::vector<LogMark> log;
            solver.log = &log;
            advance(solver, 3);
            const int floor = 2, custom = 4;
            REQUIRE(countOf(log, floor) == 3 * std::max(7, substeps));
            REQUIRE(countOf(log, custom) == countOf(log, floor));
            REQUIRE(log.back().set != custom);
            for (std::size_t i = 0; i + 1 < log.size(); ++i) {
                REQUIRE((log[i].set == floor) == (log[i + 1].set == custom));
                if (log[i].set == floor) REQUIRE(log[i].column == log[i + 1].column);
            }
            const bool both = sweeps == Sweeps::palindrome;
            REQUIRE(static_cast<int>(calls->size()) == countOf(log, custom) * (both ? 2 : 1));
            for (std::size_t i = 0; i < calls->size(); ++i)
                REQUIRE((*calls)[i] ==
                        (both && i % 2 == 1 ? Direction::backward : Direction::forward));
        }
}

// A link at rest: a substep adds g h^2, an evaluation leaves 1 - strength of what there is, a
// palindrome that part of that part. Where the substeps n are more than the importance I, strength
// is I / n, and with r = (1 - I / n)^2 the link droops by g h^2 r / (1 - r): in the end as 1 / n,
// since every correction is made against g h^2. That is nucleus, and it is so too where n is below
// I and nothing is weakened; so what weakening keeps is not the droop itself, as the guide has it,
// but its law: droop times substeps. A set evaluated once a substep at full strength falls as 1 /
// n^2.
TEST_CASE("weakened evaluations keep the intensity", "[interleaving][SC7][SC8]") {
    const auto droop = [](int links, int importance, int substeps, int iterations = 0) {
        World world = plumbLine({.links = links});
        world.constrain(linksOf(world), {.name = "stretch", .importance = importance});
        SolverOptions options{.method = Method::nucleus, .damping = 0.5};
        options.schedule = {.substeps = substeps, .iterations = iterations};
        Solver<double> solver(world, options);
        advance(solver, 40);
        while (topSpeed(solver) > 1e-9) advance(solver, 4);
        return -solver.positions().back().y - links;
    };
    for (const int substeps : {2, 5, 20, 80}) {
        const double h = 1.0 / (24 * substeps), left = std::pow(1 - 1.0 / substeps, 2);
        const double exact = 9.81 * h * h * left / (1 - left);
        REQUIRE(report(
            "one link, importance 1, " + std::to_string(substeps) + " substeps, droop, relative",
            std::fabs(droop(1, 1, substeps) / exact - 1), 1e-6));
    }
    double least = 1e30, most = 0;
    for (const int substeps : {1, 2, 5, 10, 20, 40, 80}) {
        const double d = substeps * droop(20, 10, substeps);
        note("chain of 20, importance 10, " + std::to_string(substeps) +
                 " substeps, droop times substeps",
             d);
        least = std::min(least, d);
        most = std::max(most, d);
    }
    REQUIRE(report("    largest over smallest, less 1", most / least - 1, 0.25));
    REQUIRE(80 * droop(20, 10, 80, 1) < 0.15 * 10 * droop(20, 10, 10, 1));
}

// A fringe of eight links, clamped level, that bends in every 1st, 2nd or 4th pass of stretch.

TEST_CASE("a secondary pass is for soft bending only", "[interleaving][SC20]") {
    struct Fringe {
        double droop;  // m
        int bends;     // evaluations of bending in a frame
        long work;
    };
    const auto hang = [](double weightOverStiffness, int interval, int iterations = 8) {
        const double length = 0.4, density = 0.01, free = length * 7 / 8;
        World world;
        const Range all =
            world.add(chain({.links = 8, .to = {length, 0, 0}}), {.density = density});
        world.pin({0, 1});
        world.act<Gravity>(GravityOptions{});
        world.constrain(linksOf(world), {.name = "stretch"});
        const double stiffness = density * 9.81 * free * free * free / weightOverStiffness;
        world.constrain(curveBendRows(world.complex, all, world.rest, stiffness),
                        {.name = "bend", .order = 1, .secondaryInterval = interval});
        SolverOptions options{.damping = 0.5};
        options.schedule = {.substeps = 20, .iterations = iterations};
        Solver<double> solver(world, options);
        advance(solver, 10);
        while (topSpeed(solver) > 1e-6) solver.frame();
        std::vector<LogMark> log;
        solver.log = &log;
        const long before = solver.evaluations();
        solver.frame();
        return Fringe{-solver.positions().back().y, countOf(log, 1), solver.evaluations() - before};
    };
    for (const bool leather : {false, true}) {
        const double ratio = leather ? 0.3 : 30, exact = hang(ratio, 1, 32).droop;
        const std::string what = leather ? "leather" : "silk";
        Fringe f[3];
        for (int i = 0; i < 3; ++i) {
            f[i] = hang(ratio, 1 << i);
            REQUIRE(f[i].bends == 160 >> i);
            note(what + ", bending in 1 of " + std::to_string(1 << i) + " passes, droop / exact",
                 f[i].droop / exact);
        }
        REQUIRE(f[1].work == f[0].work - 80 * 2 * 7);
        REQUIRE(f[2].work == f[0].work - 120 * 2 * 7);
        if (leather) {
            REQUIRE(f[0].droop < 1.03 * exact);
            REQUIRE(f[1].droop > 1.08 * exact);
            REQUIRE(f[2].droop > 1.3 * exact);
        } else {
            for (const Fringe& soft : f) REQUIRE(std::fabs(soft.droop / exact - 1) < 0.002);
        }
    }
}

TEST_CASE("smoothing spreads the error and keeps momentum", "[interleaving][SC16]") {
    const int n = 12;
    const auto sheet = [=](std::uint64_t seed) {
        World world;
        world.add(grid({.columns = n, .rows = n}), {.density = 0.2});
        Random random(seed);
        Rows<Stretch> links = sheetLinks(world, n, n);
        for (auto& row : links.rows) row.rest *= random.uniform(0.9, 1.1);
        world.constrain(links, {.name = "stretch"});
        return std::pair{world, links};
    };
    const auto unevenness = [&](int iterations, int smoothing) {
        auto [world, links] = sheet(5);
        world.pin({0, n - 1});
        world.act<Gravity>(GravityOptions{.acceleration = {0, 9.81, 0}});
        SolverOptions options{.smoothing = smoothing, .damping = 0.1};
        options.schedule = {.substeps = 4, .iterations = iterations};
        Solver<double> solver(world, options);
        advance(solver, 100);
        double most = 0, sum = 0;
        for (const double e : strainsOf(links, solver.positions())) {
            most = std::max(most, std::fabs(e));
            sum += std::fabs(e);
        }
        return most / (sum / links.size());
    };
    const double rough = unevenness(4, 0), smooth = unevenness(4, 10), equal = unevenness(9, 0);
    note("largest over mean strain, 4 palindromes", rough);
    note("    9 palindromes", equal);
    note("    4 palindromes and 10 smoothing iterations, of equal work", smooth);
    REQUIRE(smooth < 0.5 * rough);
    REQUIRE(smooth < 0.8 * equal);

    auto [world, links] = sheet(6);
    Random random(8);
    double scale = 0;
    for (std::size_t i = 0; i < world.mass.size(); ++i) {
        world.velocity[i] = random.point(1) + Vec<double>{1, 2, 3};
        scale += world.mass[i] * length(world.velocity[i]);
    }
    SolverOptions options{.smoothing = 10};
    options.schedule = {.substeps = 4, .iterations = 2};
    Solver<double> solver(world, options);
    const Vec<double> before = momentum(world.mass, solver.velocities());
    advance(solver, 24);
    REQUIRE(report("free sheet, smoothing 10, change of momentum, relative",
                   length(momentum(world.mass, solver.velocities()) - before) / scale, 1e-12));
}

// V's first guess of how many: the edges that lie between what is furthest apart. Sweeps carry a
// pull along a chain by two links an iteration where links of one colour are solved at once, and
// none is carried further than that.
TEST_CASE("as many iterations as edges lie between let all ends know", "[interleaving][SC15]") {
    constexpr int links = 32;
    const auto after = [](int iterations) {
        World world;
        Points start;
        for (int i = 0; i <= links; ++i) start.push_back({0.1 * i, 0, 0});
        start[0].x = -0.1;
        const Range whole = world.add(chain({.links = links, .to = {0.1 * links, 0, 0}}),
                                      {.density = 1, .start = start});
        world.pin({whole.first});
        world.constrain(linksOf(world), {.name = "links"});
        SolverOptions options;
        options.schedule = {.substeps = 1, .iterations = iterations};
        options.sweeps = Sweeps::oneWay;
        Solver<double> solver(world, options);
        solver.frame();
        const Points x = solver.positions();
        int reached = 0;
        double off = 0;
        for (int i = 1; i <= links; ++i) {
            if (x[i].x != start[i].x) reached = i;
            off = std::max(off, std::fabs(x[i].x - x[i - 1].x - 0.1));
        }
        return std::pair{reached, off};
    };
    CHECK(after(links / 4).first < links);
    double before = after(links / 4).second;
    for (const int iterations : {links, 4 * links, 16 * links}) {
        const auto [reached, off] = after(iterations);
        note("greatest error of a link, parts of its length, iterations " +
                 std::to_string(iterations),
             off / 0.1);
        CHECK(reached == links);
        CHECK(off < before);
        before = off;
    }
}
