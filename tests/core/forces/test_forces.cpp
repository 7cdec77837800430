// Gravity, fields and noise; the air is in test_air.cpp.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/report.h"

#include <plait/forces/field.h>
#include <plait/forces/gravity.h>
#include <plait/forces/noise.h>

#include <cmath>
#include <functional>

using namespace plait;
using namespace plait::test;

namespace {

World threePlates() {
    World world;
    for (const double density : {0.1, 1.0, 70.0})
        world.add(grid({.columns = 5, .rows = 4}), {.density = density});
    return world;
}

}  // namespace

TEMPLATE_TEST_CASE("Gravity moves all masses alike, but not what it ignores or what is pinned",
                   "[forces][AW9][AW10]", float, double) {
    using Real = TestType;
    World world = threePlates();
    world.pin({0});
    Gravity<Real> gravity(world, {.acceleration = {3, -9, 0.5}, .ignore = {{40, 60}}});
    State<Real> state = stateOf<Real>(world);
    Workers workers(1);
    constexpr double h = 1.0 / 256;  // exact in either precision
    for (int s = 0; s < 512; ++s) act<Real>(state, {&gravity}, h, workers);
    for (std::size_t i = 0; i < 60; ++i) {
        const bool moves = i > 0 && i < 40;
        CHECK(widened(state.velocity[i].v) ==
              (moves ? Vec<double>{6, -18, 1} : Vec<double>{0, 0, 0}));
    }
}

TEST_CASE("Space scale divides gravity", "[forces]") {
    World world = threePlates();
    Gravity<double> gravity(world, {.spaceScale = 0.01});
    State<double> state = stateOf<double>(world);
    Workers workers(1);
    act<double>(state, {&gravity}, 0.5, workers);
    CHECK(report("velocity after 0.5 s in centimetres", deviation(state, {0, -490.5, 0}), 1e-12));
}

TEST_CASE("Gravity refuses bad numbers by name", "[forces]") {
    const World world = threePlates();
    const auto refuses = [&](const GravityOptions& options, const std::string& words) {
        CHECK_THROWS_WITH(Gravity<float>(world, options), words);
    };
    refuses({.spaceScale = 0}, "gravity: space scale must be positive");
    refuses({.spaceScale = NAN}, "gravity: space scale must be positive");
    refuses({.acceleration = {0, INFINITY, 0}}, "gravity: acceleration must be finite");
    refuses({.ignore = {{0, 61}}}, "gravity: no such vertices: 0 to 61");
    refuses({.ignore = {{-1, 4}}}, "gravity: no such vertices: -1 to 4");
}

TEST_CASE("A field is evaluated once a frame and applied every substep", "[forces]") {
    World world = threePlates();
    world.pin({25});
    int calls = 0;
    const auto swirl = [&calls](const Vec<double>& x, double t) {
        ++calls;
        return Vec<double>{-x.y, x.x, t};
    };
    Field<double> field(world, {.acceleration = swirl, .objects = {{20, 40}}});
    State<double> state = stateOf<double>(world);
    Workers workers(1);
    for (int frame = 0; frame < 3; ++frame) {
        field.beginFrame(state, frame, frame + 1, workers);
        for (int s = 0; s < 10; ++s) act<double>(state, {&field}, 0.1, workers);
    }
    CHECK(calls == 3 * 20);
    double worst = 0;
    for (std::size_t i = 0; i < 60; ++i) {
        const Vec<double> x = world.start[i];
        const bool moves = i >= 20 && i < 40 && i != 25;
        const Vec<double> v = moves ? Vec<double>{-3 * x.y, 3 * x.x, 3} : Vec<double>{0, 0, 0};
        worst = std::max(worst, length(state.velocity[i].v - v));
    }
    CHECK(report("velocity in a field", worst, 1e-13));
    CHECK_THROWS_WITH(Field<float>(world, {.name = "vortex"}), "vortex: no acceleration");
}

TEST_CASE("Noise has mean 0, root mean square 1, and its bound", "[forces]") {
    // Points that fill cells evenly, over many cells and seeds: irrational steps.
    constexpr int n = 400'000;
    Vec<double> sum{0, 0, 0};
    double squares[3] = {}, products[3] = {}, largest = 0;
    for (int i = 0; i < n; ++i) {
        const Vec<double> x{i * 0.7548776662466927, i * 0.5698402909980532,
                            -i * 0.8191725133961645};
        const Vec<double> a = coherentNoise(x, i * 0.6710436067037893, std::uint64_t(i % 64));
        sum += a;
        squares[0] += a.x * a.x, squares[1] += a.y * a.y, squares[2] += a.z * a.z;
        products[0] += a.x * a.y, products[1] += a.y * a.z, products[2] += a.z * a.x;
        largest = std::max({largest, std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
    }
    CHECK(report("mean of 4e5 points", length(sum) / n, 0.01));
    for (int k = 0; k < 3; ++k) {
        CHECK(report("root mean square - 1", std::fabs(std::sqrt(squares[k] / n) - 1), 0.01));
        CHECK(report("correlation of two components", std::fabs(products[k]) / n, 0.01));
    }
    note("largest component", largest);
    CHECK(largest > 3);
    CHECK(largest < 5.917);
}

TEST_CASE("Noise is smooth across cells, in space and in time", "[forces]") {
    // A twice differentiable function has a bounded second difference; one that jumps by a, or
    // whose slope does, has a / d^2 or a / d in d.
    for (const double d : {1e-2, 1e-3, 1e-4}) {
        double worst = 0;
        for (int axis = 0; axis < 4; ++axis)
            for (int i = 0; i < 400; ++i) {
                const double f = 0.37 * i;
                // Every second point lies on the border of a cell.
                const double at = i % 2 ? std::floor(f) - 50 : f - 50;
                const auto value = [&](double a) {
                    const Vec<double> x{axis == 0 ? a : 0.3 * f, axis == 1 ? a : 0.41,
                                        axis == 2 ? a : f};
                    return coherentNoise(x, axis == 3 ? a : 0.77 * f, 5);
                };
                const Vec<double> second = value(at + d) - 2.0 * value(at) + value(at - d);
                worst = std::max(worst, length(second) / (d * d));
            }
        CHECK(report("second difference / d^2", worst, 60));
        CHECK(worst > 1);
    }
}

TEST_CASE("Noise: same seed same bits, other seed other noise, quiet far out", "[forces]") {
    double difference = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec<double> x{0.31 * i, -1.7 * i, 0.9};
        CHECK(coherentNoise(x, 0.2 * i, 7) == coherentNoise(x, 0.2 * i, 7));
        difference += length(coherentNoise(x, 0.2 * i, 7) - coherentNoise(x, 0.2 * i, 8)) / 1000;
    }
    note("mean distance between two seeds (independent: about 2.2)", difference);
    CHECK(difference > 1.8);
    // The bits of one run, for all compilers and machines.
    CHECK(coherentNoise({0.3, -12.7, 4.1}, 2.6, 1) ==
          Vec<double>{-0x1.97fd302e571aep+0, -0x1.7881c6094afp-3, 0x1.ea51cb930f7b6p-1});
    CHECK(coherentNoise({3, -2, 5}, 7, 1) == Vec<double>{0, 0, 0});
    CHECK(coherentNoise({1e16, 0.5, 0.5}, 0.5, 1) == Vec<double>{0, 0, 0});
    CHECK(coherentNoise({NAN, 0.5, 0.5}, 0.5, 1) == Vec<double>{0, 0, 0});
    CHECK(coherentNoise({0.5, 0.5, 0.5}, -INFINITY, 1) == Vec<double>{0, 0, 0});
}
