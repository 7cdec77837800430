#include "bench/scene.h"

#include "errors.h"
#include "interrupt.h"
#include "machine.h"
#include "run_job.h"
#include "run_options.h"
#include "simulation.h"

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
    const auto start = Clock::now();
    for (int i = 1; i <= run.frames(); ++i) {
        stopIfInterrupted();
        simulation->advance();
    }
    return since(start);
}

// Seconds until `frames` frames are film, from the very beginning.
double film(const Run& run, int frames, int threads) {
    const Scratch scratch;
    const auto start = Clock::now();
    Run part = run;
    part.scene.seconds = frames / run.frameRate();
    const RunFolder folder(scratch.path, settingsOf(part), {});
    RunJobOptions options{.threads = threads, .quiet = true, .pictures = {}, .exports = {}};
    options.pictures = requestedPictures({}, part);
    RunJob(part, folder, options).execute();
    return since(start);
}

void bench(const std::string& scene, const std::string& quality, int threads) {
    const Run run = makeRun({{"scene", scene}, {"quality", quality}});
    const double playing = run.frames() / run.frameRate();
    const double simulated = simulate(run, threads);
    const double first = film(run, 1, threads), all = film(run, run.frames(), threads);
    std::printf("%-9s %9d %10.2f %9.2f %9.2f %10.2f %10.2f %11.2f\n", quality.c_str(),
                run.scene.world.complex.count(0), playing, 1000 * simulated / run.frames(),
                playing / simulated, first, all, all / playing);
}

}  // namespace

int benchScene(const std::string& scene, int threads) {
    const Machine machine = thisMachine();
    std::printf("%s on %s, %d cores, %d threads, kernels %s with %d lanes\n\n", scene.c_str(),
                machine.processor.c_str(), machine.cores, threads, machine.kernels.c_str(),
                machine.lanes);
    std::printf("%-9s %9s %10s %9s %9s %10s %10s %11s\n", "", "vertices", "playing s", "ms/frame",
                "realtime", "first s", "film s", "film/play");
    for (const char* quality : {"draft", "preview"}) bench(scene, quality, threads);
    return exitOk;
}

}  // namespace plait
