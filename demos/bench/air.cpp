#include "air.h"

#include <plait/air/air.h>
#include <plait/solver.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace plait {
namespace {

constexpr int repeats = 7;

struct Form {
    const char* name;
    AirOptions options;
};

std::vector<Form> forms() {
    const auto wind = [](double) { return Vec<double>{0.3, 0.1, 8}; };
    AirOptions lift{.drag = 1.2, .lift = 1, .wind = {.velocity = wind}};
    AirOptions drag = lift, legacy = lift, gusty = lift, carried = lift;
    drag.lift = legacy.lift = 0;
    legacy.form = AirForm::legacy;
    gusty.wind.noise = 2;
    carried.carried = {.mass = 1, .reach = 0.2};
    return {{"legacy", legacy},
            {"physical", drag},
            {"physical, lift", lift},
            {"the same in gusts", gusty},
            {"physical, lift, carried", carried}};
}

// A sheet in disorder, so that every facet meets the air differently.
World sheet(int n) {
    const Shape shape = grid({.columns = n, .rows = n, .width = 1, .height = 1});
    std::vector<Vec<double>> start, velocity;
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        const double bend = static_cast<double>(i * 7919 % 1009) / 1009 - 0.5;
        start.push_back(shape.positions[i] + Vec<double>{0, 0, bend / n});
        velocity.push_back({bend, -bend, 2 * bend});
    }
    World world;
    world.add(shape, {.density = 0.2, .start = start, .velocity = velocity});
    return world;
}

// Median of ns per facet and substep, in frames of `substeps`.
double cost(const World& world, const AirOptions& options, int threads, int substeps) {
    constexpr double frame = 1.0 / 24;
    const double h = frame / substeps;
    Air<float> air(world, options);
    State<float> state = Solver<float>(world, {}).state();
    Drawer<float> kept;
    air.furnish(kept);
    Workers workers(threads);
    const FlushDenormals flush;
    std::vector<double> values;
    for (int i = -1; i < repeats; ++i) {
        const auto start = std::chrono::steady_clock::now();
        air.beginFrame(state, i * frame, (i + 1) * frame, workers);
        for (int s = 0; s < substeps; ++s) {
            air.prepare(state, kept, i * frame + s * h, h, workers);
            air.apply(state, i * frame + s * h, h, workers);
            ++state.substep;
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        if (i >= 0) values.push_back(taken.count());  // the first is a warm-up
    }
    std::sort(values.begin(), values.end());
    return 1e9 * values[repeats / 2] / substeps / world.complex.count(2);
}

}  // namespace

int benchAir() {
    constexpr int substeps = 100;
    const KernelChoice kernels = bestKernels();
    std::printf(
        "air on a sheet, float, kernels x86-64-v%d with %d lanes, ns per facet and substep, "
        "%d substeps a frame, medians of %d\n\n",
        static_cast<int>(kernels.isa) + 2, kernels.lanes, substeps, repeats);
    std::printf("%-30s %9s %9s %9s\n", "", "facets", "1 thread", "2 threads");
    for (const int n : {51, 201}) {
        const World world = sheet(n);
        for (const Form& form : forms())
            std::printf("%-30s %9d %9.2f %9.2f\n", form.name, world.complex.count(2),
                        cost(world, form.options, 1, substeps),
                        cost(world, form.options, 2, substeps));
    }
    return 0;
}

}  // namespace plait
