#include "demos/study/tables.h"
#include "demos/tools/files.h"
#include "demos/tools/web_page.h"
#include "demos/tools/words.h"
#include "render/charts/chart.h"
#include "tune.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plait {
namespace {

std::string endingOf(const TuneStep& step) {
    return step.ending == "complete" ? step.metric : "ends early";
}

Table tableOf(const Tuning& tuning) {
    Table table{{"change", "work %", "moves most", "in tolerances", ""}};
    for (const TuneStep& step : tuning.steps)
        table.push_back({step.change, rounded("%.1f", 100 * step.work), endingOf(step),
                         rounded("%.2g", step.worst),
                         step.taken        ? "taken"
                         : step.worst <= 1 ? "could be"
                                           : "too far"});
    return table;
}

std::string wordsOf(const Tuning& tuning) {
    const auto change = [](double saved) {
        return (saved < 0 ? "adds " : "saves ") + rounded("%.0f", 100 * std::fabs(saved)) + " %";
    };
    const double work = 1 - static_cast<double>(tuning.chosen.evaluations()) /
                                static_cast<double>(tuning.own.evaluations());
    std::string words = "Converged: " + std::to_string(tuning.refined) +
                        " times the substeps, and half as many are no more than " +
                        text(100 * tuning.tolerance) + " % from it. The scene's own settings are " +
                        rounded("%.2g", tuning.ownWorst) + " tolerances from it.\n";
    for (const std::string& name : tuning.unsettled)
        words += "By no number of substeps " + name + " settles: it is held to its band.\n";
    if (tuning.options.empty()) return words + "They are the cheapest.\n";
    return words + "Chosen: " + tuning.options + ". That " + change(work) +
           " of the counted work and " + change(1 - tuning.chosen.seconds / tuning.own.seconds) +
           " of the time.\n";
}

// Every run by what it costs and how far it is: what is chosen lies furthest left below the line.
Figure figureOf(const Tuning& tuning) {
    constexpr double least = 1e-2, most = 1e2;  // changes beyond stand on the edge
    Curve taken{.name = "taken", .style = {0, Marker::disc, Dash::none}},
        others{.name = "tried", .style = {1, Marker::disc, Dash::none, true}};
    double right = 100;
    for (const TuneStep& step : tuning.steps) {
        const std::array<double, 2> at{100 * step.work, std::clamp(step.worst, least, most)};
        (step.taken ? taken : others).points.push_back({at[0], at[1]});
        right = std::max(right, at[0]);
    }
    Chart chart{.x = {.label = "counted work [% of the scene's own settings]"},
                .y = {.label = "from what is converged [tolerances]",
                      .logarithmic = true,
                      .low = least / 2,
                      .high = 2 * most}};
    if (!others.points.empty()) chart.curves.push_back(others);
    if (!taken.points.empty()) chart.curves.push_back(taken);
    chart.curves.push_back({.name = "own settings",
                            .points = {{100, std::clamp(tuning.ownWorst, least, most)}},
                            .style = curveStyle(2)});
    chart.curves.push_back(
        {.name = "tolerance", .points = {{0, 1}, {right, 1}}, .style = theoryStyle});
    return {.title = "The cheapest settings of " + valueOf(tuning.settings, "scene"),
            .charts = {chart},
            .width = 1280,
            .height = 800};
}

}  // namespace

std::string writeTuning(const Tuning& tuning, const std::filesystem::path& folder,
                        const std::string& command) {
    const std::string words = wordsOf(tuning),
                      title = "The cheapest settings of " + valueOf(tuning.settings, "scene");
    writeWhole(folder / "tune.csv", csvOf(tuning));
    writeFigure(folder / "chart", figureOf(tuning));
    writeWhole(folder / "index.html",
               webPage(title, "<h1>" + escaped(title) + "</h1><p>" + escaped(words) + "</p>" +
                                  pictureLine("chart", "What was tried") + htmlOf(tableOf(tuning)) +
                                  commandLines(command)));
    return textOf(tableOf(tuning)) + "\n" + words;
}

}  // namespace plait
