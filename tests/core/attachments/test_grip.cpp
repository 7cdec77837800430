// A hand that takes hold in flight, carries and lets go.
#include "tests/catch.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/report.h"

#include <plait/attachments/grip.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/solver.h>

#include <limits>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double from = 0.25, to = 0.75;

// It turns at 3 rad/s and goes to and fro.
Frame handAt(double t) {
    return {.origin = {0.2 * sine(4 * t), 0.3 * t, 0.1},
            .across = {cosine(3 * t), 0, -sine(3 * t)},
            .up = {0, 1, 0}};
}

// Three points that fall and fly apart, the first two of them to be taken; the third is pinned.
World points(bool gripped) {
    World world;
    addPoint(world, {0.1, 0, 0}, 1, {1, 0, 0});
    addPoint(world, {-0.3, 0.2, 0.4}, 2, {0, 2, 0});
    addPoint(world, {1, 0, 0});
    world.pin({2});
    world.act<Gravity>(GravityOptions{});
    if (gripped) addGrip(world, {.vertices = {0, 1, 2}, .hand = handAt, .from = from, .to = to});
    return world;
}

SolverOptions options() { return {.schedule = {.substeps = 8, .frameRate = {240, 1}}}; }

}  // namespace

TEMPLATE_TEST_CASE("grip: the place in the hand is kept, and then let go of",
                   "[attachments][AT1][FX25]", float, double) {
    const double accuracy = sizeof(TestType) == sizeof(float) ? 1e-6 : 1e-14;
    Solver<TestType> held(points(true), options()), free(points(false), options());
    double slip = 0, flight = 0;
    std::vector<Vec<double>> own, lastVelocity;
    for (int frame = 1; frame <= 240; ++frame) {
        held.frame(), free.frame();
        const double t = frame / 240.0;
        const auto x = held.positions(), v = held.velocities();
        CHECK(x[2] == Vec<double>{1, 0, 0});
        if (t < from - 1e-9) {
            CHECK(held.hash() != 0);
            CHECK(x[0] == free.positions()[0]);
            continue;
        }
        const Placement hand(handAt(t), "hand");
        if (own.empty())
            for (int i = 0; i < 2; ++i) own.push_back(hand.own(x[static_cast<std::size_t>(i)]));
        for (std::size_t i = 0; i < 2; ++i) {
            if (t <= to + 1e-9) {
                slip = std::max(slip, length(hand.own(x[i]) - own[i]));
            } else {
                const Vec<double> gained = v[i] - lastVelocity[i];
                flight = std::max(flight, length(gained - Vec<double>{0, -9.81 / 240, 0}));
            }
        }
        lastVelocity = v;
    }
    CHECK(report("slip in the hand, m", slip, accuracy));
    CHECK(report("flight after it, off from free fall in 1/240 s, m/s", flight, 100 * accuracy));
}

TEST_CASE("grip: resumed while it holds, a run has the same bits", "[attachments][determinism]") {
    Solver<float> whole(points(true), options()), resumed(points(true), options());
    for (int frame = 0; frame < 100; ++frame) whole.frame();
    resumed.restore(whole.state(), whole.evaluations());
    for (int frame = 0; frame < 100; ++frame) whole.frame(), resumed.frame();
    CHECK(whole.hash() == resumed.hash());
    whole.rewind();
    for (int frame = 0; frame < 200; ++frame) whole.frame();
    CHECK(whole.hash() == resumed.hash());
}

TEST_CASE("grip: what makes no sense is refused by name", "[attachments]") {
    World world = points(false);
    const auto refused = [&](const Grip& grip) {
        CHECK_THROWS_AS(addGrip(world, grip, {.name = "hand"}), std::invalid_argument);
    };
    refused({.vertices = {0}, .hand = {}});
    refused({.vertices = {0, 0}, .hand = handAt});
    refused({.vertices = {3}, .hand = handAt});
    refused({.vertices = {0}, .hand = handAt, .from = 2, .to = 1});
    refused({.vertices = {0}, .hand = handAt, .to = std::numeric_limits<double>::quiet_NaN()});
    CHECK(world.sets.empty());
}
