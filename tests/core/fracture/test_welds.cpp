// Welds break where theory says that glass does.
#include "tests/catch.h"
#include "tests/report.h"
#include "welded_worlds.h"

#include <plait/numbers/splitmix.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double strength = 45e6, thickness = 0.004;  // Pa, m
constexpr WeldMatter even{.strength = strength, .scatter = 0};

// The largest load, as a part of what theory has break it, that does not: by bisection.
template <class Breaks>
double breakingAt(const Breaks& breaks) {
    double low = 0.5, high = 1.5;
    REQUIRE(!breaks(low));
    REQUIRE(breaks(high));
    while (high - low > 1e-3) (breaks((low + high) / 2) ? high : low) = (low + high) / 2;
    return low;
}

// A strip held at one end under its own weight, of the length at which sigma = 3 rho g L^2 / t.
World cantilever(const Pattern& strip, double gravity, const WeldMatter& matter = even) {
    World world;
    const double width = strip.pane.height;
    const int clamp = addBox(world, {0.1, width, 0.05}, {-0.05 - 20e-6, width / 2, 0}, glass);
    pinPiece(world, clamp);
    const std::vector<int> cells = addCells(world, strip, {});
    weldPieces(world, weldsOf(strip, {}, cells, {-1, -1, -1, clamp}), {.matter = matter});
    world.act<Gravity>(GravityOptions{.acceleration = {0, 0, -gravity}});
    return world;
}

bool breaks(const World& world, const Steps& steps, int frames = 1) {
    Solver<float> solver(world, steps.options());
    for (int frame = 0; frame < frames; ++frame) solver.frame();
    return brokenIn(world, solver) > 0;
}

// Gravity that grows, so that contacts load slowly: part(t) of g.
struct GrowingOptions {
    double from, perSecond;  // parts of g

    double part(double t) const { return from + perSecond * t; }
    double strength() const { return 9.81; }
};

template <class Real>
class Growing : public Force<Real> {
public:
    Growing(const World&, const GrowingOptions& options) : options_(options) {}
    std::string name() const override { return "growing"; }
    void apply(State<Real>& state, double t, double h, Workers&) override {
        const auto change = static_cast<Real>(h * 9.81 * options_.part(t));
        for (int i = 0; i < state.count(); ++i)
            if (state.particles[i].w > 0) state.velocity[i].v.z -= change;
    }

private:
    GrowingOptions options_;
};

constexpr GrowingOptions growing{.from = 0, .perSecond = 0.7};

// A strip on two supports 0.5 m apart, and a weight on its middle that breaks it by g:
// P = 2 sigma b t^2 / 3 L less what its own weight bends, w L^2 / 8.
World threePoint() {
    constexpr double l = 0.5, b = 0.1, over = 0.01, edge = 1e-3, g = 9.81;
    World world;
    const Pattern strip = row(l + 2 * over, b, thickness, 26);
    const std::vector<int> cells = addCells(world, strip, {-l / 2 - over, -b / 2, 0});
    const double tall = 0.02, below = -thickness / 2 - 2 * skin - tall / 2;
    for (const double x : {-l / 2, l / 2})
        pinPiece(world, addBox(world, {edge, b, tall}, {x, 0, below}, glass));
    const double own = glass * thickness * b * g * (l * l / 8 - over * over / 2) / (l / 4);
    const double p = 2 * strength * b * thickness * thickness / (3 * l) - own;
    // Low, so that it does not tip.
    constexpr double low = 1e-3;
    addBox(world, {edge, b, low}, {0, 0, thickness / 2 + 2 * skin + low / 2},
           p / g / (edge * b * low));
    weldPieces(world, weldsOf(strip, {-l / 2 - over, -b / 2, 0}, cells, {-1, -1, -1, -1}),
               {.matter = even});
    meetAll(world);
    world.act<Growing>(growing);
    return world;
}

// The part of g at which it breaks.
double breakingLoad(const World& world, const Steps& steps) {
    SolverOptions options = Steps{1, steps.iterations}.options();
    options.schedule.frameRate = {60 * steps.substeps, 1};
    Solver<float> solver(world, options);
    while (brokenIn(world, solver) == 0 && growing.part(solver.time()) < 1.4) solver.frame();
    return growing.part(solver.time());
}

// Of x = n L, how uneven it is: the length at which a cantilever breaks goes as the root of its
// load.
double lengthOff(double load) { return std::fabs(std::sqrt(load) - 1); }

}  // namespace

TEST_CASE("welds: a cantilever of one row breaks at its length", "[welds][UN11]") {
    const double length = std::sqrt(strength * thickness / (3 * glass * 9.81));
    note("length at which glass of 4 mm breaks, m", length);
    for (const int cells : {20, 60}) {
        const Pattern strip = row(length, 0.1, thickness, cells);
        const double load =
            breakingAt([&](double part) { return breaks(cantilever(strip, 9.81 * part), {}); });
        REQUIRE(report("cantilever's length, off, " + std::to_string(cells) + " cells",
                       lengthOff(load), 0.03));
    }
}

TEST_CASE("welds: what breaks them grows as their strength", "[welds][BR1]") {
    const Pattern strip =
        row(std::sqrt(strength * thickness / (3 * glass * 9.81)), 0.1, thickness, 20);
    for (const double times : {0.25, 1.0, 4.0}) {
        const WeldMatter matter{.strength = times * strength, .scatter = 0};
        const double load = breakingAt([&](double part) {
            return breaks(cantilever(strip, 9.81 * times * part, matter), {});
        });
        REQUIRE(report("load by strength, times " + std::to_string(times), std::fabs(load - 1),
                       2 * 0.03));
    }
}

TEST_CASE("welds: neither substeps nor iterations decide what breaks", "[welds][BR7][UN11]") {
    const Pattern strip =
        row(std::sqrt(strength * thickness / (3 * glass * 9.81)), 0.1, thickness, 20);
    double least = 2, most = 0;
    for (const Steps& steps : {Steps{1, 5}, Steps{4, 10}, Steps{10, 10}, Steps{10, 50}}) {
        const double load =
            breakingAt([&](double part) { return breaks(cantilever(strip, 9.81 * part), steps); });
        least = std::min(least, load);
        most = std::max(most, load);
    }
    REQUIRE(report("cantilever's load over 1 to 10 substeps, 5 to 50 iterations, off",
                   most / least - 1, 0.05));
}

TEST_CASE("welds: a strip on two supports breaks under its weight", "[welds][BR7]") {
    double least = 2, most = 0;
    // At 60 a second contacts that cross are put back, and give forces that are off.
    for (const Steps& steps : {Steps{2, 5}, Steps{2, 10}, Steps{8, 10}, Steps{10, 50}}) {
        const double load = breakingLoad(threePoint(), steps);
        least = std::min(least, load), most = std::max(most, load);
        REQUIRE(report("three-point load, off, substeps " + std::to_string(steps.substeps),
                       std::fabs(load - 1), 0.03));
    }
    REQUIRE(report("the same over substeps and iterations", most / least - 1, 0.05));
}

TEST_CASE("welds: irregular strips break within limits", "[welds][figures][BR7]") {
    const double length = std::sqrt(strength * thickness / (3 * glass * 9.81));
    for (const int cells : {300, 1200}) {
        const Pane pane{.width = length, .height = 0.3, .thickness = thickness};
        const Pattern strip = cut(pane, evenSites(pane, cells, 1));
        const double load =
            breakingAt([&](double part) { return breaks(cantilever(strip, 9.81 * part), {1, 1}); });
        REQUIRE(report("irregular cantilever's length, off, " + std::to_string(cells) + " cells",
                       lengthOff(load), 0.08));
    }
}

// Hung by one end, with a weight at the other.
TEST_CASE("welds: the weakest goes first, and alone", "[welds]") {
    constexpr int cells = 10;
    constexpr double width = 0.02, weight = 50;
    for (const std::uint64_t seed : {1, 2, 3}) {
        World world;
        const Pattern strip = row(0.2, width, thickness, cells);
        const int clamp = addBox(world, {0.1, width, 0.05}, {-0.05 - 20e-6, width / 2, 0}, glass);
        pinPiece(world, clamp);
        const std::vector<int> pieces = addCells(world, strip, {});
        const double side = 0.05;
        const int load = addBox(world, {side, width, side}, {0.2 + side / 2 + 20e-6, width / 2, 0},
                                weight / (side * width * side));
        const auto welds = weldsOf(strip, {}, pieces, {-1, load, -1, clamp});
        const WeldMatter matter{.strength = strength, .scatter = 0.3, .seed = seed};
        weldPieces(world, welds, {.matter = matter});
        // What each bears of 1 m/s^2, by what hangs on it.
        Splitmix random(seed);
        double least = 1e30;
        std::size_t weakest = 0;
        for (std::size_t i = 0; i < welds.size(); ++i) {
            const double below = glass * width * thickness * (0.2 - welds[i].at.x) + weight;
            const double most = strength * (1 + 0.3 * random.both()) * width * thickness / below;
            if (most < least) least = most, weakest = i;
        }
        for (const double part : {0.999, 1.001}) {
            World pulled = world;
            pulled.act<Gravity>(GravityOptions{.acceleration = {part * least, 0, 0}});
            Solver<double> solver(pulled, Steps{}.options());
            solver.frame();
            const auto holds = holdingOf(pulled, solver.state());
            REQUIRE(brokenIn(pulled, solver) == (part > 1 ? 1 : 0));
            REQUIRE(holds[weakest] == (part > 1 ? 0 : 1));
        }
    }
}

TEST_CASE("welds: what cannot be welded is refused", "[welds]") {
    World world;
    const Pattern strip = row(0.2, 0.02, thickness, 3);
    const auto welds = weldsOf(strip, {}, addCells(world, strip, {}), {-1, -1, -1, -1});
    REQUIRE(welds.size() == 2);
    auto strange = welds;
    strange[0].second = 7;
    REQUIRE_THROWS_WITH(weldPieces(world, strange), Catch::Contains("not there"));
    strange[0].second = strange[0].first;
    REQUIRE_THROWS_WITH(weldPieces(world, strange), Catch::Contains("itself"));
    REQUIRE_THROWS_WITH(weldPieces(world, welds, {.matter = {.strength = 0}}),
                        Catch::Contains("strength"));
    weldPieces(world, welds);
    REQUIRE_THROWS_WITH(weldPieces(world, welds), Catch::Contains("has welds"));
}
