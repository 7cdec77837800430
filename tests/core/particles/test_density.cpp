// The kernel, the part of it that walls take, and an evaluation of densities, each against what is
// computed another way.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/particles/liquid_set.h>
#include <plait/particles/spline.h>
#include <plait/particles/walls.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double spacing = 0.1, radius = 2 * spacing;

// A cube of water that is a little too dense, so that all of it acts.
Pool denseBlock(int n, std::vector<Collider> walls = {}) {
    auto positions = blockOf(n, n, n, 0.96 * spacing, 0.2);
    for (Vec<double>& p : positions) p += {0.05 * spacing, 0.05 * spacing, 0.05 * spacing};
    return {std::move(positions), spacing, std::move(walls)};
}

// One substep of nothing but densities, in frames of 1 s: velocities are what moved (m).
template <class Real>
std::vector<Vec<double>> movedBy(const Pool& pool, int threads = 1,
                                 KernelChoice kernels = bestKernels()) {
    SolverOptions options;
    options.schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = 1};
    options.threads = threads;
    options.kernels = kernels;
    Solver<Real> solver(pool.world, options);
    solver.frame();
    return solver.velocities();
}

// All pairs, in double.
std::vector<Vec<double>> movedByPairs(const Pool& pool) {
    const std::vector<Vec<double>>& x = pool.world.start;
    const Walls walls(pool.liquid.walls, radius, "walls");
    const double inverse = 1 / pool.world.mass[0];
    const auto pull = [&](std::size_t i, std::size_t j) {
        const Vec<double> d = x[i] - x[j];
        const double r = length(d);
        return divide(CubicSpline::slope(r / radius) / radius / restSum, r) * d;
    };
    std::vector<double> lambda;
    std::vector<Vec<double>> moved;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Shade shade = walls.at(x[i]);
        double value = shade.part - 1, answer = 0;
        Vec<double> own = shade.gradient;
        for (std::size_t j = 0; j < x.size(); ++j) {
            value += CubicSpline::value(length(x[i] - x[j]) / radius) / restSum;
            own += pull(i, j);
            answer += inverse * dot(pull(i, j), pull(i, j));
        }
        answer += inverse * dot(own, own);
        lambda.push_back(value > 0 ? -pool.liquid.relaxation * value / answer : 0);
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        Vec<double> sum = lambda[i] * walls.at(x[i]).gradient;
        for (std::size_t j = 0; j < x.size(); ++j) sum += (lambda[i] + lambda[j]) * pull(i, j);
        moved.push_back(inverse * sum);
    }
    return moved;
}

double largest(const std::vector<Vec<double>>& of) {
    double most = 0;
    for (const Vec<double>& v : of) most = std::max(most, length(v));
    return most;
}

double apart(const std::vector<Vec<double>>& a, const std::vector<Vec<double>>& b) {
    std::vector<Vec<double>> off;
    for (std::size_t i = 0; i < a.size(); ++i) off.push_back(a[i] - b[i]);
    return largest(off) / largest(b);
}

// Of the kernel around a point, the part where hidden(p), by cubes of a fortieth of the radius.
template <class Hidden>
double partOf(const Vec<double>& at, const Hidden& hidden) {
    constexpr int n = 40;
    double all = 0, part = 0;
    for (int k = -n; k < n; ++k)
        for (int j = -n; j < n; ++j)
            for (int i = -n; i < n; ++i) {
                const Vec<double> d{(i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n};
                const double value = CubicSpline::value(length(d));
                all += value;
                if (hidden(at + radius * d)) part += value;
            }
    return part / all;
}

}  // namespace

TEST_CASE("spline: its slope, its integral, and the part beyond a plane", "[liquid]") {
    double worst = 0, integral = 0;
    const double step = 1e-6;
    for (double q = 0.001; q < 1.2; q += 0.001) {
        const auto slope = [&](auto f) { return (f(q + step) - f(q - step)) / (2 * step); };
        worst = std::max(worst, std::fabs(slope(CubicSpline::value) - CubicSpline::slope(q)));
        worst =
            std::max(worst, std::fabs(slope(CubicSpline::beyond) - CubicSpline::beyondSlope(q)));
        integral += 4 * pi * q * q * CubicSpline::value(q) * 0.001;
        REQUIRE(CubicSpline::slope(q) <= 0);
    }
    REQUIRE(report("slopes against differences", worst, 1e-5));
    REQUIRE(report("integral against pi / 8", std::fabs(integral * 8 / pi - 1), 1e-5));
    worst = 0;
    for (const double s : {-0.6, -0.25, 0.0, 0.125, 0.25, 0.5, 0.75, 1.0})
        worst = std::max(worst, std::fabs(partOf({0, s * radius, 0},
                                                 [](const Vec<double>& p) { return p.y < 0; }) -
                                          CubicSpline::beyond(s)));
    // Cubes cut by the plane at s are counted by their middles.
    REQUIRE(report("part beyond a plane against a sum of cubes", worst, 1e-3));
}

TEST_CASE("walls: at edges and in corners planes hide what they hide together", "[liquid]") {
    const std::vector<Collider> tank = openTank(10, 10);
    const Walls edge({tank[0], tank[1]}, radius, "edge");
    const Walls corner({tank[0], tank[1], tank[3]}, radius, "corner");
    double worst = 0, worstSum = 0;
    for (const double u : {0.3, 0.5, 0.75, 1.0}) {
        const Vec<double> at{u * spacing, u * spacing, u * spacing};
        const double two = partOf(at, [](const Vec<double>& p) { return p.x < 0 || p.y < 0; });
        const double three =
            partOf(at, [](const Vec<double>& p) { return p.x < 0 || p.y < 0 || p.z < 0; });
        worst = std::max(
            {worst, std::fabs(edge.at(at).part - two), std::fabs(corner.at(at).part - three)});
        worstSum = std::max(worstSum, 3 * CubicSpline::beyond(u * spacing / radius) - three);
    }
    REQUIRE(report("edge and corner, of the whole kernel", worst, 0.018));
    note("a sum of parts would be off by", worstSum);
    REQUIRE(worstSum > 0.09);
}

TEST_CASE("walls: gradients are those of the parts", "[liquid]") {
    std::vector<Collider> walls = openTank(0.5, 0.5);
    walls.push_back({.solid = Solid::box(0.2, 0.3, 0.25), .frame = {{0.25, 0.15, 0.25}}});
    walls.push_back({.solid = Solid::sphere(0.4), .frame = {{0.3, 0.8, 0.2}}});
    const Walls all(walls, radius, "walls");
    double worst = 0;
    const double step = 1e-6;
    for (const Vec<double>& p : blockOf(9, 9, 9, 0.057, 0.3)) {
        const auto along = [&](const Vec<double>& d) {
            return (all.at(p + step * d).part - all.at(p - step * d).part) / (2 * step);
        };
        const Vec<double> slope{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
        worst = std::max(worst, length(slope - all.at(p).gradient) * radius);
        REQUIRE(all.at(p).part >= 0);
        REQUIRE(all.at(p).part <= 1);
        if (!all.near(p, 0)) REQUIRE(all.at(p).part == 0);
    }
    REQUIRE(report("gradients, times the radius", worst, 1e-5));
}

TEST_CASE("liquid: densities are those of all pairs", "[liquid]") {
    const Pool pool = denseBlock(9, openTank(0.9, 0.9));
    const std::vector<double> ratios = densityRatios(pool.liquid, pool.world.start);
    const Walls walls(pool.liquid.walls, radius, "walls");
    double worst = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        double sum = walls.at(pool.world.start[i]).part;
        for (const Vec<double>& p : pool.world.start)
            sum += CubicSpline::value(length(p - pool.world.start[i]) / radius) / restSum;
        worst = std::max(worst, std::fabs(ratios[i] - sum));
    }
    REQUIRE(report("densities", worst, 1e-13));
}

TEST_CASE("liquid: an evaluation is that of all pairs", "[liquid]") {
    for (const bool walled : {false, true}) {
        Pool pool = denseBlock(9, walled ? openTank(0.9, 0.9) : std::vector<Collider>{});
        holdDensity(pool.world, pool.liquid, {.name = "density"});
        const std::vector<Vec<double>> expected = movedByPairs(pool);
        REQUIRE(largest(expected) > 1e-3 * spacing);
        REQUIRE(report("corrections in double", apart(movedBy<double>(pool), expected), 1e-11));
        // C is a difference from 1: a few roundings of it, over the part that it is off by.
        REQUIRE(report("corrections in float", apart(movedBy<float>(pool), expected), 1e-4));
    }
}

TEST_CASE("liquid: a crowd that is too large for a pack of it is seen all the same", "[liquid]") {
    auto positions = blockOf(12, 12, 12, 0.3 * spacing, 0.3);
    Pool pool(std::move(positions), spacing);
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    const std::vector<Vec<double>> expected = movedByPairs(pool);
    REQUIRE(report("corrections in double", apart(movedBy<double>(pool), expected), 1e-11));
    REQUIRE(report("corrections in float", apart(movedBy<float>(pool), expected), 1e-4));
}

TEMPLATE_TEST_CASE("liquid: densities conserve momentum and angular momentum", "[liquid]", float,
                   double) {
    Pool pool = denseBlock(9);
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    const std::vector<Vec<double>> moved = movedBy<TestType>(pool);
    Vec<double> momentum{0, 0, 0}, angular{0, 0, 0};
    double all = 0, turning = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Vec<double> arm = pool.world.start[i] - pool.world.start[0];
        momentum += moved[i];
        angular += cross(arm, moved[i]);
        all += length(moved[i]);
        turning += length(cross(arm, moved[i]));
    }
    const double bound = std::is_same_v<TestType, float> ? 1e-6 : 1e-14;
    REQUIRE(report("momentum, of the sum of its parts", length(momentum) / all, bound));
    REQUIRE(report("angular momentum", length(angular) / turning, bound));
}

TEST_CASE("liquid: a free surface is not pulled together", "[liquid]") {
    Pool pool(blockOf(6, 6, 6, 1.05 * spacing, 0.05), spacing);
    holdDensity(pool.world, pool.liquid, {.name = "density"});
    REQUIRE(largest(movedBy<float>(pool)) == 0);
}

TEMPLATE_TEST_CASE("liquid: the same bits from any threads and instruction set",
                   "[liquid][determinism][threads]", float, double) {
    Pool pool(blockOf(16, 24, 16, spacing, 0.2), spacing, openTank(1.6, 1.6));
    pool.fall();
    const auto hashOf = [&](int threads, KernelChoice kernels) {
        SolverOptions options = perSecond(500, threads);
        options.kernels = kernels;
        Solver<TestType> solver(pool.world, options);
        for (int frame = 0; frame < 2; ++frame) solver.frame();
        return solver.hash();
    };
    const std::uint64_t expected = hashOf(1, {Isa::v2, 4});
    for (const int threads : {1, 2, 3, 4}) REQUIRE(hashOf(threads, bestKernels()) == expected);
    for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
        if (available({isa, 4})) REQUIRE(hashOf(1, {isa, 4}) == expected);
}

TEST_CASE("liquid: what is out of range is refused by name", "[liquid]") {
    const auto refusal = [](const auto& change) {
        Pool pool = denseBlock(3);
        change(pool.liquid);
        try {
            holdDensity(pool.world, pool.liquid, {.name = "water"});
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    REQUIRE(refusal([](Liquid&) {}).empty());
    REQUIRE(refusal([](Liquid& l) { l.spacing = 0; }) == "water: spacing is above 0");
    REQUIRE(refusal([](Liquid& l) { l.relaxation = 1; }) == "water: relaxation is in (0, 1)");
    REQUIRE(refusal([](Liquid& l) { l.particles.last += 1; }) ==
            "water: its particles are not in the world");
}
