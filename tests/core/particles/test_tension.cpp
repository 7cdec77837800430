// Surface tension against its own energy, Rayleigh's drop, Laplace's pressure, Young's angle, and
// threads that come apart.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>
#include <plait/numbers/elementary.h>
#include <plait/particles/tension.h>

#include <algorithm>
#include <numeric>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double spacing = 1e-3, sigma = 0.072, sound = 4;

State<double> stateOf(const Pool& pool, const std::vector<Vec<double>>& at) {
    State<double> state = Solver<double>(pool.world, perSecond(50)).state();
    for (std::size_t i = 0; i < at.size(); ++i) split(state.particles[i], at[i]);
    return state;
}

// N s, of a push of 1 s.
std::vector<Vec<double>> pushes(const Pool& pool, Tension<double>& tension,
                                const std::vector<Vec<double>>& at) {
    State<double> state = stateOf(pool, at);
    Workers workers(1);
    tension.apply(state, 0, 1, workers);
    std::vector<Vec<double>> out;
    for (std::size_t i = 0; i < at.size(); ++i)
        out.push_back(pool.world.mass[i] * state.velocity[i].v);
    return out;
}

// Points of a lattice, shaken by a tenth of a spacing to either side, that `inside` keeps.
template <class Inside>
std::vector<Vec<double>> shape(int half, const Inside& inside, unsigned seed = 7) {
    std::mt19937 random(seed);
    const auto shaken = [&](int i) {
        return (i + 0.2 * static_cast<double>(random()) / 4294967296.0 - 0.1) * spacing;
    };
    std::vector<Vec<double>> at;
    for (int i = -half; i <= half; ++i)
        for (int j = -half; j <= half; ++j)
            for (int k = -half; k <= half; ++k) {
                const double x = shaken(i), y = shaken(j), z = shaken(k);
                if (inside(Vec<double>{x, y, z})) at.push_back({x, y, z});
            }
    return at;
}

Pool drop(double radius, double stretched, std::vector<Collider> walls = {}) {
    const double along = 1 + stretched, across = 1 / squareRoot(along);
    return {shape(static_cast<int>(1.5 * radius),
                  [=](const Vec<double>& p) {
                      return length(Vec<double>{p.x / across, p.y / along, p.z / across}) <
                             radius * spacing;
                  }),
            spacing, std::move(walls)};
}

double radiusOf(const Pool& pool) {  // m, of as much water as a ball
    return spacing * std::cbrt(3 * pool.liquid.particles.size() / (4 * pi));
}

// In frames of 5 ms.
SolverOptions quick() {
    SolverOptions options;
    const double h = squareRoot(0.5) * spacing / sound;
    options.schedule = {.substeps = static_cast<int>(std::ceil(0.005 / h)),
                        .frameRate = {200, 1},
                        .iterations = 1,
                        .collisionPasses = 1};
    options.sweeps = Sweeps::oneWay;
    return options;
}

Vec<double> centreOf(const std::vector<Vec<double>>& at) {
    return (1.0 / static_cast<double>(at.size())) *
           std::accumulate(at.begin(), at.end(), Vec<double>{0, 0, 0});
}

// How much longer than thick: 2 y^2 - x^2 - z^2 over the square of the distance from the centre.
double length2(const std::vector<Vec<double>>& at) {
    const Vec<double> centre = centreOf(at);
    double sum = 0, all = 0;
    for (const Vec<double>& x : at) {
        const Vec<double> p = x - centre;
        sum += 3 * p.y * p.y - dot(p, p), all += dot(p, p);
    }
    return sum / all;
}

// s, from one time that it is as thick as long to the next, of the first few.
double halfPeriod(Pool pool, double seconds) {
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    actTension(pool.world, pool.liquid, {.tension = sigma, .interval = 2});
    Solver<float> solver(pool.world, quick());
    double before = 0, first = 0, last = 0;
    int crossings = 0;
    for (int frame = 1; frame <= seconds * 200; ++frame) {
        solver.frame();
        const double now = length2(solver.positions());
        if (frame > 1 && now * before < 0) {
            last = 0.005 * (frame - now / (now - before));
            if (crossings++ == 0) first = last;
        }
        before = now;
    }
    return crossings > 1 ? (last - first) / (crossings - 1) : 0;
}

double rayleighHalf(double radius) {
    return pi / squareRoot(8 * sigma / (1000 * radius * radius * radius));
}

}  // namespace

TEST_CASE("surface tension: forces are the derivative of its energy", "[liquid][tension][FL7]") {
    const Pool pool{
        blockOf(6, 5, 4, spacing, 0.4), spacing, {wallAt({0, 0, 0}, {0, 1, 0}, {1, 0, 0})}};
    for (const bool wall : {false, true}) {
        Liquid liquid = pool.liquid;
        if (!wall) liquid.walls.clear();
        Tension<double> tension(pool.world, liquid, {.tension = sigma});
        auto at = pool.world.start;
        const auto forces = pushes(pool, tension, at);
        double off = 0, most = 0;
        for (const int v : {0, 17, 44, 60, 119})
            for (const Vec<double>& way : {Vec<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
                const Vec<double> home = at[v];
                constexpr double step = 1e-7;
                double energy[2];
                for (const int side : {0, 1}) {
                    at[v] = home + (side ? step : -step) * way;
                    pushes(pool, tension, at);
                    energy[side] = tension.energy();
                }
                at[v] = home;
                off = std::max(
                    off, std::fabs((energy[1] - energy[0]) / (2 * step) + dot(forces[v], way)));
                most = std::max(most, length(forces[v]));
            }
        CHECK(report("force and slope of the energy differ, of the greatest force", off / most,
                     2e-6));
        if (wall) continue;
        Vec<double> sum{0, 0, 0}, turn{0, 0, 0};
        for (std::size_t i = 0; i < at.size(); ++i)
            sum += forces[i], turn += cross(at[i], forces[i]);
        CHECK(length(sum) < 1e-12 * most);
        CHECK(length(turn) < 1e-12 * most * 6 * spacing);
    }
}

TEST_CASE("surface tension: a drop swings as Rayleigh's, small or large",
          "[liquid][tension][FL7]") {
    for (const double stretched : {0.05, 0.02}) {
        const Pool pool = drop(6, stretched);
        const double expected = rayleighHalf(radiusOf(pool));
        const double off = halfPeriod(pool, 0.25) / expected - 1;
        note("stretched by", stretched);
        CHECK(report("a drop of 6 spacings: period against Rayleigh's, off by", std::fabs(off),
                     0.05));
    }
}

TEST_CASE("surface tension: larger drops swing as Rayleigh's", "[liquid][tension][FL7][long]") {
    for (const double radius : {8.0, 10.0}) {
        const Pool pool = drop(radius, 0.05);
        const double expected = rayleighHalf(radiusOf(pool));
        const double off = halfPeriod(pool, 2.7 * expected) / expected - 1;
        note("radius in spacings", radius);
        CHECK(report("period against Rayleigh's, off by", std::fabs(off), 0.1));
    }
}

namespace {

// A thread between two walls that it meets at right angles, as long as five of Rayleigh's waves.
struct Thread {
    double radius, length, scale;  // m, m, s: the square root of density radius^3 / tension
    double wave = 0;               // m, that its wave of most weight is long, before it parts
    double growth = 0;             // 1/scale, of its unevenness from then to when it parts
};
Thread part(double radii, unsigned seed) {
    const double length = 5 * 9.015 * radii * spacing;
    const int half = static_cast<int>(length / (2 * spacing)) + 1;
    std::vector<Vec<double>> at;
    for (Vec<double> p : shape(
             half,
             [=](const Vec<double>& p) {
                 return std::fabs(p.x) < length / 2 - 0.3 * spacing &&
                        std::hypot(p.y, p.z) < radii * spacing;
             },
             seed))
        at.push_back(p);
    Pool pool(std::move(at), spacing,
              {wallAt({-length / 2, 0, 0}, {1, 0, 0}, {0, 1, 0}),
               wallAt({length / 2, 0, 0}, {-1, 0, 0}, {0, 1, 0})});
    const double n = pool.liquid.particles.size();
    Thread thread{squareRoot(n * std::pow(spacing, 3) / (pi * length)), length, 0};
    thread.scale = squareRoot(1000 * std::pow(thread.radius, 3) / sigma);
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    collide(pool.world, pool.liquid.walls, {surfaceOf(pool.liquid)}, {.name = "ends", .order = 1});
    actTension(pool.world, pool.liquid, {.tension = sigma, .interval = 2});
    Solver<float> solver(pool.world, quick());
    double uneven = 0, began = 0, first = 0;
    for (int frame = 1; frame < 200; ++frame) {
        solver.frame();
        // Waves that both ends mirror, of the section along it.
        std::vector<double> waves(16, 0.0);
        for (const Vec<double>& p : solver.positions())
            for (int k = 1; k < 16; ++k)
                waves[k] += 2 / n * std::cos(pi * k * (p.x / length + 0.5));
        double squares = 0, weighed = 0;
        for (int k = 1; k < 16; ++k) {
            squares += waves[k] * waves[k];
            weighed += waves[k] * waves[k] * k;
        }
        uneven = squareRoot(squares);
        if (began == 0 && uneven > 0.15) began = frame, first = uneven;
        if (uneven < 0.5) continue;
        thread.wave = 2 * length * squares / weighed;
        thread.growth = std::log(uneven / first) / ((frame - began) * 0.005 / thread.scale);
        return thread;
    }
    return thread;
}

}  // namespace

TEST_CASE("surface tension: threads part in waves as long as Rayleigh's, more slowly",
          "[liquid][tension][FL7][long]") {
    double spacings = 0, growths = 0;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Thread thread = part(4, seed);
        note("seed", seed);
        note("its wave of most weight, radii; Rayleigh's is 9.015", thread.wave / thread.radius);
        note("its growth; Rayleigh's is 0.343", thread.growth);
        spacings += thread.wave / (5 * thread.radius), growths += thread.growth / 5;
    }
    CHECK(report("mean wave off Rayleigh's by", std::fabs(spacings / 9.015 - 1), 0.2));
    CHECK(growths > 0.2);
}

TEST_CASE("surface tension: a cube of water becomes a ball", "[liquid][tension][FL7]") {
    Pool pool{shape(4, [](const Vec<double>&) { return true; }), spacing};
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    actTension(pool.world, pool.liquid, {.tension = sigma, .interval = 2});
    Solver<float> solver(pool.world, quick());
    const auto spreadOf = [&] {  // of the distance of the outermost from the centre, by octants
        const auto at = solver.positions();
        const Vec<double> centre = centreOf(at);
        std::vector<double> furthest(26, 0.0);
        for (const Vec<double>& x : at) {
            const Vec<double> p = x - centre;
            int way = 0;
            for (int i = 0; i < 27; ++i) {
                if (i == 13) continue;
                const Vec<double> axis{double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 - 1)};
                if (const double along = dot(p, axis) / length(axis); along > furthest[way])
                    furthest[way] = along;
                ++way;
            }
        }
        const auto [low, high] = std::ranges::minmax(furthest);
        return high / low - 1;
    };
    const double before = spreadOf();
    for (int frame = 0; frame < 50; ++frame) solver.frame();
    note("before: farthest corner over nearest side, less 1", before);
    CHECK(before > 0.6);
    CHECK(report("after 0.25 s", spreadOf(), 0.12));
    const double drift = length(momentum(pool.world.mass, solver.velocities())) /
                         (1e-6 * pool.liquid.particles.size());
    CHECK(report("speed of its centre, m/s", drift, 1e-5));
}

TEST_CASE("surface tension: what makes no sense is refused", "[liquid][tension]") {
    const Pool pool{blockOf(2, 2, 2, spacing), spacing};
    const auto refuses = [&](TensionOptions options, const char* why) {
        World world = pool.world;
        CHECK_THROWS_WITH(actTension(world, pool.liquid, options),
                          Catch::Contains("surface tension: ") && Catch::Contains(why));
    };
    refuses({.tension = -1}, "below 0");
    refuses({.angle = 181}, "angle");
    refuses({.interval = 0}, "interval");
}

TEMPLATE_TEST_CASE("surface tension: the same bits with any threads, resumed and again",
                   "[liquid][tension][determinism]", float, double) {
    const auto make = [] {
        Pool pool = drop(5, 0.1);
        holdDensity(pool.world, pool.liquid, {.name = "density"});
        actTension(pool.world, pool.liquid, {.tension = sigma, .interval = 3});
        return pool.world;
    };
    const auto options = [](int threads) {
        SolverOptions all = quick();
        all.threads = threads;
        return all;
    };
    Solver<TestType> one(make(), options(1)), three(make(), options(3)),
        resumed(make(), options(1));
    for (int frame = 0; frame < 6; ++frame) {
        if (frame == 3) resumed.restore(one.state(), one.evaluations());
        one.frame(), three.frame();
        if (frame >= 3) resumed.frame();
    }
    CHECK(one.hash() == three.hash());
    CHECK(one.hash() == resumed.hash());
}
