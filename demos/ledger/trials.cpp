#include "trials.h"

#include "demos/runs/run_all.h"
#include "demos/tools/files.h"
#include "demos/tools/progress.h"

#include <plait/measure/hash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace plait {
namespace {

constexpr double patience = 4;  // work and time of a trial, in that of the whole scene

std::string hexOf(const std::string& bytes) {
    char word[32];
    std::snprintf(word, sizeof word, "%016llx",
                  static_cast<unsigned long long>(hashOf(bytes, hashSeed)));
    return word;
}

// Of this very program: what another build finds may differ.
const std::string& hashOfBuild() {
    static const std::string hash = hexOf(readWhole("/proc/self/exe"));
    return hash;
}

}  // namespace

Trials::Trials(std::string verb, const Run& run, const LedgerOptions& options,
               const std::filesystem::path& folder)
    : verb_(std::move(verb)), run_(run), options_(options), folder_(folder / "trials") {
    makeFolder(folder_);
}

std::vector<Trial> Trials::of(const std::vector<std::string>& words,
                              const std::function<Run(int)>& make, const TrialLimit& limit) const {
    std::vector<Trial> trials(words.size());
    std::vector<int> left;
    for (int i = 0; i < static_cast<int>(words.size()); ++i)
        if (!readTrial(fileOf(words[i]), keyOf(words[i]), run_.scene.metrics, trials[i]))
            left.push_back(i);
    const int total = static_cast<int>(words.size()), count = static_cast<int>(left.size());
    Progress progress(verb_ + " " + run_.entry->name, total - count, total, options_.quiet, "runs");
    runAll(count, options_.jobs, total - count, progress, [&](int k, int) {
        const int i = left[k];
        trials[i] = tryOut(make(i), limit);
        writeWhole(fileOf(words[i]), textOf(trials[i], keyOf(words[i]), run_.scene.metrics));
    });
    return trials;
}

std::string Trials::nameOf(const std::string& word) const {
    std::string name = textOf(settingsOf(run_)) + word;
    std::replace(name.begin(), name.end(), '\n', ' ');
    return name;
}

std::string Trials::keyOf(const std::string& word) const {
    return nameOf(word) + " build=" + hashOfBuild();
}

std::filesystem::path Trials::fileOf(const std::string& word) const {
    return folder_ / (hexOf(nameOf(word)) + ".csv");
}

TrialLimit limitOf(const Trial& base) {
    return {patience * static_cast<double>(base.evaluations()),
            std::max(1.0, patience * base.seconds)};
}

MetricTolerance toleranceOf(const Metric& metric, std::size_t column, const Trial& base,
                            const std::vector<Trial>& twins, double tolerance) {
    MetricTolerance result{};
    result.base = figuresOf(metric, column, base.rows);
    const double width = metric.high - metric.low;
    const double scale = std::isfinite(width) ? width
                                              : std::max(result.base.most - result.base.least,
                                                         std::fabs(result.base.mean));
    for (const auto figure : allFigures) {
        double low = std::numeric_limits<double>::max(), high = -low;
        for (const Trial& twin : twins) {
            const double value = figuresOf(metric, column, twin.rows).*figure;
            low = std::min(low, value), high = std::max(high, value);
        }
        const double chance = twins.empty() ? 0 : high - low;
        result.allowed.*figure = std::max(tolerance * scale, 2 * chance);
    }
    return result;
}

double MetricTolerance::changeOf(const Figures& figures) const {
    double change = 0;
    for (const auto figure : allFigures) {
        const double by = std::fabs(figures.*figure - base.*figure), most = allowed.*figure;
        if (by == 0) continue;
        change = std::max(change, std::isfinite(by) && most > 0
                                      ? by / most
                                      : std::numeric_limits<double>::infinity());
    }
    return change;
}

std::string rounded(const char* format, double value) {
    if (std::isinf(value)) return "beyond all";
    char word[32];
    std::snprintf(word, sizeof word, format, value);
    return word;
}

}  // namespace plait
