#include "tables.h"

#include "median.h"
#include "render/charts/chart.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

std::string figure(double value) {
    if (value == infinity) return "-";
    char word[32];
    std::snprintf(word, sizeof word, "%.2g", value);
    return word;
}

struct Span {
    double low = infinity, high = 0;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

}  // namespace

Table equalCost(const Study& study, const std::vector<StudyPoint>& points, double seconds) {
    Span cost;
    for (const StudyCurve& curve : study.curves)
        for (const StudyPoint* point : along(points, curve.name))
            cost.add(frameCost(*point, seconds));
    Table table{{"least error within"}};
    std::vector<double> budgets;
    if (cost.high > 0)
        for (double budget = std::pow(4, std::ceil(std::log2(cost.low) / 2));
             budget < 4 * cost.high; budget *= 4)
            budgets.push_back(budget);
    for (const double budget : budgets) table[0].push_back(figure(budget) + " ms/frame");
    for (const StudyCurve& curve : study.curves) {
        table.push_back({curve.name});
        for (const double budget : budgets) {
            double least = infinity;
            for (const StudyPoint* point : along(points, curve.name))
                if (frameCost(*point, seconds) <= budget) least = std::min(least, point->errors[0]);
            table.back().push_back(figure(least));
        }
    }
    return table;
}

Table equalError(const Study& study, const std::vector<StudyPoint>& points, double seconds) {
    Span error;
    for (const StudyCurve& curve : study.curves)
        for (const StudyPoint* point : along(points, curve.name)) error.add(point->errors[0]);
    Table table{{"ms/frame, constraints/s to reach"}};
    std::vector<double> levels;
    for (double level = 0.1; level >= error.low && levels.size() < 8; level /= 10)
        levels.push_back(level);
    for (const double level : levels) table[0].push_back(figure(level));
    for (const StudyCurve& curve : study.curves) {
        table.push_back({curve.name});
        for (const double level : levels) {
            double time = infinity, work = infinity;
            for (const StudyPoint* point : along(points, curve.name)) {
                if (point->errors[0] > level) continue;
                time = std::min(time, frameCost(*point, seconds));
                work = std::min(work, point->evaluations / seconds);
            }
            table.back().push_back(time == infinity ? "-" : figure(time) + ", " + figure(work));
        }
    }
    return table;
}

double busyness(const std::vector<StudyPoint>& points) {
    std::vector<double> ratios;
    for (const StudyPoint& point : points)
        if (point.cpu > 0) ratios.push_back(point.seconds / point.cpu);
    return ratios.empty() ? 1 : median(ratios);
}

std::string textOf(const Table& table) {
    std::vector<std::size_t> width;
    for (const auto& row : table)
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c == width.size()) width.push_back(0);
            width[c] = std::max(width[c], row[c].size());
        }
    std::string lines;
    for (const auto& row : table) {
        for (std::size_t c = 0; c < row.size(); ++c)
            lines += c == 0 ? row[c] + std::string(width[c] - row[c].size(), ' ')
                            : std::string(width[c] - row[c].size() + 2, ' ') + row[c];
        lines += "\n";
    }
    return lines;
}

std::string htmlOf(const Table& table) {
    std::string html = "<table>\n";
    for (std::size_t r = 0; r < table.size(); ++r) {
        const std::string cell = r == 0 ? "th" : "td";
        html += "<tr>";
        for (const std::string& word : table[r])
            html += "<" + cell + ">" + escaped(word) + "</" + cell + ">";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

}  // namespace plait
