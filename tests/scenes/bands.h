// Scenes held to their bands.
#pragma once

#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/solver.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace plait::test {

// At draft quality, with these numbers for knobs.
inline Scene draftOf(const std::string& name, const std::map<std::string, double>& numbers = {}) {
    const SceneEntry& entry = findScene(name);
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    for (const auto& [knob, value] : numbers) knobs.numbers.at(knob) = value;
    return entry.build(knobs);
}

// All bands of a scene, in each of the frames. Returns where everything is then (m).
inline std::vector<Vec<double>> holdToBands(const Scene& scene, int frames) {
    Solver<float> solver(scene.world, scene.options);
    std::vector<double> most(scene.metrics.size(), -1e300);
    for (int frame = 1; frame <= frames; ++frame) {
        solver.frame();
        const std::vector<Vec<double>> x = solver.positions(), v = solver.velocities();
        const std::vector<double> ages = solver.ages();
        for (std::size_t i = 0; i < most.size(); ++i) {
            const Metric& metric = scene.metrics[i];
            const double value = metric.measure({x, v, solver.time(), frame, solver.failures(),
                                                 solver.state().id, ages, solver.state().cuts});
            most[i] = std::max(most[i], value);
            if (solver.time() < metric.from) continue;
            INFO(metric.name << " in frame " << frame);
            CHECK(value >= metric.low);
            CHECK(value <= metric.high);
        }
    }
    for (std::size_t i = 0; i < most.size(); ++i) note(scene.metrics[i].name + " at most", most[i]);
    return solver.positions();
}

}  // namespace plait::test
