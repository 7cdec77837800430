#include "sheet.h"

#include "demos/runs/settings.h"
#include "demos/runs/simulation.h"
#include "demos/study/median.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/machine.h"

#include <plait/measure/energy.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace plait {
namespace {

using Clock = std::chrono::steady_clock;

struct Case {
    int vertices;  // along a side
    std::string solve;
    int substeps, iterations;
    std::string method = "xpbd", integrator = "first", precision = "float";
    double seconds = 2, mending = 0.8;
};

// One value a frame, the start first.
struct Course {
    std::vector<double> milliseconds, strain, lowest, energy;
    long evaluations = 0;  // a frame
    double setUp = 0;      // ms, of the scene and its solver
};

double valueOf(const Run& run, const RunFrame& frame, const std::string& metric) {
    for (std::size_t i = 0; i < run.scene.metrics.size(); ++i)
        if (run.scene.metrics[i].name == metric) return frame.metrics[i];
    return 0;
}

Course courseOf(const Case& of, int threads) {
    const auto since = [](Clock::time_point start) {
        return 1000 * std::chrono::duration<double>(Clock::now() - start).count();
    };
    const auto begin = Clock::now();
    const Run run = makeRun({{"scene", "hanging-sheet"},
                             {"fps", "60"},
                             {"seconds", std::to_string(of.seconds)},
                             {"substeps", std::to_string(of.substeps)},
                             {"iterations", std::to_string(of.iterations)},
                             {"method", of.method},
                             {"integrator", of.integrator},
                             {"precision", of.precision},
                             {"knob.size", std::to_string(of.vertices)},
                             {"knob.solve", of.solve},
                             {"knob.mending", std::to_string(of.mending)}});
    const World& world = run.scene.world;
    const auto simulation = makeSimulation(run, threads);
    Course course;
    course.setUp = since(begin);
    for (int i = 0; i <= run.frames(); ++i) {
        stopIfInterrupted();
        const auto start = Clock::now();
        if (i > 0) {
            simulation->advance();
            course.milliseconds.push_back(since(start));
        }
        const RunFrame frame = simulation->frame();
        course.strain.push_back(valueOf(run, frame, "strain"));
        course.lowest.push_back(valueOf(run, frame, "lowest"));
        course.energy.push_back(kineticEnergy(world.mass, frame.velocities) +
                                gravitationalEnergy(world.mass, frame.positions, {0, -9.81, 0}));
        course.evaluations = frame.evaluations / std::max(i, 1);
    }
    return course;
}

Case global(int n, const char* integrator, double seconds = 2) {
    return {.vertices = n,
            .solve = "sweeps",
            .substeps = 1,
            .iterations = 2,
            .method = "global",
            .integrator = integrator,
            .seconds = seconds};
}

Case strands(int n, int substeps, int iterations, double mending = 0.8) {
    return {.vertices = n,
            .solve = "strands",
            .substeps = substeps,
            .iterations = iterations,
            .mending = mending};
}

// Returns what a frame costs: ms, the middle one, and evaluations.
std::array<double, 2> print(const Case& of, int threads) {
    const Course course = courseOf(of, threads);
    const auto second = course.strain.begin() + 61;  // the first frame of the last second
    const auto least = std::min_element(course.lowest.begin(), course.lowest.begin() + 40);
    const std::string how = of.method != "xpbd" ? of.method + ", " + of.integrator
                            : of.mending > 0    ? of.solve + ", mended"
                                                : of.solve;
    std::printf("%5d  %-15s %4d x %-2d %7.2f M %8.0f %9.2f %7.0f ", of.vertices, how.c_str(),
                of.substeps, of.iterations, 1e-6 * static_cast<double>(course.evaluations),
                course.setUp, median(course.milliseconds),
                *std::max_element(course.milliseconds.begin(), course.milliseconds.end()));
    if (second < course.strain.end()) {
        double sum = 0;
        for (auto s = second; s != course.strain.end(); ++s) sum += *s;
        std::printf("%7.2f %6.2f %6.2f", *std::max_element(second, course.strain.end()),
                    sum / static_cast<double>(course.strain.end() - second),
                    *std::max_element(course.strain.begin(), second));
    } else {
        std::printf("%7s %6s %6.2f", "", "",
                    *std::max_element(course.strain.begin(), course.strain.end()));
    }
    std::printf("  %8.3f (%d) %7.3f %7.3f %9.1e\n", *least,
                static_cast<int>(least - course.lowest.begin()), course.lowest[60],
                course.energy[0] - course.energy[60],
                *std::max_element(course.energy.begin(), course.energy.end()) - course.energy[0]);
    std::fflush(stdout);
    return {median(course.milliseconds), static_cast<double>(course.evaluations)};
}

// By which power of a side's vertices costs grow from one sheet to another.
void printGrowth(int n, const std::array<double, 2>& cost, int large,
                 const std::array<double, 2>& more) {
    const auto power = [&](std::size_t i) {
        return std::log(more[i] / cost[i]) / std::log(double(large) / n);
    };
    std::printf(
        "1 %% from %d to %d vertices along a side grows as N^%.2f by time, N^%.2f by work\n", n,
        large, power(0), power(1));
}

}  // namespace

int benchSheet(int threads) {
    const Machine machine = thisMachine();
    std::printf("sheet on %s, %d cores, %d threads, kernels %s with %d lanes\n",
                machine.processor.c_str(), machine.cores, threads, machine.kernels.c_str(),
                machine.lanes);
    std::printf("%5s  %-15s %9s %9s %8s %9s %7s %7s %6s %6s  %13s %7s %7s %9s\n", "side", "held by",
                "substeps", "work", "set-up", "ms", "most", "strain", "mean", "before",
                "first swing", "at 1 s", "lost", "gained");
    std::printf("%5s  %-15s %9s %9s %8s %9s %7s %7s %6s %6s  %13s %7s %7s %9s\n", "", "", "a frame",
                "a frame", "ms", "a frame", "ms", "%", "%", "%", "m (frame)", "m", "J", "J");
    // What stays within 1 %, from 64 to 512; then what goes beyond, and other ways.
    std::vector<std::array<double, 2>> costs;
    for (const Case& of :
         {strands(64, 8, 1), strands(128, 8, 1), strands(256, 10, 1), strands(512, 24, 1)})
        costs.push_back(print(of, threads));
    for (const Case& of :
         {strands(64, 16, 2, 0.09), strands(128, 24, 2, 0.09), strands(256, 64, 1, 0.09),
          strands(512, 16, 1), strands(64, 8, 1, 0), strands(64, 20, 10, 0), strands(128, 8, 1, 0),
          global(64, "first"), global(64, "bdf2"),
          Case{64, "strands", 200, 4, "xpbd", "first", "double", 1, 0}, global(128, "first"),
          global(256, "first"), global(512, "first", 1)})
        print(of, threads);
    printGrowth(64, costs.front(), 512, costs.back());
    return exitOk;
}

}  // namespace plait
