#include "demos/study/tables.h"
#include "demos/tools/files.h"
#include "demos/tools/web_page.h"
#include "demos/tools/words.h"
#include "ledger.h"
#include "render/charts/chart.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

std::vector<std::string> lineOf(const Ledger& ledger, const LedgerRow& row) {
    const bool moved = !row.changes.empty() && row.changes[row.mostMoved()] > 0;
    const std::string most = row.ending != "complete" ? "ends early"
                             : moved                  ? ledger.metrics[row.mostMoved()].name
                                                      : "none";
    return {row.part,
            row.change,
            rounded("%.1f", 100 * row.work),
            rounded("%.0f", 100 * row.time),
            most,
            moved ? rounded("%.2g", row.changes[row.mostMoved()]) : "0",
            wordOf(row.need)};
}

Table tableOf(const Ledger& ledger) {
    Table table{{"ingredient", "change", "work saved %", "time saved %", "moves most",
                 "in tolerances", "verdict"}};
    for (const LedgerRow& row : ledger.rows) table.push_back(lineOf(ledger, row));
    return table;
}

Table metricTable(const Ledger& ledger) {
    Table table{{"metric", "mean", "least", "most", "its mean may change by", "moved by"}};
    for (std::size_t m = 0; m < ledger.metrics.size(); ++m) {
        const MetricTolerance& t = ledger.tolerances[m];
        const auto moves = std::ranges::count_if(
            ledger.rows, [&](const LedgerRow& row) { return row.changes[m] > 1; });
        const bool guards = ledger.metrics[m].low == ledger.metrics[m].high;
        table.push_back(
            {ledger.metrics[m].name, rounded("%.3g", t.base.mean), rounded("%.3g", t.base.least),
             rounded("%.3g", t.base.most), rounded("%.2g", t.allowed.mean),
             moves == 0 && guards ? "none: a guard" : std::to_string(moves) + " ingredients"});
    }
    return table;
}

// Every ingredient by what leaving it out saves and moves: what lies below the line, the scene does
// not need.
Figure figureOf(const Ledger& ledger) {
    constexpr double least = 1e-3, most = 1e3;  // changes beyond stand on the edge
    Chart chart{.x = {.label = "counted work saved [%]"},
                .y = {.label = "change of the metric moved most [tolerances]",
                      .logarithmic = true,
                      .low = least / 2,
                      .high = 2 * most}};
    double right = 10;
    int style = 0;
    for (const LedgerRow& row : ledger.rows) {
        const double change = row.changes.empty() ? 0 : row.changes[row.mostMoved()];
        const double x = std::max(-100.0, 100 * row.work);
        right = std::max(right, x);
        chart.curves.push_back({.name = row.part + ": " + row.change,
                                .points = {{x, std::clamp(change, least, most)}},
                                .style = curveStyle(style++)});
    }
    chart.curves.push_back(
        {.name = "tolerance", .points = {{0, 1}, {right, 1}}, .style = theoryStyle});
    return {.title = "What " + ledger.scene() + " needs",
            .charts = {chart},
            .width = 1280,
            .height = 800};
}

std::string summary(const Ledger& ledger) {
    std::string text;
    if (ledger.together.change == "nothing")
        text = "Nothing can be left out without moving a metric.\n";
    else
        text = "Together these can be left out: " + ledger.together.change + ". That saves " +
               rounded("%.1f", 100 * ledger.together.work) + " % of the counted work and " +
               rounded("%.0f", 100 * ledger.together.time) + " % of the time.\n";
    for (const std::string& line : ledger.complaints()) text += line + "\n";
    return text;
}

}  // namespace

std::string writeLedger(const Ledger& ledger, const std::filesystem::path& folder,
                        const std::string& command) {
    writeWhole(folder / "ledger.csv", csvOf(ledger));
    writeFigure(folder / "chart", figureOf(ledger));
    const std::string what =
        "<p>Each ingredient was left out, or put to its next cheaper form, by itself. A change is "
        "that of the mean, the least or the most of a metric, whichever is largest, in "
        "tolerances: " +
        text(100 * ledger.tolerance) +
        " % of the width of its band, and never less than twice what a nudge of 0.1 mm/s at the "
        "start changes.</p>";
    std::string words = summary(ledger);
    std::string html = "<h1>" + escaped("What " + ledger.scene() + " needs") + "</h1>" + what +
                       pictureLine("chart", "What each ingredient saves and what it moves") +
                       htmlOf(tableOf(ledger)) + "<h2>Metrics</h2>" + htmlOf(metricTable(ledger)) +
                       "<p>" + escaped(words) + "</p>" + commandLines(command);
    writeWhole(folder / "index.html", webPage("What " + ledger.scene() + " needs", html));
    return textOf(tableOf(ledger)) + "\n" + textOf(metricTable(ledger)) + "\n" + words;
}

}  // namespace plait
