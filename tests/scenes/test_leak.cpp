// A balloon that is let go, its neck open: what the jet gives it, and what it takes along.
#include "scenes/balloon/party_balloon.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <cmath>
#include <span>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double outside = 101325, density = 1.2, opens = 0.3, discharge = 0.6;

// Blown up to 2.5 times its size while its neck is held, in no air and no gravity; the neck tilts
// what flies by being off the axis.
struct Flight {
    World world;
    Enclosure enclosure;
    std::vector<double> skin;  // kg, by vertex

    explicit Flight(const Vec<double>& gravity = {}, double leaks = opens) {
        const PartyBalloon party;
        const OpenBalloon balloon = addOpenBalloon(world, party, 2, {0, 0, 0}, {0.6, 0.8, 0});
        enclosure = enclose(world, {balloon.skin}, {.cap = true});
        skin = world.mass;
        std::vector<int> held;
        for (int v = 0; v < balloon.skin.size(); ++v)
            if (balloon.depths[v] < 0.01) held.push_back(balloon.skin.first + v);
        world.pin(held);
        world.letGo(held, opens);
        const double rest = volume(enclosure, world.rest);
        Membrane membrane;
        membrane.rubber.push_back({{}, {party.wall}, party.rubber});
        for (const auto& t : std::span(enclosure.triangles).first(enclosure.skin))
            membrane.rubber[0].triangles.insert(membrane.rubber[0].triangles.end(), t.begin(),
                                                t.end());
        const auto amount = [=](double t) {
            return amountFor(party, rest, 1 + 1.5 * std::min(1.0, t / opens));
        };
        membrane.gases.push_back({enclosure,
                                  {.amount = amount(0)},
                                  amount,
                                  {.hole = {enclosure.caps().begin(), enclosure.caps().end()},
                                   .opens = leaks,
                                   .gravity = gravity}});
        holdMembrane(world, membrane, {.name = "rubber"});
    }

    static SolverOptions options() {
        SolverOptions options;
        options.schedule = {.substeps = 1, .frameRate = {1000, 1}, .iterations = 2};
        return options;
    }
};

template <class Real>
double massAt(const Solver<Real>& solver, int v) {
    return 1 / double(solver.state().particles[static_cast<std::size_t>(v)].w);
}

}  // namespace

// Thrust, gas and momentum by formulas of their own, from where vertices are.
TEMPLATE_TEST_CASE("leak: mass leaves with its momentum, and the jet pushes by 2 c p A", "[gas]",
                   float, double) {
    constexpr bool single = std::is_same_v<TestType, float>;
    const Flight flight;
    Solver<TestType> solver(flight.world, Flight::options());
    while (solver.time() < opens - 1e-4) solver.frame();
    solver.frame();  // let go, and the first that leaks
    const int count = static_cast<int>(flight.skin.size());
    const auto weigh = [&](std::vector<double>& mass) {
        for (int v = 0; v < count; ++v) mass[v] = massAt(solver, v);
    };
    std::vector<double> before(flight.skin.size()), mass(flight.skin.size());
    double jets = 0, missing = 0, gasOff = 0, gone = 0, predicted = 0;
    Vec<double> sum{};
    weigh(before);
    for (int step = 0; step < 200; ++step) {
        const Points was = solver.velocities();
        double gas = 0;
        for (int v = 0; v < count; ++v) gas += before[v] - flight.skin[v];
        solver.frame();
        const Points x = solver.positions(), now = solver.velocities();
        weigh(mass);
        const double p = gas * outside / density / volume(flight.enclosure, x) - outside;
        Vec<double> hole{};
        for (const auto& [a, b, c] : flight.enclosure.caps())
            hole += 0.5 * cross(x[b] - x[a], x[c] - x[a]);
        const double rho = density * (p + outside) / outside, h = 1e-3;
        predicted += p > 0 ? discharge * rho * length(hole) * std::sqrt(2 * p / rho) * h : 0;
        const Vec<double> jet = -2 * discharge * std::max(0.0, p) * h * hole;
        Vec<double> change{};
        for (int v = 0; v < count; ++v) {
            change += mass[v] * now[v] - before[v] * was[v];
            change += (before[v] - mass[v]) * now[v];
            gone += before[v] - mass[v];
        }
        sum += change - jet;
        jets += length(jet);
        missing = std::max(missing, length(sum));
        before = mass;
    }
    const auto& kept = solver.state().kept[0].numbers;
    const double left = (double(kept[0]) + double(kept[1])) * density / outside;
    double gas = 0;
    for (int v = 0; v < count; ++v) gas += mass[v] - flight.skin[v];
    gasOff = std::fabs(gas / left - 1);
    note("the jet's impulse, N s", jets);
    note("gas that left, g", 1000 * gone);
    CHECK(jets > 0.02);
    CHECK(report("momentum of skin, gas and jet, of the jet's", missing / jets,
                 single ? 1e-4 : 1e-9));
    CHECK(report("gas on the skin beside gas inside, off", gasOff, single ? 1e-5 : 1e-12));
    CHECK(report("gas that left beside Bernoulli's, off", std::fabs(gone / predicted - 1),
                 single ? 1e-4 : 1e-9));
}

// The air outside carries the gas inside: let go with a closed neck, skin and gas fall as if the
// skin's weight alone pulled at both.
TEST_CASE("leak: gas inside is heavy and weighs nothing", "[gas]") {
    const Vec<double> g{0, -9.81, 0};
    Flight flight(g, 1e9);
    flight.world.act<Gravity>(GravityOptions{.acceleration = g});
    Solver<double> solver(flight.world, Flight::options());
    while (solver.time() < opens - 1e-4) solver.frame();
    const auto momentum = [&](double& all) {
        Vec<double> sum{};
        all = 0;
        const Points v = solver.velocities();
        for (int i = 0; i < std::ssize(v); ++i) {
            sum += massAt(solver, i) * v[i];
            all += massAt(solver, i);
        }
        return sum;
    };
    double all = 0, skin = 0;
    for (const double m : flight.skin) skin += m;
    solver.frame();
    const Vec<double> from = momentum(all);
    for (int frame = 0; frame < 100; ++frame) solver.frame();
    const Vec<double> pulled = momentum(all) - from;
    note("gas, in the skin's mass", all / skin - 1);
    CHECK(all > 1.5 * skin);
    CHECK(report("pull of gravity beside the skin's weight, off",
                 length(pulled - 0.1 * skin * g) / length(0.1 * skin * g), 1e-6));
}

TEST_CASE("leak: let go, paused and taken up again, it flies the same way", "[gas]") {
    const Flight flight;
    Solver<float> whole(flight.world, Flight::options()), again(flight.world, Flight::options());
    for (int frame = 0; frame < 330; ++frame) whole.frame();
    const State<float> middle = whole.state();
    const long evaluations = whole.evaluations();
    for (int frame = 0; frame < 30; ++frame) whole.frame();
    again.restore(middle, evaluations);
    for (int frame = 0; frame < 30; ++frame) again.frame();
    CHECK(again.hash() == whole.hash());
    const std::uint64_t hash = whole.hash();
    whole.rewind();
    for (int frame = 0; frame < 360; ++frame) whole.frame();
    CHECK(whole.hash() == hash);
}

TEST_CASE("leak: only what is isothermal and goes into a gas leaks", "[gas]") {
    for (const Gas& gas :
         {Gas{.amount = 40, .law = GasLaw::adiabatic}, Gas{.amount = 40, .outside = 0}}) {
        World world;
        const PartyBalloon party;
        const OpenBalloon balloon = addOpenBalloon(world, party, 2, {0, 0, 0}, {0, 1, 0});
        const Enclosure enclosure = enclose(world, {balloon.skin}, {.cap = true});
        Membrane membrane;
        membrane.gases.push_back(
            {enclosure, gas, {}, {.hole = {enclosure.caps().begin(), enclosure.caps().end()}}});
        CHECK_THROWS_WITH(holdMembrane(world, membrane, {.name = "rubber"}),
                          "rubber: what leaks or bursts is isothermal, and goes into a gas");
    }
}
