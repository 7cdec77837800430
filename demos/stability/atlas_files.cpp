#include "atlas.h"

#include "demos/study/tables.h"
#include "demos/tools/files.h"
#include "demos/tools/web_page.h"
#include "demos/tools/words.h"

#include <cmath>

namespace plait {
namespace {

const CurveStyle foundStyle{0, Marker::disc, Dash::none};

std::string figure(double value) {
    char word[32];
    std::snprintf(word, sizeof word, "%.4g", value);
    return word;
}

std::string wordOf(const StabilityMap& map, const Boundary& boundary) {
    const bool low = map.goodAtLowY;
    if (!boundary.y) return "fails throughout";
    if (boundary.open) return low ? "none up to " + figure(*boundary.y) : "none";
    return figure(*boundary.y);
}

Table boundaryTable(const StabilityMap& map, std::span<const Boundary> boundaries) {
    Table table{{"method", map.x.label, "boundary: " + map.y.label, "theory"}};
    for (const Boundary& boundary : boundaries)
        for (const StabilityPanel& panel : map.panels)
            if (panel.name == boundary.panel)
                table.push_back({panel.name, figure(boundary.x), wordOf(map, boundary),
                                 panel.theory ? figure(panel.theory(boundary.x)) : "-"});
    return table;
}

std::string cellsCsv(const StabilityMap& map, const Atlas& atlas) {
    std::string lines = "panel,x,y,outcome\n";
    for (std::size_t p = 0; p < map.panels.size(); ++p)
        for (std::size_t i = 0; i < atlas.outcomes[p].size(); ++i)
            lines += map.panels[p].name + "," + text(atlas.x[i % atlas.x.size()]) + "," +
                     text(atlas.y[i / atlas.x.size()]) + "," +
                     map.outcomes[static_cast<std::size_t>(atlas.outcomes[p][i])] + "\n";
    return lines;
}

Curve theoryCurve(const StabilityMap& map, const StabilityPanel& panel) {
    Curve curve{.name = "theory", .style = theoryStyle};
    for (const double x : valuesOf(map.x, 25)) {
        const double on = panel.theory(x);
        // What lies far outside would be a line along the edge.
        if (on > map.y.low / 30 && on < map.y.high * 30) curve.points.push_back({x, on});
    }
    return curve;
}

Chart chartOf(const StabilityMap& map, const Atlas& atlas, std::size_t p) {
    const StabilityPanel& panel = map.panels[p];
    Chart chart{.title = panel.name,
                .x = {.label = map.x.label, .logarithmic = true},
                .y = {.label = map.y.label, .logarithmic = true},
                .map = HeatMap{atlas.x, atlas.y, atlas.outcomes[p], map.outcomes}};
    if (panel.theory) {
        const Curve theory = theoryCurve(map, panel);
        if (!theory.points.empty()) chart.curves.push_back(theory);
    }
    Curve found{.name = "boundary of " + map.outcomes[static_cast<std::size_t>(map.fails)],
                .style = foundStyle};
    for (const Boundary& boundary : atlas.boundaries)
        if (boundary.panel == panel.name && boundary.y && !boundary.open)
            found.points.push_back({boundary.x, *boundary.y});
    if (!found.points.empty()) chart.curves.push_back(found);
    return chart;
}

}  // namespace

Figure emptyFigure(const StabilityMap& map) {
    const int panels = static_cast<int>(map.panels.size());
    Figure figure{.title = map.title, .note = map.note};
    figure.columns = panels > 4 ? (panels + 1) / 2 : panels;
    const int rows = (panels + figure.columns - 1) / figure.columns;
    figure.width = panels == 1 ? 1000 : panels > 2 ? 340 + 320 * figure.columns : 1240;
    figure.height = 160 + (panels == 1 ? 560 : panels > 2 ? 360 : 460) * rows;
    return figure;
}

void writeAtlas(const StabilityMap& map, const Atlas& atlas, const std::filesystem::path& folder,
                const std::string& command) {
    Figure chart = emptyFigure(map);
    for (std::size_t p = 0; p < map.panels.size(); ++p)
        chart.charts.push_back(chartOf(map, atlas, p));
    writeWhole(folder / "cells.csv", cellsCsv(map, atlas));
    writeFigure(folder / "chart", chart);
    std::string body = pictureLine("chart", map.title) + "<p>" + escaped(map.words) + "</p>\n<p>" +
                       escaped(map.outcomeWords) + "</p>\n<p><a href=\"cells.csv\">cells.csv</a>";
    if (!map.boundaryAt.empty()) {
        writeWhole(folder / "boundaries.csv", csvOf(atlas.boundaries));
        body +=
            ", <a href=\"boundaries.csv\">boundaries.csv</a></p>\n<p>Boundaries are bisected "
            "between what is better and what is at least " +
            map.outcomes[static_cast<std::size_t>(map.fails)] +
            ".</p>\n<p>Theory: " + escaped(map.theoryWords) + ".</p>\n" +
            htmlOf(boundaryTable(map, atlas.boundaries));
    } else {
        body += "</p>\n";
    }
    writeWhole(folder / "index.html", webPage(map.title, body + commandLines(command)));
}

std::string boundaryText(const StabilityMap& map, std::span<const Boundary> boundaries) {
    return textOf(boundaryTable(map, boundaries));
}

}  // namespace plait
