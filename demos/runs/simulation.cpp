#include "simulation.h"

#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"

#include <plait/solver.h>

#include <chrono>
#include <cstdio>

namespace plait {
namespace {

template <class Real>
class SimulationIn : public Simulation {
public:
    SimulationIn(const Run& run, const SolverOptions& options)
        : run_(run), solver_(run.scene.world, options) {
        const FrameRate rate = options.schedule.frameRate;
        while (lead_ * rate.seconds < run.scene.lead * rate.frames) ++lead_;
    }

    int lead() const override { return lead_; }
    void settle() override { solver_.frame(); }

    void advance() override {
        const auto start = std::chrono::steady_clock::now();
        solver_.frame();
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ++number_;
    }

    RunFrame frame() const override {
        RunFrame frame{.number = number_,
                       .time = solver_.time() - run_.scene.lead,
                       .evaluations = solver_.evaluations(),
                       .seconds = seconds_,
                       .metrics = {},
                       .positions = solver_.positions(),
                       .velocities = solver_.velocities(),
                       .touched = touched(),
                       .ids = solver_.state().id,
                       .ages = solver_.ages(),
                       .cuts = solver_.state().cuts};
        const Snapshot snapshot{frame.positions,    frame.velocities, frame.time, frame.number,
                                solver_.failures(), frame.ids,        frame.ages, frame.cuts};
        for (const Metric& metric : run_.scene.metrics)
            frame.metrics.push_back(metric.measure(snapshot));
        for (auto* vectors : {&frame.positions, &frame.velocities})
            for (Vec<double>& v : *vectors)
                v = {double(Real(v.x)), double(Real(v.y)), double(Real(v.z))};
        return frame;
    }

    std::uint64_t hash() const override { return solver_.hash(); }
    std::size_t stateBytes() const override { return solver_.bytes(); }
    int threads() const override { return solver_.threads(); }

    std::string checkpoint() const override {
        return encodeCheckpoint<Real>({number_, solver_.evaluations(), solver_.state()});
    }

    void restore(const std::string& bytes, const std::string& name) override {
        const auto checkpoint = decodeCheckpoint<Real>(bytes, name);
        try {
            solver_.restore(checkpoint.state, checkpoint.evaluations);
        } catch (const std::invalid_argument& error) {
            throw FileError(name + ": " + error.what());
        }
        number_ = checkpoint.frame;
    }

private:
    std::vector<std::uint8_t> touched() const {
        std::vector<std::uint8_t> touched(solver_.state().particles.size());
        for (std::size_t i = 0; i < run_.scene.world.sets.size(); ++i)
            solver_.set(static_cast<int>(i)).markTouched(touched);
        touched.pop_back();  // of the vertex that pads
        return touched;
    }

    const Run& run_;
    Solver<Real> solver_;
    int lead_ = 0;  // frames before the first
    int number_ = 0;
    double seconds_ = 0;  // of the last frame
};

}  // namespace

std::unique_ptr<Simulation> makeSimulation(const Run& run, int threads) {
    SolverOptions options = run.scene.options;
    options.threads = threads;
    options.interrupt = stopIfInterrupted;
    const EndsAtOnce building;
    try {
        std::unique_ptr<Simulation> simulation;
        if (run.precision == Precision::single)
            simulation = std::make_unique<SimulationIn<float>>(run, options);
        else
            simulation = std::make_unique<SimulationIn<double>>(run, options);
        if (simulation->threads() < threads)
            std::fprintf(stderr, "plait: warning: %d of %d threads: the system starts no more\n",
                         simulation->threads(), threads);
        return simulation;
    } catch (const std::invalid_argument& error) {
        throw SceneError(run.entry->name + " cannot be built: " + error.what());
    }
}

void settle(Simulation& simulation, const Run& run, bool quiet) {
    const int frames = simulation.lead();
    if (frames == 0) return;
    Progress progress(run.entry->name + " settles", 0, frames, quiet);
    for (int i = 1; i <= frames; ++i) {
        stopIfInterrupted();
        simulation.settle();
        progress.show(i);
    }
}

int numberSize(const Run& run) {
    return run.precision == Precision::single ? sizeof(float) : sizeof(double);
}

}  // namespace plait
