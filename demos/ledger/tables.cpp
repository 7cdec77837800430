#include "tables.h"

#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace plait {
namespace {

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t from = 0;
    for (std::size_t comma; (comma = line.find(',', from)) != std::string::npos; from = comma + 1)
        cells.push_back(line.substr(from, comma - from));
    cells.push_back(line.substr(from));
    return cells;
}

constexpr std::array<double Metric::*, 3> bandOfMetric{&Metric::low, &Metric::high, &Metric::from};

std::vector<std::string> wordsOf(const Settings& settings) {
    std::vector<std::string> words;
    for (const auto& [name, value] : settings) words.push_back(name + "=" + value);
    return words;
}

std::vector<std::string> wordsOf(const std::vector<Metric>& metrics) {
    std::vector<std::string> words;
    for (const Metric& metric : metrics)
        words.push_back(cellOf(metric.name) + " [" + text(metric.low) + ", " + text(metric.high) +
                        "] from " + text(metric.from) + " s");
    return words;
}

}  // namespace

std::string cellOf(std::string words) {
    std::replace(words.begin(), words.end(), ',', ';');
    return words;
}

TableReader::TableReader(const std::string& csv, std::string name)
    : lines_(csv), name_(std::move(name)) {}

std::vector<std::string> TableReader::row() {
    std::string line;
    ++at_;
    if (!std::getline(lines_, line) || line.empty()) return {};
    return cellsOf(line);
}

void TableReader::expect(bool good) const {
    if (!good) throw FileError(name_ + ": line " + std::to_string(at_) + ": not of a ledger");
}

double TableReader::number(const std::string& word) const {
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [next, error] = std::from_chars(word.data(), end, value);
    expect(error == std::errc{} && next == end);
    return value;
}

std::string settingsTable(const Settings& settings) {
    std::string csv = "setting,value\n";
    for (const auto& [name, value] : settings) csv += name + "," + value + "\n";
    return csv;
}

Settings readSettings(TableReader& reader) {
    Settings settings;
    reader.expect(reader.row() == std::vector<std::string>{"setting", "value"});
    for (auto row = reader.row(); !row.empty(); row = reader.row()) {
        reader.expect(row.size() >= 2);
        std::string value = row[1];
        for (std::size_t i = 2; i < row.size(); ++i) value += "," + row[i];
        settings.emplace_back(row[0], value);
    }
    return settings;
}

double takeNumber(const TableReader& reader, Settings& settings, const std::string& name) {
    const auto at = std::ranges::find(settings, name, &Settings::value_type::first);
    reader.expect(at != settings.end());
    const double value = reader.number(at->second);
    settings.erase(at);
    return value;
}

std::string metricsTable(const std::vector<Metric>& metrics,
                         const std::vector<MetricTolerance>& tolerances) {
    std::string csv =
        "metric,low,high,from[s],mean,least,most,mean may change,least may change,"
        "most may change\n";
    for (std::size_t m = 0; m < metrics.size(); ++m) {
        csv += cellOf(metrics[m].name);
        for (const auto place : bandOfMetric) csv += "," + text(metrics[m].*place);
        for (const auto place : allFigures) csv += "," + text(tolerances[m].base.*place);
        for (const auto place : allFigures) csv += "," + text(tolerances[m].allowed.*place);
        csv += "\n";
    }
    return csv;
}

void readMetrics(TableReader& reader, std::vector<Metric>& metrics,
                 std::vector<MetricTolerance>& tolerances) {
    reader.expect(reader.row().size() == 10);
    for (auto row = reader.row(); !row.empty(); row = reader.row()) {
        reader.expect(row.size() == 10);
        Metric& metric = metrics.emplace_back();
        MetricTolerance& tolerance = tolerances.emplace_back();
        metric.name = row[0];
        for (std::size_t i = 0; i < 3; ++i) {
            metric.*bandOfMetric[i] = reader.number(row[1 + i]);
            tolerance.base.*allFigures[i] = reader.number(row[4 + i]);
            tolerance.allowed.*allFigures[i] = reader.number(row[7 + i]);
        }
    }
}

std::vector<std::string> changesOf(const std::string& what, const std::vector<std::string>& stored,
                                   const std::vector<std::string>& now) {
    std::vector<std::string> lines;
    for (const std::string& word : stored)
        if (std::ranges::count(now, word) == 0) lines.push_back(what + " no more: " + word);
    for (const std::string& word : now)
        if (std::ranges::count(stored, word) == 0) lines.push_back(what + " not known: " + word);
    return lines;
}

std::vector<std::string> changesOf(const Settings& stored, const Settings& now) {
    return changesOf("setting", wordsOf(stored), wordsOf(now));
}

std::vector<std::string> changesOf(const std::vector<Metric>& stored,
                                   const std::vector<Metric>& now) {
    return changesOf("metric", wordsOf(stored), wordsOf(now));
}

}  // namespace plait
