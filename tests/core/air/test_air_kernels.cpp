// The inner loops of the air: the same bits whatever runs them, in float what they are in double,
// and gusts within a frame.
#include "air_run.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/forces/noise.h>

#include <algorithm>
#include <cstring>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double frame = 1.0 / 24;
constexpr int substeps = 4;

// A crumpled sheet, hairs on its first vertex and on one another, pins; more than two grains of
// triangles and of edges, and no number of either that fills a block.
World hairySheet() {
    constexpr int columns = 23, rows = 19, strands = 13, links = 47;
    Random random(5);
    Shape sheet = grid({.columns = columns, .rows = rows});
    Simplices simplices;
    for (int i = 0; i < sheet.complex.count(2); ++i)
        simplices.triangles.push_back(sheet.complex.triangle(i));
    int count = columns * rows;
    for (int s = 0; s < strands; ++s)
        for (int k = 0; k < links; ++k, ++count) {
            simplices.edges.push_back({k == 0 ? 0 : count - 1, count});
            sheet.positions.push_back({0.01 * s, -0.02 * (k + 1), 0.1});
        }
    std::vector<Vec<double>> start, velocity;
    for (const Vec<double>& x : sheet.positions) {
        start.push_back(x + 0.01 * random.point(1));
        velocity.push_back(5.0 * random.point(1));
    }
    World world;
    world.add({SimplicialComplex(count, simplices), sheet.positions},
              {.density = sigma, .start = start, .velocity = velocity});
    world.pin({0, 11, 22, 300});
    for (const int i : {0, 11, 22, 300}) world.velocity[static_cast<std::size_t>(i)] = {0, 0, 0};
    return world;
}

AirOptions options(AirForm form, double lift, double noise) {
    return {.form = form,
            .drag = 1.2,
            .lift = lift,
            .wind = {.velocity = steady({6, 1, -2}), .noise = noise, .noiseLength = 0.3}};
}

// The velocities after two frames of air and gravity.
template <class Real>
std::vector<Padded<Real>> blown(const World& world, const AirOptions& options, KernelChoice kernels,
                                int threads) {
    Gravity<Real> gravity(world, {});
    Air<Real> air(world, options, kernels);
    State<Real> state = stateOf<Real>(world);
    Drawer<Real> kept;
    air.furnish(kept);
    Workers workers(threads);
    for (int s = 0; s < 2 * substeps; ++s) {
        const double t = s * frame / substeps, h = frame / substeps;
        if (s % substeps == 0) air.beginFrame(state, t, t + frame, workers);
        air.prepare(state, kept, t, h, workers);
        gravity.apply(state, t, h, workers);
        air.apply(state, t, h, workers);
        ++state.substep;
    }
    return state.velocity;
}

std::vector<AirOptions> everyForm() {
    std::vector<AirOptions> all;
    for (const AirForm form : {legacy, physical})
        for (const double lift : {0.0, 0.4})
            for (const double noise : {0.0, 2.0}) all.push_back(options(form, lift, noise));
    all.push_back(options(physical, 0.4, 2));
    all.back().carried = {.mass = 0.5, .reach = 0.3};
    return all;
}

}  // namespace

TEMPLATE_TEST_CASE("Any width, instruction set and number of threads blows with the same bits",
                   "[air]", float, double) {
    const World world = hairySheet();
    CHECK((world.complex.count(2) % 16 != 0 && world.complex.count(2) > 512));
    int compared = 0;
    for (const AirOptions& of : everyForm()) {
        const auto first = blown<TestType>(world, of, {Isa::v2, 1}, 1);
        for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
            for (const int lanes : {1, 4, 8, 16})
                for (const int threads : {1, 2, 3, 8}) {
                    if (!available({isa, lanes})) continue;
                    if (threads > 1 && (of.lift == 0 || of.wind.noise == 0)) continue;
                    const auto other = blown<TestType>(world, of, {isa, lanes}, threads);
                    INFO("v" << static_cast<int>(isa) + 2 << " x " << lanes << ", " << threads
                             << " threads");
                    CHECK(std::memcmp(first.data(), other.data(), sizeof first[0] * first.size()) ==
                          0);
                    ++compared;
                }
    }
    note("runs compared", compared);
}

TEST_CASE("Packs of floats blow as double does", "[air]") {
    const World world = hairySheet();
    double worst = 0;
    for (const AirOptions& of : everyForm()) {
        const auto exact = blown<double>(world, of, {Isa::v2, 1}, 1);
        const auto fast = blown<float>(world, of, bestKernels(), 1);
        for (std::size_t i = 0; i < exact.size(); ++i)
            worst =
                std::max(worst, length(widened(fast[i].v) - exact[i].v) / (1 + length(exact[i].v)));
    }
    CHECK(report("difference of any velocity, over 1 m/s + itself", worst, 2e-6));
}

TEST_CASE("Gusts are exact where a frame begins and run straight to its end", "[air]") {
    // A light plate without a preferred direction moves with the gust of the place and time.
    const Wind wind{{}, 2.0, 0.7, 0.5, {3, 0, 1}};
    World world = plate(0.3, 1e-7);
    const auto velocityAt = [&](double t, bool inFrame) {
        Run run(world, {.form = legacy, .tangentialDrag = 1, .wind = wind});
        if (inFrame) run.air.beginFrame(run.state, 1, 1 + frame, run.workers);
        act<double>(run.state, {&run.air}, 1, run.workers, t);
        return run.state.velocity;
    };
    const auto from = velocityAt(1, false), to = velocityAt(1 + frame, false);
    double start = 0, straight = 0, error = 0;
    for (const double f : {0.0, 0.25, 0.5, 0.75}) {
        const auto inside = velocityAt(1 + f * frame, true), now = velocityAt(1 + f * frame, false);
        for (std::size_t i = 0; i + 1 < inside.size(); ++i) {
            const Vec<double> line = (1 - f) * from[i].v + f * to[i].v;
            straight = std::max(straight, length(inside[i].v - line));
            if (f == 0) start = std::max(start, length(inside[i].v - from[i].v));
            error = std::max(error, length(inside[i].v - now[i].v));
        }
    }
    CHECK(report("at the start", start, 1e-12));
    CHECK(report("from a straight line", straight, 1e-12));
    note("from the gusts themselves, m/s", error);
    CHECK(error > 1e-4);
}

TEST_CASE("Straight gusts are in error by 0.9 c^2, 1.8 c^2 if they also travel", "[air]") {
    for (const double c : {0.04, 0.1, 0.25})
        for (const int travels : {0, 1}) {
            double square = 0;
            constexpr int points = 4000;
            for (int i = 0; i < points; ++i) {
                const Vec<double> x{i * 0.7548776662466927, i * 0.5698402909980532,
                                    -i * 0.8191725133961645};
                const auto at = [&](double f) {
                    return coherentNoise(x - Vec<double>{travels * f * c, 0, 0},
                                         i * 0.6710436067037893 + f * c, 3);
                };
                for (const double f : {0.1, 0.3, 0.5, 0.7, 0.9}) {
                    const Vec<double> error = at(0) + f * (at(1) - at(0)) - at(f);
                    square += dot(error, error) / (3 * 5 * points);
                }
            }
            const double bound = (travels ? 1.9 : 1.0) * c * c;
            CHECK(report("of frames of " + std::to_string(c) + " cells", std::sqrt(square), bound));
            CHECK(std::sqrt(square) > 0.8 * bound);
        }
}
