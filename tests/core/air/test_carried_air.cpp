// The air that a sheet carries, and that the wind carries along it: how much, where to, and what it
// gives back.
#include "air_run.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/air/momentum_filter.h>
#include <plait/solver.h>

#include <algorithm>
#include <numeric>

using namespace plait;
using namespace plait::test;

namespace {

World strip(double length, double width, int columns, int rows, double density) {
    World world;
    world.add(grid({.columns = columns, .rows = rows, .width = length, .height = width}),
              {.density = density});
    return world;
}

double xOf(const World& world, int v) { return world.rest[static_cast<std::size_t>(v)].x; }

// Largest error of what a standing wave of n half lengths carries, of what it should.
double filterError(int columns, double length, double reach, int n, int& unknowns) {
    const World world = strip(length, 0.1 * length, columns, columns / 10, 1);
    const int count = static_cast<int>(world.rest.size());
    const RestFacets facets = restFacets(world, {}, 0.01);
    MomentumFilter filter(facets[1], count, 1, reach);
    unknowns = filter.unknowns();
    const std::vector<double> areas = areaShares(facets, count);
    const double first = std::min_element(world.rest.begin(), world.rest.end(),
                                          [](const auto& a, const auto& b) { return a.x < b.x; })
                             ->x,
                 k = n * std::numbers::pi / length;
    std::vector<double> right, phi(areas.size());
    const auto speed = [&](int v) { return std::cos(k * (xOf(world, v) - first)); };
    for (int v = 0; v < count; ++v) right.push_back(areas[v] * speed(v));
    filter.factor(std::vector<double>(areas.size()));
    filter.solve(right, phi);
    double worst = 0;
    const double part = 1 / (1 + reach * reach * k * k);
    for (int v = 0; v < count; ++v)
        worst = std::max(worst, std::fabs(phi[v] - part * speed(v)) / part);
    return worst;
}

// The force by area on a heavy sheet that waves as a cos(kx - wt), by a, in phase with it and a
// quarter ahead, and how it should be. Its middle, five times `reach` from the ends.
struct WaveForce {
    double inPhase, ahead, exact;
};

WaveForce forceOnWave(int columns, double h, double wind, double k, double omega) {
    constexpr double length = 2, mass = 1, reach = 0.1, amplitude = 1e-3;
    const World world = strip(length, 0.25, columns, 8, 1e6);
    Air<double> air(world, {.density = 0,
                            .carried = {.mass = mass, .reach = reach},
                            .wind = {.velocity = steady({wind, 0, 0})}});
    State<double> state = stateOf<double>(world);
    Drawer<double> kept;
    air.furnish(kept);
    Workers workers(1);
    const int count = state.count(), steps = static_cast<int>(0.2 / h);
    const double middle = std::accumulate(world.rest.begin(), world.rest.end(), 0.0,
                                          [](double s, const auto& x) { return s + x.x; }) /
                          count;
    WaveForce force{0, 0, mass / (1 + reach * reach * k * k) * std::pow(omega - wind * k, 2)};
    for (int s = 0; s < steps; ++s) {
        for (int v = 0; v < count; ++v) {
            const double phase = k * xOf(world, v) - omega * s * h;
            state.particles[v].d.z = amplitude * std::cos(phase);
            state.velocity[v].v = {0, 0, amplitude * omega * std::sin(phase)};
        }
        state.substep = s;
        const std::vector<Padded<double>> before = state.velocity;
        air.prepare(state, kept, s * h, h, workers);
        if (s < steps - 8) continue;
        double cosine = 0, sine = 0, weight = 0;
        for (int v = 0; v < count; ++v) {
            // One wave, weighed so that no end of it stands out.
            const double at = (xOf(world, v) - middle) * k / (2 * std::numbers::pi);
            if (std::fabs(at) > 1) continue;
            const double window = 1 + std::cos(std::numbers::pi * at),
                         given = (state.velocity[v].v.z - before[v].v.z) * 1e6 / h / amplitude,
                         phase = k * xOf(world, v) - omega * (s - 0.5) * h;
            cosine += window * given * std::cos(phase);
            sine += window * given * std::sin(phase);
            weight += window / 2;
        }
        force.inPhase += cosine / weight / 8;
        force.ahead += sine / weight / 8;
    }
    return force;
}

// Of sheet and air; P is m phi, and phi' (a + l^2 K) phi what it moves with.
double airEnergy(const World& world, std::span<const double> momentum, double mass, double reach) {
    double energy = 0;
    for (int i = 0; i < world.complex.count(2); ++i) {
        const auto t = world.complex.triangle(i);
        const Vec<double> x[3] = {world.rest[t[0]], world.rest[t[1]], world.rest[t[2]]};
        const double area = length(cross(x[1] - x[0], x[2] - x[0])) / 2;
        Vec<double> sum{0, 0, 0};
        for (int c = 0; c < 3; ++c) {
            energy += area / 3 * momentum[t[c]] * momentum[t[c]] / (2 * mass);
            sum += momentum[t[c]] * (x[(c + 2) % 3] - x[(c + 1) % 3]);
        }
        energy += reach * reach * dot(sum, sum) / (4 * area) / (2 * mass);
    }
    return energy;
}

}  // namespace

TEST_CASE("carried air: a wave carries m / (1 + l^2 k^2)", "[air]") {
    for (const auto& [columns, reach] : {std::pair{60, 0.05}, {200, 0.05}, {200, 0.25}}) {
        for (const int n : {0, 1, 3, 6}) {
            int unknowns = 0;
            const double error = filterError(columns, 1, reach, n, unknowns);
            const std::string name = std::to_string(columns) + " columns, " +
                                     std::to_string(unknowns) + " unknowns, " + std::to_string(n) +
                                     " half waves";
            // Linear elements of size s: (k s)^2 / 12 of the slope's part. Sums of them cost some
            // 1 % beside: with one step of smoothing in place of four it is 23.
            const double k = n * std::numbers::pi, size = 1.0 / columns;
            CHECK(report(name, error, k * k * size * size / 4 + (columns > 60 ? 0.015 : 1e-12)));
        }
    }
}

TEMPLATE_TEST_CASE("carried air: a plate falls with the air's inertia and none of its weight",
                   "[air]", float, double) {
    constexpr double mass = 0.5;
    World world = plate(0);
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    actAir(world, {.density = 0, .carried = {.mass = mass, .reach = 0.3}});
    Solver<TestType> solver(world, {});
    for (int frame = 0; frame < 12; ++frame) solver.frame();
    double worst = 0;
    // Gravity acts after the exchange, so that the last of its pushes is not shared yet.
    const double h = 1.0 / 240, fall = g * (solver.time() - h) * sigma / (sigma + mass) + g * h;
    for (const Vec<double>& v : solver.velocities())
        worst = std::max(worst, length(v - Vec<double>{0, -fall, 0}) / fall);
    CHECK(report("speed", worst, sizeof(TestType) == 4 ? 1e-5 : 1e-12));
}

TEST_CASE("carried air: the force on a wave in a stream is A (w - U k)^2", "[air]") {
    const double k = 4 * std::numbers::pi;
    for (const auto& [wind, omega] :
         {std::pair{0.0, 30.0}, {3.0, 0.0}, {3.0, 20.0}, {-3.0, 20.0}}) {
        double error[2];
        for (const int fine : {0, 1}) {
            const WaveForce force =
                forceOnWave(fine ? 257 : 129, fine ? 5e-4 : 1e-3, wind, k, omega);
            error[fine] = std::hypot(force.inPhase - force.exact, force.ahead) / force.exact;
        }
        const std::string name =
            "wind " + std::to_string(wind) + ", frequency " + std::to_string(omega);
        note(name + ", coarse", error[0]);
        CHECK(report(name + ", fine", error[1], 0.03));
    }
}

TEST_CASE("carried air: meeting it never gives energy", "[air]") {
    constexpr double mass = 0.5, reach = 0.3;
    const World world = crumpled();
    Air<double> air(world, {.density = 0, .carried = {.mass = mass, .reach = reach}});
    State<double> state = stateOf<double>(world);
    Drawer<double> kept;
    air.furnish(kept);
    Workers workers(1);
    const auto energy = [&] {
        double sum = airEnergy(world, kept.numbers, mass, reach);
        for (std::size_t i = 0; i < world.mass.size(); ++i) {
            const Vec<double> v = state.velocity[i].v;
            if (!world.pinned[i]) sum += world.mass[i] * dot(v, v) / 2;
        }
        return sum;
    };
    Random random(3);
    for (state.substep = 0; state.substep < 20; ++state.substep) {
        for (std::size_t i = 0; i < world.mass.size(); ++i)
            if (!world.pinned[i]) state.velocity[i].v += random.point(1);
        const double before = energy();
        air.prepare(state, kept, 0, 0, workers);
        if (state.substep > 0) CHECK(energy() < before);
    }
}

TEST_CASE("carried air: what it gives is what a free sheet gets", "[air]") {
    World world = crumpled();
    std::ranges::fill(world.pinned, std::uint8_t{0});
    Air<double> air(world, {.density = 0,
                            .carried = {.mass = 0.4, .reach = 0.2},
                            .wind = {.velocity = steady({4, 0, 1})}});
    State<double> state = stateOf<double>(world);
    Drawer<double> kept;
    air.furnish(kept);
    Workers workers(1);
    for (state.substep = 0; state.substep < 4; ++state.substep) {
        const std::vector<Padded<double>> before = state.velocity;
        air.prepare(state, kept, 0, 1e-3, workers);
        Vec<double> given{0, 0, 0};
        for (std::size_t i = 0; i < world.mass.size(); ++i)
            given += world.mass[i] * (state.velocity[i].v - before[i].v);
        if (state.substep == 0)
            CHECK(length(given) == 0);
        else
            CHECK(report("difference", length(given - air.impulse()) / length(given), 1e-9));
    }
}

// Past hundreds of triangles in a substep, along a sheet that is drawn out or crushed to nothing.
TEMPLATE_TEST_CASE("carried air: a storm stays finite", "[air]", float, double) {
    for (const double drawn : {0.0, 1e-3, 1.0, 30.0}) {
        World world = crumpled();
        for (Vec<double>& x : world.start) x.x *= drawn;
        Air<TestType> air(world, {.density = 0,
                                  .carried = {.mass = 0.4, .reach = 0.2},
                                  .wind = {.velocity = steady({1000, 0, 300})}});
        State<TestType> state = stateOf<TestType>(world);
        Drawer<TestType> kept;
        air.furnish(kept);
        Workers workers(1);
        double fastest = 0;
        for (state.substep = 0; state.substep < 50; ++state.substep) {
            air.prepare(state, kept, 0, 1.0 / 24, workers);
            for (const Padded<TestType>& v : state.velocity)
                fastest = std::max(fastest, double(length(v.v)));
            REQUIRE(std::isfinite(fastest));
        }
        note("fastest of a sheet in 1,044 m/s, m/s", fastest);
    }
}

TEST_CASE("carried air: what it cannot be is refused", "[air]") {
    const auto refuses = [](const World& world, const AirOptions& options, const char* what) {
        CHECK_THROWS_WITH(Air<double>(world, options), Catch::Matchers::Contains(what));
    };
    refuses(plate(0), {.carried = {.mass = -1, .reach = 1}}, "not negative");
    refuses(plate(0), {.carried = {.mass = 1}}, "reach somewhere");
    World twisted;
    Simplices two;
    two.triangles = {{0, 1, 2}, {1, 2, 3}};
    twisted.add({SimplicialComplex(4, two), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
                {.density = 1});
    refuses(twisted, {.carried = {.mass = 1, .reach = 1}}, "the same way");
}
