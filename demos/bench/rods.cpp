#include "rods.h"

#include "demos/study/median.h"
#include "demos/study/references/heavy_rod.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/machine.h"

#include <plait/forces/gravity.h>
#include <plait/rods/bend_vector.h>
#include <plait/rods/chain_set.h>
#include <plait/rods/rod.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace plait {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double gamma = 10, g = 9.81;  // w L^3 / B; m/s^2

// Rods of 1 m, clamped in the middle of their first link, side by side: of points only.
World pointRods(int rods, int links) {
    World world;
    const double l = 1 / (links - 0.5);
    Chains chains;
    Rows<Stretch> stretch;
    Rows<BendVector> bends;
    for (int r = 0; r < rods; ++r) {
        const double z = 0.01 * r;
        const Range rod = world.add(
            chain({.links = links, .from = {-l / 2, 0, z}, .to = {1, 0, z}}), {.density = 1});
        world.pin({rod.first, rod.first + 1});
        chains.addCurve(pointStencils(rod));
        for (int v = rod.first; v + 1 < rod.last; ++v) {
            stretch.ids.insert(stretch.ids.end(), {v, v + 1});
            stretch.rows.push_back({l, 0, 0});
            if (v + 2 == rod.last) continue;
            bends.ids.insert(bends.ids.end(), {v, v + 1, v + 2});
            bends.rows.push_back({l * gamma / g});
        }
    }
    chains.add(stretch);
    chains.add(bends);
    chains.constrain(world, {.name = "rods"});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    return world;
}

World framedRod(const Shape& curve) {
    World world;
    const Rod rod =
        addRod(world, curve, {.wire = {.along = 2.5e-3, .across = 0.62e-3}}, {.name = "rod"});
    world.pin({rod.points.first, rod.points.first + 1, rod.directors.first});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    return world;
}

struct Case {
    std::string name;
    World world;
    int segments, substeps;  // of all rods; in 1/60 s
    int links = 0;           // of the one rod that is held to its chain
    double seconds = 1;
};

std::vector<Case> cases() {
    const Shape coil = helix({.links = 2064, .radius = 0.034, .turns = 86, .pitch = 0.62e-3},
                             {.across = {0, 1, 0}, .up = {1, 0, 0}});
    return {{"straight, points only", pointRods(1, 64), 64, 2, 64, 8},
            {"straight, points only", pointRods(1, 64), 64, 10, 64, 8},
            {"straight, with frames", framedRod(chain({.links = 64})), 64, 2},
            {"coil of 86 turns, with frames", framedRod(coil), 2064, 2},
            {"1,000 strands of 32, points only", pointRods(1000, 32), 32000, 2}};
}

struct Cost {
    double milliseconds, fastest;  // of frames, the middle one's
    Vec<double> tip;               // of the last rod
};

Cost costOf(const Case& of, int threads) {
    SolverOptions options{
        .sweeps = Sweeps::oneWay,
        .schedule = {.substeps = of.substeps, .frameRate = {60, 1}, .iterations = 1}};
    options.damping = 1 - std::exp(-4.0 / 24);
    options.threads = threads;
    Solver<float> solver(of.world, options);
    std::vector<double> milliseconds;
    for (int frame = 0; frame < 60 * of.seconds; ++frame) {
        stopIfInterrupted();
        const auto start = Clock::now();
        solver.frame();
        milliseconds.push_back(1000 * std::chrono::duration<double>(Clock::now() - start).count());
    }
    return {median(milliseconds), *std::ranges::min_element(milliseconds),
            solver.positions().back()};
}

void printLine(const std::string& name, int segments, int substeps, const std::string& threads,
               double milliseconds, double fastest, double error) {
    const double nanoseconds = 1e6 / segments / substeps;
    std::printf("%-34s %8d %9d %8s %10.4f %9.0f %8.0f", name.c_str(), segments, substeps,
                threads.c_str(), milliseconds, milliseconds * nanoseconds, fastest * nanoseconds);
    if (error > 0) std::printf(" %10.3f", error);
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace

int benchRods() {
    const Machine machine = thisMachine();
    std::printf("rods, each frame 1/60 s; %s, %d cores, kernels %s with %d lanes\n",
                machine.processor.c_str(), machine.cores, machine.kernels.c_str(), machine.lanes);
    std::printf("%-34s %8s %9s %8s %10s %18s %10s\n", "", "segments", "substeps", "threads", "ms a",
                "ns a segment and", "tip off, %");
    std::printf("%-34s %8s %9s %8s %10s %9s %8s %10s\n", "", "", "a frame", "", "frame", "substep",
                "fastest", "of length");
    for (const Case& of : cases())
        for (const int threads : {1, 2}) {
            const Cost cost = costOf(of, threads);
            const RodTip truth = of.links > 0 ? heavyRodTip(gamma, of.links) : RodTip{};
            const double off = std::hypot(cost.tip.x - truth.reach, -cost.tip.y - truth.drop);
            printLine(of.name, of.segments, of.substeps, std::to_string(threads), cost.milliseconds,
                      cost.fastest, of.links > 0 ? 100 * off : 0);
        }
    // Measured on a core of another machine; errors of the drop.
    for (const auto& [substeps, off] : {std::pair{10, 9.1}, {20, 2.3}, {50, 0.3}, {100, 2.0}})
        printLine("Jolt, straight", 64, substeps, "1", 43e-6 * 64 * substeps, 43e-6 * 64 * substeps,
                  off);
    printLine("Jolt, 1,000 strands of 32", 32000, 2, "1", 3.2, 3.2, 0);
    return exitOk;
}

}  // namespace plait
