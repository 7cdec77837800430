#include "trial.h"

#include "demos/runs/simulation.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/thread_time.h"
#include "demos/tools/words.h"

#include <plait/solver_options.h>

#include <algorithm>
#include <limits>
#include <random>

namespace plait {

Trial tryOut(const Run& run, const TrialLimit& limit) {
    Trial trial;
    const double start = threadTime();
    try {
        const auto simulation = makeSimulation(run, 1);
        settle(*simulation, run);
        trial.rows.push_back(rowOf(simulation->frame()));
        for (int f = 1; f <= run.frames() && trial.whole(); ++f) {
            stopIfInterrupted();
            simulation->advance();
            trial.rows.push_back(rowOf(simulation->frame()));
            if (static_cast<double>(trial.evaluations()) > limit.evaluations ||
                threadTime() - start > limit.seconds)
                trial.ending = "given up: it takes too long";
        }
    } catch (const Diverged& diverged) {
        trial.ending = diverged.what();
    } catch (const SceneError& error) {
        trial.ending = error.what();
    }
    trial.seconds = threadTime() - start;
    return trial;
}

Run nudged(Run run, unsigned seed) {
    constexpr double most = 1e-4;  // m/s
    World& world = run.scene.world;
    std::minstd_rand random(seed);
    const auto speed = [&] {
        return most * (2 * double(random() - std::minstd_rand::min()) /
                           double(std::minstd_rand::max() - std::minstd_rand::min()) -
                       1);
    };
    for (std::size_t v = 0; v < world.velocity.size(); ++v) {
        const Vec<double> nudge{speed(), speed(), speed()};
        if (!world.pinned[v]) world.velocity[v] += nudge;
    }
    return run;
}

std::string textOf(const Trial& trial, const std::string& key, const std::vector<Metric>& metrics) {
    return key + "\n" + trial.ending + "\n" + text(trial.seconds) + "\n" +
           csvOf(metrics, trial.rows);
}

bool readTrial(const std::filesystem::path& file, const std::string& key,
               const std::vector<Metric>& metrics, Trial& trial) {
    if (!std::filesystem::exists(file)) return false;
    const std::string all = readWhole(file);
    if (!all.starts_with(key + "\n")) return false;
    const std::size_t ending = key.size() + 1, seconds = all.find('\n', ending) + 1,
                      rows = all.find('\n', seconds) + 1;
    trial.ending = all.substr(ending, seconds - 1 - ending);
    trial.seconds = parseNumber(file, all.substr(seconds, rows - 1 - seconds), 0,
                                std::numeric_limits<double>::max());
    trial.rows = rowsFrom(all.substr(rows), metrics, file);
    return true;
}

Figures figuresOf(const Metric& metric, std::size_t column, const std::vector<MetricRow>& rows) {
    using Limits = std::numeric_limits<double>;
    Figures figures{0, Limits::max(), Limits::lowest()};
    int frames = 0;
    for (const MetricRow& row : rows) {
        if (row.time < metric.from) continue;
        const double value = row.values[column];
        figures.mean += value;
        figures.least = std::min(figures.least, value);
        figures.most = std::max(figures.most, value);
        ++frames;
    }
    if (frames == 0) return {0, 0, 0};
    figures.mean /= frames;
    return figures;
}

}  // namespace plait
