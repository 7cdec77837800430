// What curves of studies are put together from.
#include "definitions.h"
#include "demos/study/solve.h"
#include "demos/tools/errors.h"

namespace plait {

std::vector<int> doubling(int first, int last) {
    std::vector<int> counts;
    for (int n = first; n <= last; n *= 2) counts.push_back(n);
    return counts;
}

Settings with(Settings settings, const std::string& name, const std::string& value) {
    settings.emplace_back(name, value);
    return settings;
}

StudyCurve curve(const std::string& name, const Settings& settings,
                 const std::vector<int>& substeps, int iterations) {
    StudyCurve curve{name, {}};
    for (const int n : substeps)
        curve.tasks.push_back(with(with(settings, "substeps", std::to_string(n)), "iterations",
                                   std::to_string(iterations)));
    return curve;
}

StudyCurve sharedOut(const std::string& name, const Settings& settings, int substeps,
                     const std::vector<int>& work) {
    StudyCurve curve{name, {}};
    for (const int n : work) {
        const int steps = substeps == 0 ? n : substeps;
        if (n % steps != 0) continue;
        curve.tasks.push_back(with(with(settings, "substeps", std::to_string(steps)), "iterations",
                                   std::to_string(n / steps)));
    }
    return curve;
}

const Settings firstOrder{{"integrator", "first"}, {"precision", "double"}};
const Settings secondOrder{{"integrator", "bdf2"}, {"precision", "double"}};
const Settings firstOrderFloat{{"integrator", "first"}, {"precision", "float"}};
const Settings secondOrderFloat{{"integrator", "bdf2"}, {"precision", "float"}};

Settings by(const std::string& method, const std::string& integrator) {
    return {{"method", method}, {"integrator", integrator}, {"precision", "double"}};
}

Trajectory fine(const Study& study, Settings settings, int substeps) {
    settings.emplace_back("substeps", std::to_string(substeps));
    const Run run = studyRun(study, settings);
    const Recording recording = solve(study, run, false);
    if (recording.ending != "complete") throw SceneError("the reference: " + recording.ending);
    return recording.positions;
}

}  // namespace plait
