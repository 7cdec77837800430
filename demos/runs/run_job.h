// One run, from its first frame or where it was stopped, to everything that it leaves.
#pragma once

#include "demos/output/metric_table.h"
#include "demos/output/pictures.h"
#include "demos/output/record.h"
#include "run_folder.h"
#include "simulation.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plait {

struct RunJobOptions {
    int threads = 1;
    bool quiet = false;
    std::optional<PictureOptions> pictures;
    std::vector<std::string> exports;
};

class RunJob {
public:
    // Throws SceneError for a run that its method cannot take on: before there is a folder. `run`
    // must live as long.
    RunJob(const Run& run, const RunJobOptions& options);

    // Once. Throws what errors.h says, Diverged as well; what it leaves then is whole, and goes on
    // with another job of the same folder once this one is gone: its threads may still write there.
    void execute(RunFolder folder);
    // What the stages took so far, those of the pictures too.
    Stages stages() const;

private:
    using Clock = std::chrono::steady_clock;

    void begin();
    void simulate();
    void keep(const RunFrame& frame);
    void show(const RunFrame& frame);
    void finishPictures(class Progress& progress);
    void leave(const std::string& ending);
    void warnOfFailures() const;
    void timed(const std::string& stage, const std::function<void()>& body);

    const Run& run_;
    std::unique_ptr<const RunFolder> folder_;  // outlives the pictures
    RunJobOptions options_;
    Clock::time_point start_ = Clock::now();
    std::unique_ptr<Simulation> simulation_;
    std::optional<Pictures> pictures_;
    std::vector<MetricRow> rows_;
    int resumedAt_ = 0;
    Stages stages_;
};

}  // namespace plait
