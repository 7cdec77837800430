#include "study.h"

#include "solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

namespace plait {

Run studyRun(const Study& study, const Settings& settings) {
    // What comes later wins: a task may overrule its model, a quality or a precision.
    Settings all;
    for (const auto& [name, value] : settings) all.emplace_back(name, value);
    for (const auto& [name, value] : study.model)
        if (std::none_of(settings.begin(), settings.end(),
                         [&](const auto& s) { return s.first == name; }))
            all.emplace_back(name, value);
    return makeRun(all);
}

Settings studySettings(const Study& study, const Settings& settings) {
    static std::mutex one;
    static std::map<std::string, Settings> kept;
    const std::lock_guard lock(one);
    const std::string key = textOf(study.model) + "\n" + textOf(settings);
    if (const auto found = kept.find(key); found != kept.end()) return found->second;
    const Run run = studyRun(study, settings);
    Settings all = settingsOf(run);
    const bool ofFiles = std::ranges::any_of(
        run.contents, [](const auto& content) { return !content.second.empty(); });
    if (!ofFiles) kept[key] = all;
    return all;
}

std::vector<ErrorKind> usualErrors(bool conserved, bool hard) {
    std::vector<ErrorKind> kinds{{"position", "rms position error over all frames / size"},
                                 {"end", "rms position error of the last frame / size"}};
    if (conserved) kinds.push_back({"energy", "greatest drift of energy / m g size"});
    if (hard) {
        kinds.push_back({"violation", "greatest violation of a constraint / rest length"});
        kinds.push_back({"violation-rms", "rms violation of constraints / rest length"});
    }
    return kinds;
}

std::vector<double> measureUsual(const Study& study, const Run& run, const Recording& recording,
                                 const Reference& reference) {
    constexpr double worthless = std::numeric_limits<double>::infinity();
    if (recording.ending != "complete" || reference.frames == 0)
        return std::vector<double>(study.errors.size(), worthless);
    const int frames = reference.frames, moving = movingVertices(run.scene.world);
    const Trajectory& x = recording.positions;
    std::vector<double> errors{
        rmsDistance(x, reference.trajectory, frames, moving) / study.size,
        rmsDistanceAt(x, reference.trajectory, frames - 1, moving) / study.size};
    const auto last = [&](const std::vector<double>& values) { return values.begin() + frames; };
    for (std::size_t k = 2; k < study.errors.size(); ++k) {
        const std::string& key = study.errors[k].key;
        double most = 0, squares = 0;
        for (auto e = recording.energy.begin(); key == "energy" && e != last(recording.energy); ++e)
            most = std::max(most, std::fabs(*e - recording.startEnergy) / study.energyScale);
        if (key == "violation")
            most = *std::max_element(recording.violation.begin(), last(recording.violation));
        for (auto v = recording.violationRms.begin();
             key == "violation-rms" && v != last(recording.violationRms); ++v)
            squares += *v * *v / frames;
        errors.push_back(key == "violation-rms" ? std::sqrt(squares) : most);
    }
    return errors;
}

std::vector<ErrorKind> strainErrors() {
    return {{"worst", "greatest extension of a link in any frame / rest length"},
            {"late", "greatest extension, mean over the second half / rest length"},
            {"end", "greatest extension at the end / rest length"},
            {"mean", "mean strain at the end / rest length"}};
}

std::vector<double> measureStrain(const Study& study, const Run&, const Recording& recording,
                                  const Reference&) {
    if (recording.ending != "complete")
        return std::vector<double>(study.errors.size(), std::numeric_limits<double>::infinity());
    double worst = 0, late = 0;
    const std::size_t n = recording.metrics.size(), half = n / 2;
    for (std::size_t f = 0; f < n; ++f) {
        const double extension = recording.metrics[f][0] / 100;  // the scene's first metric, in %
        worst = std::max(worst, extension);
        if (f >= half) late += extension / static_cast<double>(n - half);
    }
    return {worst, late, recording.metrics.back()[0] / 100, recording.violationMean.back()};
}

}  // namespace plait
