// A dam breaks: the front against Martin and Moyce (An experimental study of the collapse of liquid
// columns on a rigid horizontal plane, 1952), columns twice as high as they are wide.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <array>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, tank = 5;  // m/s^2; the tank's length over the column's width, 1 m

// Time in sqrt(width / 2 g), place of the front in widths: of columns 2.25 in and 1.125 in wide.
using Front = std::vector<std::array<double, 2>>;
const Front fronts225{{0.832, 1.217}, {1.219, 1.474}, {1.997, 2.292}, {2.547, 2.995},
                      {3.345, 4.134}, {4.034, 4.944}, {4.418, 5.881}};
const Front fronts1125{{0.849, 1.245}, {1.212, 1.443}, {1.602, 1.884},
                       {2.283, 2.689}, {2.950, 3.728}, {3.598, 4.528},
                       {3.905, 4.999}, {4.592, 5.841}, {4.961, 6.271}};

double at(const Front& front, double time) {
    for (std::size_t i = 1; i < front.size(); ++i)
        if (front[i][0] >= time) {
            const double f = (time - front[i - 1][0]) / (front[i][0] - front[i - 1][0]);
            return front[i - 1][1] + f * (front[i][1] - front[i - 1][1]);
        }
    return front.back()[1];
}

// RMS over range of what is not yet at the far wall, at the best time shift of at most 0.3: the
// experiment's begins with the gate still in the way.
struct Match {
    double error, shift;
};
Match match(const Front& found, const Front& measured) {
    Match best{infinity, 0};
    for (double shift = -0.3; shift < 0.301; shift += 0.02) {
        double sum = 0, first = 0, last = 0;
        int count = 0;
        for (const auto& [time, place] : measured) {
            if (place > tank - 0.3) continue;
            if (count++ == 0) first = place;
            last = place;
            sum += std::pow(at(found, time + shift) - place, 2);
        }
        const double error = std::sqrt(sum / count) / (last - first);
        if (error < best.error) best = {error, shift};
    }
    return best;
}

struct Break {
    Front front;
    // Compression: largest until the far wall, and later; of all but a thousandth; the mean.
    double before = 0, after = 0, common = 0, mean = 0;
    double outside = 0;  // m, how far any particle is behind a wall
};

// Of `across` spacings by twice as many, and `deep`; until time `last`.
Break breakDam(int across, int deep, int perSecond, double last) {
    const double spacing = 1.0 / across, depth = deep * spacing;
    Pool dam(blockOf(across, 2 * across, deep, spacing, 0.1), spacing, openTank(1, depth));
    dam.fall(g);
    SolverOptions options;
    constexpr int frames = 100;
    options.schedule = {.substeps = perSecond / frames,
                        .frameRate = {frames, 1},
                        .iterations = 1,
                        .collisionPasses = 1};
    options.damping = 0.3;
    Solver<float> stilling(dam.world, options);
    for (int frame = 0; frame < frames; ++frame) stilling.frame();
    Pool flood(stilling.positions(), spacing, openTank(tank, depth));
    flood.fall(g);
    options.damping = 0;
    Solver<float> solver(flood.world, options);
    Break found{.front = {{0, 1}}};
    const double unit = std::sqrt(1 / (2 * g));
    bool arrived = false;
    while (solver.time() < last * unit) {
        solver.frame();
        const std::vector<Vec<double>> x = solver.positions();
        std::vector<int> columns(static_cast<std::size_t>(tank * across) + 2);
        for (const Vec<double>& p : x) {
            ++columns[static_cast<std::size_t>(std::clamp(p.x / spacing, 0.0, tank * across))];
            found.outside = std::max({found.outside, -p.x, p.x - tank, -p.y, -p.z, p.z - depth});
        }
        // The last column that is joined to the rest, half a layer thick.
        std::size_t front = 0;
        while (2 * columns[front] >= deep) ++front;
        found.front.push_back({solver.time() / unit, static_cast<double>(front) * spacing});
        double largest = 0, mean = 0;
        std::vector<double> ratios = densityRatios(flood.liquid, x);
        for (const double ratio : ratios) {
            largest = std::max(largest, ratio - 1);
            mean += std::max(ratio - 1, 0.0) / static_cast<double>(ratios.size());
        }
        arrived = arrived || front + 1 >= columns.size() - 2;
        double& most = arrived ? found.after : found.before;
        most = std::max(most, largest);
        found.mean = std::max(found.mean, mean);
        const auto rank = ratios.end() - 1 - static_cast<std::ptrdiff_t>(ratios.size() / 1000);
        std::ranges::nth_element(ratios, rank);
        found.common = std::max(found.common, *rank - 1);
    }
    return found;
}

}  // namespace

TEST_CASE("liquid: a dam breaks as in the experiment", "[liquid][figures]") {
    const Break found = breakDam(12, 6, 1000, 5);
    const Match match225 = match(found.front, fronts225),
                match1125 = match(found.front, fronts1125);
    note("time shift, 2.25 in", match225.shift);
    note("largest compression until the far wall", found.before);
    note("largest mean", found.mean);
    REQUIRE(report("front, 2.25 in, of its range", match225.error, 0.04));
    REQUIRE(report("front, 1.125 in, of its range", match1125.error, 0.07));
    REQUIRE(found.outside == 0);
}

TEST_CASE("liquid: a finer dam breaks as in the experiment", "[liquid][long]") {
    const Break found = breakDam(24, 12, 2200, 9);
    const Match match225 = match(found.front, fronts225),
                match1125 = match(found.front, fronts1125);
    note("time shift, 2.25 in", match225.shift);
    note("time shift, 1.125 in", match1125.shift);
    note("largest compression after the far wall", found.after);
    note("of all but a thousandth of particles", found.common);
    note("largest mean", found.mean);
    REQUIRE(report("front, 2.25 in, of its range", match225.error, 0.04));
    REQUIRE(report("front, 1.125 in, of its range", match1125.error, 0.07));
    REQUIRE(report("largest compression until the far wall", found.before, 0.01));
    REQUIRE(found.outside == 0);
}

// It falls, splashes and comes to rest. Where it hits, its compression holds a fifth of the energy
// for a moment; from second to second there is only ever less, down to what it has at rest, and in
// the end it fills what it must.
TEST_CASE("liquid: what splashes gains no energy, and keeps its volume", "[liquid][FX5]") {
    constexpr int n = 9;
    constexpr double d = 0.02, wide = 2 * n * d, deep = n * d;
    Pool pool(blockOf(n, n, n, d, 0.05), d, openTank(wide, deep));
    pool.fall(g);
    Solver<float> solver(pool.world, perSecond(1200));
    const auto energy = [&] {  // J/kg
        const auto x = solver.positions(), v = solver.velocities();
        double sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += g * x[i].y + dot(v[i], v[i]) / 2;
        return sum / static_cast<double>(x.size());
    };
    constexpr double low = g * n * d / 4;  // of what stands half as high as it began
    const double fell = energy() - low;
    double last = low + fell, mean = 0;
    for (int second = 0; second < 6; ++second) {
        mean = 0;
        for (int frame = 0; frame < 50; ++frame) {
            solver.frame();
            mean += energy() / 50;
        }
        note("energy above rest, of what fell, in second " + std::to_string(second + 1),
             (mean - low) / fell);
        CHECK(mean < last);
        last = mean;
    }
    double middle = 0;
    for (const Vec<double>& x : solver.positions()) middle += x.y / (n * n * n);
    REQUIRE(solver.failures() == 0);
    CHECK(report("volume by its level", std::fabs(middle / (n * d / 4) - 1), 0.02));
    CHECK(mean < low + 0.05 * fell);
}
