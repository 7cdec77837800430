#include "core.h"

#include "floor.h"

#include <plait/forces/gravity.h>
#include <plait/sets/constraint_set.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace plait {
namespace {

constexpr double h = 1e-4, g = -9.81;
constexpr int repeats = 7;

template <class Body>
double seconds(const Body& body) {
    const auto start = std::chrono::steady_clock::now();
    body();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

World sheet(int n) {
    World world;
    const Range all =
        world.add(grid({.columns = n, .rows = n}, {.up = {0, 0, 1}}), {.density = 0.2});
    world.pin({0, n - 1});
    world.act<Gravity>(GravityOptions{.acceleration = {0, g, 0}});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest),
                    {.name = "stretch"});
    return world;
}

// The same sheet as plain arrays, for the hand-written loops.
struct Floor {
    std::vector<Particle<float>> particles;
    std::vector<Padded<float>> velocity, before;
    std::vector<FloorColor> colors;

    explicit Floor(const World& world) {
        const int count = static_cast<int>(world.start.size());
        for (std::size_t i = 0; i < world.start.size(); ++i) {
            const Vec<double> x = world.start[i];
            const double w = world.pinned[i] ? 0 : 1 / world.mass[i];
            const Vec<float> near{float(x.x), float(x.y), float(x.z)};
            particles.push_back({near,
                                 float(w),
                                 {float(x.x - near.x), float(x.y - near.y), float(x.z - near.z)},
                                 0});
        }
        particles.push_back({});
        velocity.resize(particles.size(), {});
        before.resize(particles.size(), {});
        const auto rows = restRows<Stretch>(edgeStencils(world.complex, {0, count}), world.rest);
        const std::vector<int> color = greedyColors(rows.ids, 2, count);
        colors.resize(static_cast<std::size_t>(*std::max_element(color.begin(), color.end())) + 1);
        std::vector<int> filled(colors.size(), 0);
        for (std::size_t i = 0; i < color.size(); ++i) {
            const auto c = static_cast<std::size_t>(color[i]);
            const int lane = filled[c]++ % 16;
            if (lane == 0) {
                FloorColor::Block block{};
                for (auto& ids : block.ids) std::fill(ids, ids + 16, count);
                colors[c].blocks.push_back(block);
            }
            FloorColor::Block& block = colors[c].blocks.back();
            block.ids[0][lane] = rows.ids[2 * i];
            block.ids[1][lane] = rows.ids[2 * i + 1];
            block.rows[0][lane] = float(rows.rows[i].rest);
        }
    }

    void clear() {
        for (FloorColor& color : colors)
            for (auto& block : color.blocks) std::memset(block.lambda, 0, sizeof block.lambda);
    }
    void sweep(FloorColor& color, Workers& workers) {
        workers.forBlocks(static_cast<int>(color.blocks.size()), 16, [&](int begin, int end) {
            floorStretch(particles.data(), color.blocks.data(), float(1 / (h * h)), begin, end);
        });
    }
    void palindrome(Workers& workers) {
        for (FloorColor& color : colors) sweep(color, workers);
        for (std::size_t c = colors.size(); c-- > 0;) sweep(colors[c], workers);
    }
    void substep(Workers& workers) {
        const int count = static_cast<int>(particles.size()) - 1;
        workers.forBlocks(count, 1024, [&](int begin, int end) {
            floorPredict(particles.data(), velocity.data(), before.data(), float(h), float(g),
                         begin, end);
        });
        clear();
        palindrome(workers);
        workers.forBlocks(count, 1024, [&](int begin, int end) {
            floorUpdate(particles.data(), velocity.data(), before.data(), float(h), begin, end);
        });
    }
};

void compare(int n, int threads) {
    const World world = sheet(n);
    const int count = n * n;
    const auto rows = restRows<Stretch>(edgeStencils(world.complex, {0, count}), world.rest);
    const int substeps = std::max(2, 400000 / count);
    const int perSecond = static_cast<int>(std::lround(1 / h / substeps));
    Solver<float> solver(
        world, {.schedule = {.substeps = substeps, .frameRate = {perSecond, 1}, .iterations = 1},
                .threads = threads});
    ConstraintSet<Stretch, float> set(rows, count, bestKernels());
    std::vector<Particle<float>> particles = solver.state().particles;
    const Sweep<float> sweep{&particles[0].x.x, nullptr, float(1 / (h * h)), 1, 1};
    Workers workers(threads);
    Floor floor(world);

    // A and B in turn, so that a change of the machine's mood meets both.
    std::vector<double> core, hand, coreStep, handStep;
    for (int i = -1; i < repeats; ++i) {
        std::vector<double> t{seconds([&] {
                                  for (int k = 0; k < substeps; ++k) {
                                      set.project(sweep, Direction::forward, workers);
                                      set.project(sweep, Direction::backward, workers);
                                  }
                              }),
                              seconds([&] {
                                  for (int k = 0; k < substeps; ++k) floor.palindrome(workers);
                              }),
                              seconds([&] { solver.frame(); }), seconds([&] {
                                  for (int k = 0; k < substeps; ++k) floor.substep(workers);
                              })};
        if (i < 0) continue;  // warm-up
        core.push_back(t[0]), hand.push_back(t[1]), coreStep.push_back(t[2]),
            handStep.push_back(t[3]);
    }
    const double projection = 1e9 / (2.0 * substeps * rows.size()), step = 1e6 / substeps;
    std::printf("%9d %7d %12.2f %9.2f %7.2f %14.1f %9.1f %7.2f\n", count, threads,
                median(core) * projection, median(hand) * projection, median(core) / median(hand),
                median(coreStep) * step, median(handStep) * step,
                median(coreStep) / median(handStep));
}

}  // namespace

int benchCore() {
    if (!floorAvailable()) {
        std::printf("the hand-written floor needs AVX2, which this processor has not\n");
        return 0;
    }
    const KernelChoice kernels = bestKernels();
    std::printf(
        "stretch on a sheet, float, kernels x86-64-v%d with %d lanes, medians of %d, in turn\n\n",
        static_cast<int>(kernels.isa) + 2, kernels.lanes, repeats);
    std::printf("%9s %7s %12s %9s %7s %14s %9s %7s\n", "", "", "ns a pro-", "by hand", "ratio",
                "us a substep", "by hand", "ratio");
    std::printf("%9s %7s %12s\n", "vertices", "threads", "jection");
    for (const int n : {100, 316, 1000})
        for (const int threads : {1, 2}) compare(n, threads);
    return 0;
}

}  // namespace plait
