// Viscosity against all pairs in double, closed forms of flows between walls, and what must be
// conserved.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/momentum.h>
#include <plait/particles/liquid_set.h>
#include <plait/particles/spline.h>
#include <plait/particles/viscosity.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

// A liquid whose particles stay where they are: what viscosity alone does to their speeds.
template <class Real>
struct Still {
    Pool pool;
    Viscosity<Real> viscosity;
    State<Real> state;
    Drawer<Real> kept;
    Workers workers;

    Still(Pool given, const ViscosityOptions& options, int threads = 1)
        : pool(std::move(given)),
          viscosity(pool.world, pool.liquid, options),
          state(Solver<Real>(pool.world, perSecond(50)).state()),
          workers(threads) {
        viscosity.furnish(kept);
    }
    template <class Field>
    void move(const Field& field) {
        for (int v = 0; v < state.count(); ++v)
            state.velocity[v].v = as<Real>(field(pool.world.start[v]));
    }
    void step(double h, double t = 0) { viscosity.prepare(state, kept, t, h, workers); }
    Vec<double> velocity(int v) const { return as<double>(state.velocity[v].v); }
    double energy() const {
        double sum = 0;
        for (int v = 0; v < state.count(); ++v)
            sum += pool.world.mass[v] / 2 * dot(velocity(v), velocity(v));
        return sum;
    }
};

constexpr double spacing = 0.01;

Pool cube(int n, std::vector<Collider> walls = {}) {
    return {blockOf(n, n, n, spacing, 0.2), spacing, std::move(walls)};
}

// Water that has come to rest as chance had it, in a box, from the origin on.
std::vector<Vec<double>> settled(int nx, int ny, int nz) {
    const Vec<double> size = spacing * Vec<double>{double(nx), double(ny), double(nz)};
    std::vector<Collider> box = openTank(size.x, size.z);
    box.push_back(wallAt({0, size.y, 0}, {0, -1, 0}, {1, 0, 0}));
    Pool pool(blockOf(nx, ny, nz, spacing, 0.5), spacing, box);
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    collide(pool.world, box, {surfaceOf(pool.liquid)}, {.name = "box", .order = 1});
    SolverOptions options = perSecond(500, 2);
    options.damping = 0.2;
    Solver<float> solver(pool.world, options);
    for (int frame = 0; frame < 30; ++frame) solver.frame();
    return solver.positions();
}

Vec<double> swirl(const Vec<double>& x) {
    return {std::sin(90 * x.y) + 3 * x.z, std::cos(70 * x.z), std::sin(50 * x.x + 30 * x.y)};
}

}  // namespace

TEST_CASE("viscosity: an explicit step is that of all pairs", "[viscosity][liquid][FL3][FL5]") {
    Still<double> still(cube(6), {.viscosity = 2, .implicit = false});
    const double h = 1e-4, R = 2 * spacing, V = spacing * spacing * spacing;
    still.move(swirl);
    std::vector<Vec<double>> expected;
    const auto& x = still.pool.world.start;
    for (std::size_t i = 0; i < x.size(); ++i) {
        Vec<double> force{0, 0, 0};
        for (std::size_t j = 0; j < x.size(); ++j) {
            if (i == j) continue;
            const Vec<double> to = x[j] - x[i], n = 1 / length(to) * to;
            const double r = length(to);
            const double gradient = -CubicSpline::slope(r / R) / R / (restSum * V);
            const double apart = dot(swirl(x[j]) - swirl(x[i]), n);
            force += viscousPairs * 2 * V * V * gradient * r / (r * r + 0.01 * R * R) * apart * n;
        }
        expected.push_back(swirl(x[i]) + h / still.pool.world.mass[i] * force);
    }
    still.step(h);
    double off = 0, most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        off = std::max(off, length(still.velocity(static_cast<int>(i)) - expected[i]));
        most = std::max(most, length(expected[i] - swirl(x[i])));
    }
    CHECK(report("explicit step against all pairs, of the largest change", off / most, 1e-12));
}

TEMPLATE_TEST_CASE("viscosity keeps momentum, and never gains energy",
                   "[viscosity][liquid][FL3][FL6]", float, double) {
    const double rounding = std::is_same_v<TestType, float> ? 3e-6 : 1e-12;
    for (const double viscosity : {0.1, 100.0}) {
        Still<TestType> still(cube(8), {.viscosity = viscosity});
        still.move(swirl);
        const auto sums = [&] {
            Vec<double> p{}, l{};
            for (int v = 0; v < still.state.count(); ++v) {
                const Vec<double> q = still.pool.world.mass[v] * still.velocity(v);
                p += q, l += cross(still.state.position(v), q);
            }
            return std::pair{p, l};
        };
        const auto before = sums();
        double energy = still.energy();
        const double scale = std::sqrt(2 * energy * 512 * still.pool.world.mass[0]);
        for (int step = 0; step < 10; ++step) {
            still.step(0.01);
            const double now = still.energy();
            CHECK(now <= energy * (1 + 1e-6));
            energy = now;
        }
        const auto after = sums();
        CHECK(report("momentum", length(after.first - before.first) / scale, rounding));
        CHECK(report("angular momentum", length(after.second - before.second) / (scale * 0.04),
                     rounding));
        note("energy that is left, J", energy);
    }
}

TEST_CASE("viscosity leaves alone what turns as one", "[viscosity][liquid][FL3]") {
    Still<double> still(cube(8), {.viscosity = 1000});
    const Vec<double> spin{3, -2, 5}, middle{0.04, 0.04, 0.04};
    const auto turning = [&](const Vec<double>& x) {
        return Vec<double>{1, 2, 3} + cross(spin, x - middle);
    };
    still.move(turning);
    still.step(0.1);
    double off = 0;
    for (int v = 0; v < still.state.count(); ++v)
        off = std::max(off, length(still.velocity(v) - turning(still.pool.world.start[v])));
    CHECK(report("of what turns and flies as one, m/s", off, 1e-9));
}

TEST_CASE("viscosity is solved to its tolerance, or says that it was not",
          "[viscosity][liquid][FL6]") {
    int before = 0;
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        Still<double> still(cube(10), {.viscosity = 50, .tolerance = tolerance});
        Still<double> exact(cube(10),
                            {.viscosity = 50, .tolerance = 1e-12, .mostIterations = 5000});
        still.move(swirl), exact.move(swirl);
        still.step(0.02), exact.step(0.02);
        double off = 0;
        for (int v = 0; v < still.state.count(); ++v)
            off = std::max(off, length(still.velocity(v) - exact.velocity(v)));
        const int taken = Viscosity<double>::iterations(still.kept);
        note("iterations", taken);
        CHECK(report("speed off, m/s", off, 20 * tolerance));
        CHECK(taken > before);
        CHECK(Viscosity<double>::unfinished(still.kept) == 0);
        before = taken;
    }
    Still<double> tired(cube(10), {.viscosity = 50, .tolerance = 1e-9, .mostIterations = 3});
    tired.move(swirl);
    tired.step(0.02);
    CHECK(Viscosity<double>::iterations(tired.kept) == 3);
    CHECK(Viscosity<double>::unfinished(tired.kept) == 1);
}

TEST_CASE("explicit viscosity blows up, implicit does not", "[viscosity][liquid][FL5]") {
    const auto energyAfter = [](bool implicit) {
        Still<double> still(cube(8), {.viscosity = 10, .implicit = implicit});
        still.move(swirl);
        const double before = still.energy();
        for (int step = 0; step < 20; ++step) still.step(0.01);
        return still.energy() / before;
    };
    CHECK(energyAfter(false) > 1e6);
    CHECK(energyAfter(true) < 1);
}

TEST_CASE("viscosity: the same bits with any threads", "[viscosity][liquid][determinism]") {
    const auto speeds = [](int threads) {
        Still<float> still(cube(12), {.viscosity = 5}, threads);
        still.move(swirl);
        for (int step = 0; step < 3; ++step) still.step(0.01);
        return still.state.velocity;
    };
    const auto one = speeds(1), three = speeds(3);
    bool same = true;
    for (std::size_t i = 0; i < one.size(); ++i) same = same && length(one[i].v - three[i].v) == 0;
    CHECK(same);
}

namespace {

// Both start from rest, in the middle third: nothing holds what flows out at the ends.
struct PlaneFlow {
    double plate, push;                         // m/s, of the upper plate; m/s^2, of all
    double fastest;                             // m/s, in the end
    double (*speed)(double part, double time);  // over `fastest`, by y / H and nu t / H^2
};
const PlaneFlow couette{1, 0, 1, [](double y, double t) {
                            double u = y;
                            for (int n = 1; n < 60; ++n)
                                u += 2 * (n % 2 ? -1 : 1) / (n * pi) *
                                     std::exp(-n * n * pi * pi * t) * std::sin(n * pi * y);
                            return u;
                        }};
const PlaneFlow poiseuille{0, 1, 0, [](double y, double t) {
                               double u = 4 * y * (1 - y);
                               for (int n = 1; n < 60; n += 2)
                                   u -= 32 / std::pow(n * pi, 3) * std::exp(-n * n * pi * pi * t) *
                                        std::sin(n * pi * y);
                               return u;
                           }};

void startUp(const PlaneFlow& flow, int layers, double bound) {
    const int across = 6, along = 3 * layers;
    const double H = layers * spacing, mu = 20, nu = mu / 1000;
    const double fastest = flow.push > 0 ? flow.push * H * H / (8 * nu) : flow.fastest;
    Collider lower = wallAt({0, 0, 0}, {0, 1, 0}, {1, 0, 0}),
             upper = wallAt({0, H, 0}, {0, -1, 0}, {1, 0, 0});
    upper.motion = [frame = upper.frame, speed = flow.plate](double t) {
        Frame at = frame;
        at.origin.x += speed * t;
        return at;
    };
    Still<double> still({settled(along, layers, across), spacing, {lower, upper}},
                        {.viscosity = mu, .tolerance = 1e-5 * fastest, .mostIterations = 2000}, 2);
    still.move([](const Vec<double>&) { return Vec<double>{}; });
    const double h = 0.0025 * H * H / nu;
    double t = 0;
    for (const double part : {0.05, 0.15, 0.5}) {
        for (; t < part * H * H / nu - h / 2; t += h) {
            for (int v = 0; v < still.state.count(); ++v)
                still.state.velocity[v].v.x += flow.push * h;
            still.step(h, t);
        }
        std::vector<double> off(layers), count(layers);
        double squares = 0, all = 0;
        for (int v = 0; v < still.state.count(); ++v) {
            const Vec<double> x = still.pool.world.start[v];
            if (std::fabs(x.x - along * spacing / 2) > H / 2) continue;
            const double error =
                still.velocity(v).x / fastest - flow.speed(x.y / H, nu * t / (H * H));
            const int layer = std::clamp(static_cast<int>(x.y / spacing), 0, layers - 1);
            off[layer] += error, ++count[layer];
            squares += error * error, ++all;
        }
        double most = 0;
        for (int i = 0; i < layers; ++i) most = std::max(most, std::fabs(off[i] / count[i]));
        note("after, in H^2 / nu", part);
        note("root mean square of all particles, of the fastest", std::sqrt(squares / all));
        CHECK(report("largest error of a layer's mean, of the fastest", most, bound));
    }
}

}  // namespace

TEST_CASE("viscosity: between plates water flows as Couette and Poiseuille have it",
          "[viscosity][liquid][FL3][FL4]") {
    startUp(couette, 20, 0.05);
    startUp(poiseuille, 20, 0.05);
}

TEST_CASE("viscosity: Couette and Poiseuille with 40 layers", "[viscosity][liquid][long][FL3]") {
    startUp(couette, 40, 0.03);
    startUp(poiseuille, 40, 0.03);
}
