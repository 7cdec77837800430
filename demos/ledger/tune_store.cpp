// A tuning as a file, and whether it still says that its scene has the cheapest settings.
#include "demos/tools/words.h"
#include "tables.h"
#include "tune.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

std::string takeWord(Settings& settings, const std::string& name) {
    const auto at = std::ranges::find(settings, name, &Settings::value_type::first);
    if (at == settings.end()) return "";
    std::string value = at->second;
    settings.erase(at);
    return value;
}

}  // namespace

std::string csvOf(const Tuning& tuning) {
    Settings settings = tuning.settings;
    settings.emplace_back("tolerance", text(tuning.tolerance));
    settings.emplace_back("converged at substeps times", std::to_string(tuning.refined));
    settings.emplace_back("tolerances from it", text(tuning.ownWorst));
    settings.emplace_back("cheaper", tuning.options);
    std::string csv = settingsTable(settings) + "\n" +
                      metricsTable(tuning.metrics, tuning.tolerances) +
                      "\nchange,work,moves most,tolerances,taken,ending\n";
    for (const TuneStep& step : tuning.steps)
        csv += cellOf(step.change) + "," + rounded("%.6g", step.work) + "," + cellOf(step.metric) +
               "," + (std::isinf(step.worst) ? "inf" : rounded("%.6g", step.worst)) + "," +
               (step.taken ? "1" : "0") + "," + cellOf(step.ending) + "\n";
    return csv;
}

Tuning tuningFrom(const std::string& csv, const std::string& name) {
    TableReader reader(csv, name);
    Tuning tuning{readSettings(reader)};
    tuning.tolerance = takeNumber(reader, tuning.settings, "tolerance");
    tuning.refined = static_cast<int>(
        std::lround(takeNumber(reader, tuning.settings, "converged at substeps times")));
    tuning.ownWorst = takeNumber(reader, tuning.settings, "tolerances from it");
    tuning.options = takeWord(tuning.settings, "cheaper");
    readMetrics(reader, tuning.metrics, tuning.tolerances);
    reader.expect(reader.row().size() == 6);
    for (auto row = reader.row(); !row.empty(); row = reader.row()) {
        reader.expect(row.size() == 6);
        tuning.steps.push_back({.change = row[0],
                                .ending = row[5],
                                .work = reader.number(row[1]),
                                .worst = reader.number(row[3]),
                                .metric = row[2],
                                .taken = row[4] == "1"});
    }
    return tuning;
}

std::vector<std::string> differences(const Tuning& stored, const Run& run) {
    std::vector<std::string> lines = changesOf(stored.settings, settingsOf(run));
    for (const std::string& line : changesOf(stored.metrics, run.scene.metrics))
        lines.push_back(line);
    if (stored.ownWorst > 1)
        lines.push_back(rounded("%.2g", stored.ownWorst) + " tolerances from what is converged");
    if (!stored.options.empty()) lines.push_back("others are cheaper: " + stored.options);
    return lines;
}

}  // namespace plait
