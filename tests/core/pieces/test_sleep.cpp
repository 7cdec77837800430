// Islands of pieces that rest fall asleep, and wake.
#include "piece_pile.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/contacts/self_collision.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double side = 0.1, thick = 1e-3, g = 9.81;
constexpr SleepOptions sleeping{.speed = 0.02, .delay = 0.5};

SolverOptions everySubstep(int rate, int threads = 1) {
    SolverOptions every = options(1, 8, threads);
    every.schedule.frameRate = {rate, 1};
    return every;
}

int addBox(Pile& pile, double x, double y, const Vec<double>& velocity = {}, double z = 0) {
    return pile.add(box({side, side, side}),
                    {.density = 1000, .shift = {x, y, z}, .velocity = velocity}, thick, 0.5);
}

double heightOf(int level) { return side / 2 + 2 * thick + level * (side + 2 * thick); }

// Three boxes on each other, and one that slides along the floor to them from x (m).
Pile towerAnd(double x, double speed, const SleepOptions& sleep, double z = 0) {
    Pile pile;
    for (int i = 0; i < 3; ++i) addBox(pile, 0, heightOf(i));
    addBox(pile, x, heightOf(0), {speed, 0, 0}, z);
    pile.floor(thick, 0.5);
    pile.meet({0, -g, 0}, 0.5, sleep);
    return pile;
}

template <class Real>
bool asleep(const Pile& pile, const Solver<Real>& solver, int piece) {
    return solver.state().particles[pile.pieces[piece].vertices.first].w == Real(0);
}

template <class Real>
double speedOf(const Pile& pile, const Solver<Real>& solver, int piece) {
    const auto v = solver.velocities();
    double most = 0;
    for (int i = pile.pieces[piece].vertices.first; i < pile.pieces[piece].vertices.last; ++i)
        most = std::max(most, length(v[i]));
    return most;
}

}  // namespace

TEST_CASE("sleep: what has been slow for the delay sleeps, within a substep",
          "[pieces][SL1][SL2]") {
    constexpr int rate = 240;
    const Pile pile = towerAnd(-1, 1, sleeping);
    Solver<float> solver(pile.world, everySubstep(rate));
    std::array<int, 4> slowSince{}, fell{};
    for (int i = 1; i <= 2 * rate; ++i) {
        solver.frame();
        for (int p = 0; p < 4; ++p) {
            if (asleep(pile, solver, p) && fell[p] == 0) fell[p] = i;
            if (!asleep(pile, solver, p) && speedOf(pile, solver, p) > sleeping.speed)
                slowSince[p] = i;
            if (asleep(pile, solver, p)) CHECK(speedOf(pile, solver, p) == 0);
        }
    }
    for (int p = 0; p < 4; ++p) {
        REQUIRE(fell[p] > 0);
        const int since =
            p < 3 ? *std::max_element(slowSince.begin(), slowSince.begin() + 3) : slowSince[3];
        CHECK(std::abs(fell[p] - since - rate / 2) <= 1);
    }
    CHECK(slowSince[3] > 20);  // it slid, and did not begin to count before
}

TEST_CASE("sleep: the work that it saves", "[pieces][SL1]") {
    std::array<double, 2> work{};
    for (const bool on : {false, true}) {
        const Pile pile = towerAnd(-1, 0, on ? sleeping : SleepOptions{});
        Solver<float> solver(pile.world, options(10, 8));
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        const long before = solver.evaluations();
        const auto start = solver.positions();
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        work[on] = static_cast<double>(solver.evaluations() - before);
        if (on)
            CHECK(solver.hash() == [&] {
                solver.frame();
                return solver.hash();
            }());
    }
    note("evaluations in a second, awake", work[0]);
    note("evaluations in a second, asleep", work[1]);
    CHECK(work[1] < work[0] / 4);
}

TEST_CASE("sleep: an island wakes when it is touched, and goes as if it had not slept",
          "[pieces][SL3]") {
    constexpr SleepOptions soon{.speed = 0.02, .delay = 0.25};
    std::array<std::vector<Vec<double>>, 2> ends;
    for (const bool on : {false, true}) {
        // It needs more than the delay to get there, and strikes off the middle: face to face at 5
        // m/s the tower turns one way or the other, and a start 1 mm farther moves it by 14 mm.
        const Pile pile = towerAnd(-2, 4.5, on ? soon : SleepOptions{}, 0.03);
        Solver<double> solver(pile.world, everySubstep(480));
        bool slept = false, woke = false;
        for (int i = 0; i < 3 * 480; ++i) {
            solver.frame();
            const bool now = asleep(pile, solver, 0);
            CHECK(now == asleep(pile, solver, 2));
            slept = slept || now;
            woke = woke || (slept && !now);
        }
        CHECK(slept == on);
        CHECK(woke == on);
        for (int p = 0; p < 4; ++p) ends[on].push_back(pile.middle(solver.positions(), p));
        note("how far the lowest was pushed, m", ends[on][0].x);
        CHECK(ends[on][0].x > 0.01);
    }
    // In the substep in which it wakes nothing has weight, nor friction by it.
    for (int p = 0; p < 4; ++p)
        CHECK(report("awake or asleep before, m", length(ends[0][p] - ends[1][p]), 3e-3));
}

TEST_CASE("sleep: what lies on something that moves away wakes and falls", "[pieces][SL3]") {
    Pile pile;
    for (int i = 0; i < 2; ++i) addBox(pile, 0, heightOf(i));
    const int floor = pile.add(box({6, 0.2, 6}), {.shift = {0, -0.1, 0}}, thick, 0.5);
    std::vector<int> all(pile.pieces[floor].vertices.size());
    std::iota(all.begin(), all.end(), pile.pieces[floor].vertices.first);
    pile.world.pin(all, [](const Vec<double>& x, double t) {
        return x - Vec<double>{0, 0.5 * std::max(0.0, t - 1.5), 0};
    });
    pile.meet({0, -g, 0}, 0.5, sleeping);
    Solver<float> solver(pile.world, options(10, 8));
    for (int frame = 0; frame < 36; ++frame) solver.frame();
    REQUIRE(asleep(pile, solver, 0));
    REQUIRE(asleep(pile, solver, 1));
    const auto start = solver.positions();
    for (int frame = 0; frame < 24; ++frame) {
        solver.frame();
        CHECK(!asleep(pile, solver, 0));
    }
    const auto end = solver.positions();
    for (int p = 0; p < 2; ++p) {
        const double fell = pile.middle(start, p).y - pile.middle(end, p).y;
        CHECK(report("goes down with its floor", std::fabs(fell - 0.5), 5e-3));
    }
}

TEST_CASE("sleep: the same bits from any number of threads, and resumed while some sleep",
          "[pieces][determinism][threads]") {
    const Pile pile = towerAnd(-2, 5, {.speed = 0.02, .delay = 0.25});
    for (const int at : {9, 11, 20}) {  // asleep; about to be woken; awake
        std::uint64_t expected = 0;
        State<float> middle;
        for (const int threads : {1, 3}) {
            Solver<float> solver(pile.world, options(10, 8, threads));
            for (int frame = 0; frame < at; ++frame) solver.frame();
            if (threads == 1) middle = solver.state();
            for (int frame = at; frame < 60; ++frame) solver.frame();
            if (threads == 1) expected = solver.hash();
            CHECK(solver.hash() == expected);
        }
        Solver<float> resumed(pile.world, options(10, 8, 2));
        resumed.restore(middle, 0);
        for (int frame = at; frame < 60; ++frame) resumed.frame();
        CHECK(resumed.hash() == expected);
    }
}

TEST_CASE("sleep: what is wrong is refused by name", "[pieces]") {
    Pile pile = towerAnd(-1, 0, sleeping);
    meet(pile.world, {pile.surfaces[0]}, {.name = "others"});
    CHECK_THROWS_WITH(Solver<float>(pile.world, options(4, 1)),
                      "contacts: what falls asleep may meet pieces alone");
    CHECK_THROWS_WITH(meetPieces(pile.world, pile.surfaces, {.name = "contacts"}, {.speed = -1}),
                      "contacts: speed and delay of sleep are from 0 on");
}
