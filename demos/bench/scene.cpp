#include "scene.h"

#include "demos/runs/run_job.h"
#include "demos/runs/run_options.h"
#include "demos/runs/simulation.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/machine.h"

#include <unistd.h>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace plait {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// A folder that goes with the program.
struct Scratch {
    Scratch()
        : path(std::filesystem::temp_directory_path() /
               ("plait-bench-" + std::to_string(getpid()))) {}
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    std::filesystem::path path;
};

// Seconds that the whole scene takes without pictures.
double simulate(const Run& run, int threads) {
    const auto simulation = makeSimulation(run, threads);
    settle(*simulation, run);
    const auto start = Clock::now();
    for (int i = 1; i <= run.frames(); ++i) {
        stopIfInterrupted();
        simulation->advance();
    }
    return since(start);
}

struct Film {
    double seconds;  // from the very beginning
    Stages stages;
};

Film film(const Run& run, int frames, int threads) {
    const Scratch scratch;
    const auto start = Clock::now();
    Run part = run;
    part.scene.seconds = frames / run.frameRate();
    RunJobOptions options{.threads = threads, .quiet = true, .pictures = {}, .exports = {}};
    options.pictures = requestedPictures({}, part);
    RunJob job(part, options);
    job.execute({scratch.path, settingsOf(part), {}});
    return {since(start), job.stages()};
}

void bench(const std::string& scene, const std::string& quality, int threads) {
    const Run run = makeRun({{"scene", scene}, {"quality", quality}});
    const PictureOptions pictures = requestedPictures({}, run);
    const int frames = run.frames();
    const double playing = frames / run.frameRate();
    const auto line = [](const std::string& name, double value, const char* unit) {
        std::printf("  %-24s %10.2f %s\n", name.c_str(), value, unit);
    };
    std::printf("\n%s: %d vertices, %d frames of %dx%d\n", quality.c_str(),
                run.scene.world.complex.count(0), frames, pictures.width, pictures.height);
    const double simulated = simulate(run, threads);
    line("simulate alone", 1000 * simulated / frames, "ms a frame");
    line("", playing / simulated, "times real time");
    const double first = film(run, 1, threads).seconds;
    const Film whole = film(run, frames, threads);
    for (const auto& [stage, seconds] : whole.stages) {
        const bool once = stage == "build" || stage.starts_with("open");
        line(stage, 1000 * seconds / (once ? 1 : frames), once ? "ms" : "ms a frame");
    }
    line("first frame", first, "s");
    line("film", whole.seconds, "s");
    line("", whole.seconds / playing, "times its playing time");
}

}  // namespace

int benchScene(const std::string& scene, int threads) {
    const Machine machine = thisMachine();
    std::printf("%s on %s, %d cores, %d threads, kernels %s with %d lanes\n", scene.c_str(),
                machine.processor.c_str(), machine.cores, threads, machine.kernels.c_str(),
                machine.lanes);
    for (const char* quality : {"draft", "preview"}) bench(scene, quality, threads);
    return exitOk;
}

}  // namespace plait
