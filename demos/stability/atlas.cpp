#include "stability/atlas.h"

#include "interrupt.h"
#include "progress.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace plait {
namespace {

// Every task once, on `jobs` threads; the first that throws ends all.
void runAll(const std::vector<std::function<void()>>& tasks, int jobs, Progress& progress) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr error;
    std::mutex mutex;
    int finished = 0;
    const auto work = [&] {
        try {
            for (std::size_t i; (i = next++) < tasks.size();) {
                stopIfInterrupted();
                tasks[i]();
                const std::lock_guard lock(mutex);
                progress.show(++finished);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!error) error = std::current_exception();
            next = tasks.size();
        }
    };
    std::vector<std::thread> threads;
    for (int job = 0; job < jobs; ++job) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (error) std::rethrow_exception(error);
}

}  // namespace

Atlas workOut(const StabilityMap& map, int cells, int jobs, bool quiet) {
    Atlas atlas{valuesOf(map.x, cells), valuesOf(map.y, cells), {}, {}};
    const std::size_t columns = atlas.x.size(), xs = map.boundaryAt.size();
    atlas.outcomes.assign(map.panels.size(), std::vector<int>(columns * atlas.y.size()));
    atlas.boundaries.resize(map.panels.size() * xs);
    std::vector<std::function<void()>> tasks;
    for (std::size_t p = 0; p < map.panels.size(); ++p) {
        const StabilityPanel& panel = map.panels[p];
        for (std::size_t i = 0; i < xs; ++i)
            tasks.emplace_back([&, p, i] {
                atlas.boundaries[p * xs + i] = traceBoundary(map, panel, map.boundaryAt[i]);
            });
        for (std::size_t i = 0; i < atlas.outcomes[p].size(); ++i)
            tasks.emplace_back([&, p, i] {
                atlas.outcomes[p][i] =
                    static_cast<int>(panel.cell(atlas.x[i % columns], atlas.y[i / columns]));
            });
    }
    Progress progress("stability " + map.name, 0, static_cast<int>(tasks.size()), quiet, "cells");
    runAll(tasks, jobs, progress);
    return atlas;
}

std::vector<Boundary> traceBoundaries(const StabilityMap& map,
                                      const std::vector<std::string>& panels, std::size_t most) {
    std::vector<Boundary> boundaries;
    for (const StabilityPanel& panel : map.panels) {
        if (!panels.empty() && std::find(panels.begin(), panels.end(), panel.name) == panels.end())
            continue;
        for (std::size_t i = 0; i < std::min(most, map.boundaryAt.size()); ++i)
            boundaries.push_back(traceBoundary(map, panel, map.boundaryAt[i]));
    }
    return boundaries;
}

}  // namespace plait
