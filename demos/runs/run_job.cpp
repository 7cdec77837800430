#include "run_job.h"

#include "demos/output/export.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"

#include <plait/solver_options.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace plait {

RunJob::RunJob(const Run& run, const RunJobOptions& options) : run_(run), options_(options) {
    timed("build", [&] { simulation_ = makeSimulation(run_, options_.threads); });
}

void RunJob::execute(RunFolder folder) {
    folder_ = std::make_unique<RunFolder>(std::move(folder));
    if (options_.pictures)
        timed("open", [&] { pictures_.emplace(run_, *folder_, *options_.pictures); });
    try {
        begin();
        simulate();
    } catch (const Interrupted&) {
        leave("interrupted");
        throw;
    } catch (const Diverged& error) {
        leave(std::string("diverged: ") + error.what());
        throw;
    }
    for (const std::string& format : options_.exports)
        timed("export", [&] { exportRun(*folder_, run_, run_.frames(), format); });
    leave("complete");
}

// The start, or every frame up to the checkpoint.
void RunJob::begin() {
    const int last = folder_->lastFrame();
    if (last < 0) {
        timed("settle", [&] { settle(*simulation_, run_, options_.quiet); });
        const RunFrame start = simulation_->frame();
        keep(start);
        return show(start);
    }
    const auto path = folder_->checkpointPath();
    simulation_->restore(readWhole(path), path.string());
    resumedAt_ = last;
    for (int i = 0; i <= last; ++i) {
        stopIfInterrupted();
        const RunFrame frame = folder_->frame(i);
        rows_.push_back(rowOf(frame));
        show(frame);
    }
}

void RunJob::simulate() {
    const int frames = run_.frames();
    Progress progress(run_.entry->name, pictures_ ? pictures_->done() : resumedAt_, frames,
                      options_.quiet);
    for (int i = resumedAt_ + 1; i <= frames; ++i) {
        stopIfInterrupted();
        timed("simulate", [&] { simulation_->advance(); });
        RunFrame frame;
        timed("measure", [&] { frame = simulation_->frame(); });
        timed("cache", [&] { keep(frame); });
        timed("wait for pictures", [&] { show(frame); });
        progress.show(pictures_ ? pictures_->done() : i);
    }
    if (pictures_) finishPictures(progress);
}

// The checkpoint is last: where it is, the frame is.
void RunJob::keep(const RunFrame& frame) {
    rows_.push_back(rowOf(frame));
    writeWhole(folder_->framePath(frame.number), encodeFrame(frame, numberSize(run_)));
    writeWhole(folder_->checkpointPath(), simulation_->checkpoint());
}

void RunJob::show(const RunFrame& frame) {
    if (pictures_) pictures_->add(frame);
}

void RunJob::finishPictures(Progress& progress) {
    timed("wait for pictures", [&] {
        while (!pictures_->finish(0.1)) {
            stopIfInterrupted();
            progress.show(std::min(pictures_->done(), run_.frames() - 1));
        }
    });
    progress.show(run_.frames());
}

Stages RunJob::stages() const {
    Stages all = stages_;
    if (pictures_) {
        const Stages drawing = pictures_->stages();
        all.insert(all.end(), drawing.begin(), drawing.end());
    }
    return all;
}

// What contacts did not hold, of scenes that measure it.
void RunJob::warnOfFailures() const {
    const auto& metrics = run_.scene.metrics;
    const auto metric = std::ranges::find(metrics, "failures", &Metric::name);
    if (metric == metrics.end()) return;
    const auto column = static_cast<std::size_t>(metric - metrics.begin());
    const auto failed = [&](const MetricRow& row) { return row.values[column] > 0; };
    if (const auto first = std::ranges::find_if(rows_, failed); first != rows_.end())
        std::fprintf(stderr, "plait: warning: contacts failed in %d frames, the first %d\n",
                     static_cast<int>(std::ranges::count_if(rows_, failed)), first->frame);
}

void RunJob::leave(const std::string& ending) {
    warnOfFailures();
    writeWhole(folder_->metricsPath(), csvOf(run_.scene.metrics, rows_));
    Record record{.run = run_,
                  .ending = ending,
                  .threads = simulation_->threads(),
                  .resumedAt = resumedAt_,
                  .rows = rows_,
                  .hash = simulation_->hash(),
                  .stateBytes = simulation_->stateBytes(),
                  .stages = stages(),
                  .pictures = options_.pictures,
                  .glLibrary = "",
                  .glRenderer = ""};
    if (pictures_) {
        record.glLibrary = pictures_->glLibrary();
        record.glRenderer = pictures_->glRenderer();
    }
    record.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    writeWhole(folder_->recordPath(), jsonOf(record));
}

void RunJob::timed(const std::string& stage, const std::function<void()>& body) {
    const auto begin = Clock::now();
    body();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    for (auto& [name, sum] : stages_)
        if (name == stage) {
            sum += seconds;
            return;
        }
    stages_.emplace_back(stage, seconds);
}

}  // namespace plait
