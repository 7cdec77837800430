#include "drape.h"

#include "demos/runs/settings.h"
#include "demos/runs/simulation.h"
#include "demos/study/median.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/machine.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace plait {
namespace {

using Clock = std::chrono::steady_clock;

struct Case {
    int vertices;  // along a side
    const char* quality;
    int substeps, iterations;  // a frame
    const char* thickness;     // m, to either side
    const char* ball;
};

constexpr Case cases[]{
    {64, "preview", 4, 2, "0.001", "solid"}, {128, "final", 4, 2, "0.0005", "solid"},
    {128, "final", 8, 2, "0.0005", "solid"}, {128, "final", 4, 2, "0.001", "solid"},
    {128, "final", 4, 2, "0.0005", "mesh"},  {128, "final", 8, 2, "0.0005", "mesh"}};

// Frame by frame; those of the metrics of the scene.
struct Course {
    std::vector<double> milliseconds, strain, common, crossings;
    double failures = 0, lowest = 0;
    long evaluations = 0;
};

Course courseOf(const Case& of, int threads) {
    const Run run = makeRun({{"scene", "sheet-on-sphere"},
                             {"quality", of.quality},
                             {"fps", "60"},
                             {"seconds", "2"},
                             {"substeps", std::to_string(of.substeps)},
                             {"iterations", std::to_string(of.iterations)},
                             {"knob.ball", of.ball},
                             {"knob.thickness", of.thickness}});
    const auto simulation = makeSimulation(run, threads);
    const auto column = [&](const char* name) {
        const auto at = std::ranges::find(run.scene.metrics, name, &Metric::name);
        return static_cast<std::size_t>(at - run.scene.metrics.begin());
    };
    const std::size_t strain = column("strain"), common = column("strain99"),
                      crossings = column("crossings"), failures = column("failures");
    Course course;
    for (int i = 0; i < run.frames(); ++i) {
        stopIfInterrupted();
        const auto start = Clock::now();
        simulation->advance();
        course.milliseconds.push_back(1000 *
                                      std::chrono::duration<double>(Clock::now() - start).count());
        const RunFrame frame = simulation->frame();
        course.strain.push_back(frame.metrics[strain]);
        course.common.push_back(frame.metrics[common]);
        course.crossings.push_back(frame.metrics[crossings]);
        course.failures += frame.metrics[failures];
        course.evaluations = frame.evaluations;
        course.lowest = 0;
        for (const auto& x : frame.positions) course.lowest = std::min(course.lowest, x.y);
    }
    return course;
}

double sum(const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.0); }

double most(const std::vector<double>& of) { return *std::ranges::max_element(of); }

}  // namespace

int benchDrape(int threads) {
    const Machine machine = thisMachine();
    std::printf("sheet of 1 m on a ball, 2 s, 1/60 s a frame; %s, %d cores, %d threads\n",
                machine.processor.c_str(), machine.cores, threads);
    std::printf("%5s %5s %9s %9s %8s %8s %8s %8s %9s %8s %7s %6s %6s %8s\n", "side", "ball",
                "thickness", "substeps", "work", "ms", "mean", "worst", "crossings", "failures",
                "strain", "99 %", "at end", "lowest");
    std::printf("%5s %5s %9s %9s %8s %8s %8s %8s %9s %8s %7s %6s %6s %8s\n", "", "", "m", "a frame",
                "a frame", "a frame", "", "", "", "", "%", "%", "%", "m");
    bool crossed = false;
    for (const Case& of : cases) {
        const Course course = courseOf(of, threads);
        const auto frames = static_cast<double>(course.milliseconds.size());
        std::printf(
            "%5d %5s %9s %5d x %d %6.2f M %8.1f %8.1f %8.1f %9.0f %8.0f %7.2f %6.2f %6.2f %8.3f\n",
            of.vertices, of.ball, of.thickness, of.substeps, of.iterations,
            1e-6 * static_cast<double>(course.evaluations) / frames, median(course.milliseconds),
            sum(course.milliseconds) / frames, most(course.milliseconds), sum(course.crossings),
            course.failures, most(course.strain), most(course.common), course.common.back(),
            course.lowest);
        std::fflush(stdout);
        crossed |= sum(course.crossings) > 0;
    }
    return crossed ? exitFailed : exitOk;
}

}  // namespace plait
