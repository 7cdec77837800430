#include "metric_table.h"

#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace plait {
namespace {

std::string headerOf(const std::vector<Metric>& metrics) {
    std::string header = "frame,time[s],evaluations";
    for (const Metric& metric : metrics)
        header += "," + metric.name + (metric.unit.empty() ? "" : "[" + metric.unit + "]");
    return header;
}

std::vector<double> numbersOf(const std::string& line, const std::string& name) {
    std::vector<double> numbers;
    const char *at = line.data(), *const end = at + line.size();
    while (true) {
        double value;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc{} || (next != end && *next != ','))
            throw FileError(name + ": not a row of numbers: " + line);
        numbers.push_back(value);
        if (next == end) return numbers;
        at = next + 1;
    }
}

std::string rounded(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.5g", value);
    return buffer;
}

}  // namespace

MetricRow rowOf(const RunFrame& frame) {
    return {frame.number, frame.time, frame.evaluations, frame.metrics};
}

std::string csvOf(const std::vector<Metric>& metrics, const std::vector<MetricRow>& rows) {
    std::string csv = headerOf(metrics) + "\n";
    for (const MetricRow& row : rows) {
        csv += std::to_string(row.frame) + "," + text(row.time) + "," +
               std::to_string(row.evaluations);
        for (const double value : row.values) csv += "," + text(value);
        csv += "\n";
    }
    return csv;
}

std::vector<MetricRow> rowsFrom(const std::string& csv, const std::vector<Metric>& metrics,
                                const std::string& name) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    if (line != headerOf(metrics))
        throw FileError(name + ": its columns are not those of the scene: " + line);
    std::vector<MetricRow> rows;
    while (std::getline(lines, line)) {
        const std::vector<double> n = numbersOf(line, name);
        if (n.size() != metrics.size() + 3) throw FileError(name + ": a row of another length");
        rows.push_back(
            {static_cast<int>(n[0]), n[1], static_cast<long>(n[2]), {n.begin() + 3, n.end()}});
    }
    return rows;
}

Verdict verdictOn(const Metric& metric, std::size_t column, const std::vector<MetricRow>& rows) {
    Verdict verdict{infinity, -infinity, 0, -1};
    for (const MetricRow& row : rows) {
        if (row.time < metric.from) continue;
        const double value = row.values[column];
        ++verdict.frames;
        verdict.least = std::min(verdict.least, value);
        verdict.most = std::max(verdict.most, value);
        const bool inside = value >= metric.low && value <= metric.high;  // NaN is not
        if (!inside && verdict.firstOutside < 0) verdict.firstOutside = row.frame;
    }
    return verdict;
}

std::string bandOf(const Metric& metric) {
    if (std::isinf(metric.low) && std::isinf(metric.high)) return "";
    return "[" + (std::isinf(metric.low) ? "" : rounded(metric.low)) + ", " +
           (std::isinf(metric.high) ? "" : rounded(metric.high)) + "]" +
           (metric.from > 0 ? " from " + rounded(metric.from) + " s" : "");
}

std::string verdictTable(const std::vector<Metric>& metrics, const std::vector<MetricRow>& rows) {
    std::string table;
    const auto line = [&](const std::string& name, const std::string& unit,
                          const std::string& least, const std::string& most,
                          const std::string& band, const std::string& ok) {
        char text[256];
        std::snprintf(text, sizeof text, "%-24s %-8s %12s %12s  %-24s %s\n", name.c_str(),
                      unit.c_str(), least.c_str(), most.c_str(), band.c_str(), ok.c_str());
        table += text;
    };
    line("metric", "unit", "least", "most", "band", "ok");
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const Metric& metric = metrics[i];
        const Verdict verdict = verdictOn(metric, i, rows);
        const std::string band = bandOf(metric);
        std::string ok = band.empty() ? "" : "ok";
        if (verdict.frames == 0) ok = "not reached";
        if (verdict.firstOutside >= 0)
            ok = "OUTSIDE from frame " + std::to_string(verdict.firstOutside);
        line(metric.name, metric.unit, verdict.frames ? rounded(verdict.least) : "",
             verdict.frames ? rounded(verdict.most) : "", band, ok);
    }
    return table;
}

bool allWithinBands(const std::vector<Metric>& metrics, const std::vector<MetricRow>& rows) {
    for (std::size_t i = 0; i < metrics.size(); ++i)
        if (verdictOn(metrics[i], i, rows).firstOutside >= 0) return false;
    return true;
}

}  // namespace plait
