#include "contacts.h"

#include "demos/runs/settings.h"
#include "demos/runs/simulation.h"
#include "demos/study/median.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/machine.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace plait {
namespace {

using Clock = std::chrono::steady_clock;

struct Case {
    const char* name;
    Settings settings;
    int frames;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"flag, draft", {{"scene", "flag"}, {"quality", "draft"}}, 48},
        {"flag, preview", {{"scene", "flag"}, {"quality", "preview"}}, 24},
        {"dress, draft", {{"scene", "dress"}, {"quality", "draft"}}, 24},
        {"dress, preview", {{"scene", "dress"}, {"quality", "preview"}}, 8},
        {"sheet on a ball",
         {{"scene", "sheet-on-sphere"},
          {"quality", "final"},
          {"fps", "60"},
          {"substeps", "4"},
          {"iterations", "2"},
          {"knob.thickness", "0.0005"}},
         90}};
    return all;
}

struct Course {
    std::vector<double> milliseconds;
    long evaluations = 0;
    std::size_t vertices = 0;
};

Course courseOf(const Case& of, bool meets, int threads) {
    Settings settings = of.settings;
    if (!meets) settings.emplace_back("without", "contacts");
    const Run run = makeRun(settings);
    const auto simulation = makeSimulation(run, threads);
    settle(*simulation, run);
    Course course;
    for (int i = 0; i < of.frames; ++i) {
        stopIfInterrupted();
        const auto start = Clock::now();
        simulation->advance();
        course.milliseconds.push_back(1000 *
                                      std::chrono::duration<double>(Clock::now() - start).count());
    }
    const RunFrame last = simulation->frame();
    course.evaluations = last.evaluations;
    course.vertices = last.positions.size();
    return course;
}

}  // namespace

int benchContacts(int threads) {
    const Machine machine = thisMachine();
    std::printf("a frame with contacts and without; %s, %d cores, %d threads\n\n",
                machine.processor.c_str(), machine.cores, threads);
    std::printf("%-16s %8s %7s %9s %9s %9s %9s %11s\n", "", "vertices", "frames", "median", "worst",
                "without", "swept", "without");
    std::printf("%-16s %8s %7s %9s %9s %9s %9s %11s\n", "", "", "", "ms", "ms", "ms", "M a frame",
                "M a frame");
    for (const Case& of : cases()) {
        const Course with = courseOf(of, true, threads), without = courseOf(of, false, threads);
        const auto swept = [&](const Course& course) {
            return 1e-6 * static_cast<double>(course.evaluations) / of.frames;
        };
        std::printf("%-16s %8zu %7d %9.1f %9.1f %9.1f %9.2f %11.2f\n", of.name, with.vertices,
                    of.frames, median(with.milliseconds), std::ranges::max(with.milliseconds),
                    median(without.milliseconds), swept(with), swept(without));
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace plait
