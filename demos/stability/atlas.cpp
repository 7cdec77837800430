#include "atlas.h"

#include "demos/runs/run_all.h"
#include "demos/tools/files.h"
#include "demos/tools/progress.h"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <sstream>

namespace plait {

namespace {

// Outcomes of cells by their number, in a file that lives until all is done.
class DoneCells {
public:
    DoneCells(std::filesystem::path path, std::string of)
        : path_(std::move(path)), of_(std::move(of)) {
        if (!std::filesystem::exists(path_)) return;
        std::istringstream lines(readWhole(path_));
        std::string first;
        std::getline(lines, first);
        if (first != of_) return;
        char comma = 0;
        for (int cell = 0, outcome = 0; lines >> cell >> comma >> outcome;) done_[cell] = outcome;
    }

    const std::map<int, int>& all() const { return done_; }
    void add(int cell, int outcome) {
        const std::scoped_lock lock(mutex_);
        done_[cell] = outcome;
        std::string lines = of_ + "\n";
        for (const auto& [number, what] : done_)
            lines += std::to_string(number) + "," + std::to_string(what) + "\n";
        writeWhole(path_, lines);
    }
    void end() const { std::filesystem::remove(path_); }

private:
    std::filesystem::path path_;
    std::string of_;  // the first line
    std::map<int, int> done_;
    std::mutex mutex_;
};

}  // namespace

Atlas workOut(const StabilityMap& map, int cells, int jobs, bool quiet,
              const std::filesystem::path& done) {
    Atlas atlas{valuesOf(map.x, cells), valuesOf(map.y, cells), {}, {}};
    const std::size_t columns = atlas.x.size(), xs = map.boundaryAt.size();
    const std::size_t cellsOfPanel = columns * atlas.y.size();
    atlas.outcomes.assign(map.panels.size(), std::vector<int>(cellsOfPanel));
    atlas.boundaries.resize(map.panels.size() * xs);
    DoneCells finished(done, map.name + "," + std::to_string(cells));
    const std::map<int, int> before = finished.all();
    std::vector<std::function<void()>> tasks;
    for (std::size_t p = 0; p < map.panels.size(); ++p) {
        const StabilityPanel& panel = map.panels[p];
        for (std::size_t i = 0; i < xs; ++i)
            tasks.emplace_back([&, p, i] {
                atlas.boundaries[p * xs + i] = traceBoundary(map, panel, map.boundaryAt[i]);
            });
        for (std::size_t i = 0; i < cellsOfPanel; ++i) {
            const int number = static_cast<int>(p * cellsOfPanel + i);
            int& outcome = atlas.outcomes[p][i];
            if (const auto known = before.find(number); known != before.end()) {
                outcome = known->second;
                continue;
            }
            tasks.emplace_back([&, i, number] {
                outcome = static_cast<int>(panel.cell(atlas.x[i % columns], atlas.y[i / columns]));
                finished.add(number, outcome);
            });
        }
    }
    const int count = static_cast<int>(tasks.size());
    Progress progress("stability " + map.name, 0, count, quiet, "cells");
    runAll(count, jobs, 0, progress, [&](int i, int) { tasks[static_cast<std::size_t>(i)](); });
    finished.end();
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
