// A ledger as a file, and whether it still is about its scene.
#include "demos/tools/errors.h"
#include "demos/tools/words.h"
#include "ledger.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace plait {
namespace {

constexpr double mayDiffer = 0.02;  // counted work of the whole scene

// Of a table whose columns commas part.
std::string cellOf(std::string words) {
    std::replace(words.begin(), words.end(), ',', ';');
    return words;
}

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t from = 0;
    for (std::size_t comma; (comma = line.find(',', from)) != std::string::npos; from = comma + 1)
        cells.push_back(line.substr(from, comma - from));
    cells.push_back(line.substr(from));
    return cells;
}

constexpr std::array<double Metric::*, 3> bandOfMetric{&Metric::low, &Metric::high, &Metric::from};

// What is read goes from line to line, and knows where it is.
class Reader {
public:
    Reader(const std::string& csv, const std::string& name) : lines_(csv), name_(name) {}

    // The cells of the next line; none where a table ends.
    std::vector<std::string> row() {
        std::string line;
        ++at_;
        if (!std::getline(lines_, line) || line.empty()) return {};
        return cellsOf(line);
    }
    void expect(bool good) const {
        if (!good) throw FileError(name_ + ": line " + std::to_string(at_) + ": not of a ledger");
    }
    double number(const std::string& word) const {
        double value = 0;
        const char* end = word.data() + word.size();
        const auto [next, error] = std::from_chars(word.data(), end, value);
        expect(error == std::errc{} && next == end);
        return value;
    }

private:
    std::istringstream lines_;
    std::string name_;
    int at_ = 0;
};

void readSettings(Reader& reader, Ledger& ledger) {
    reader.expect(reader.row() == std::vector<std::string>{"setting", "value"});
    for (auto row = reader.row(); !row.empty(); row = reader.row()) {
        reader.expect(row.size() >= 2);
        std::string value = row[1];
        for (std::size_t i = 2; i < row.size(); ++i) value += "," + row[i];
        if (row[0] == "tolerance")
            ledger.tolerance = reader.number(value);
        else if (row[0] == "work")
            ledger.work = std::lround(reader.number(value));
        else
            ledger.settings.emplace_back(row[0], value);
    }
}

void readMetrics(Reader& reader, Ledger& ledger) {
    reader.expect(reader.row().size() == 10);
    for (auto row = reader.row(); !row.empty(); row = reader.row()) {
        reader.expect(row.size() == 10);
        Metric& metric = ledger.metrics.emplace_back();
        MetricTolerance& tolerance = ledger.tolerances.emplace_back();
        metric.name = row[0];
        for (std::size_t i = 0; i < 3; ++i) {
            metric.*bandOfMetric[i] = reader.number(row[1 + i]);
            tolerance.base.*allFigures[i] = reader.number(row[4 + i]);
            tolerance.allowed.*allFigures[i] = reader.number(row[7 + i]);
        }
    }
}

// Verdicts follow from the figures, and are not read.
void readRows(Reader& reader, Ledger& ledger) {
    const std::size_t metrics = ledger.metrics.size();
    reader.expect(reader.row().size() == metrics + 6);
    const std::vector<std::string>& essentials = sceneNamed(ledger.scene()).essentials;
    for (auto row = reader.row(); !row.empty(); row = reader.row()) {
        reader.expect(row.size() == metrics + 6);
        LedgerRow& entry = ledger.rows.emplace_back();
        entry.part = row[0], entry.change = row[1], entry.ending = row.back();
        entry.work = reader.number(row[2]), entry.time = reader.number(row[3]);
        for (std::size_t m = 0; m < metrics; ++m)
            entry.changes.push_back(reader.number(row[4 + m]));
        entry.need = needOf(entry, essentials);
    }
}

// A line each of what is in one only.
void compare(const std::string& what, const std::vector<std::string>& stored,
             const std::vector<std::string>& now, std::vector<std::string>& lines) {
    for (const std::string& word : stored)
        if (std::ranges::count(now, word) == 0) lines.push_back(what + " no more: " + word);
    for (const std::string& word : now)
        if (std::ranges::count(stored, word) == 0) lines.push_back(what + " not known: " + word);
}

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

std::string csvOf(const Ledger& ledger) {
    std::string csv = "setting,value\n";
    for (const auto& [name, value] : ledger.settings) csv += name + "," + value + "\n";
    csv += "tolerance," + text(ledger.tolerance) + "\nwork," + std::to_string(ledger.work) + "\n\n";
    csv +=
        "metric,low,high,from[s],mean,least,most,mean may change,least may change,"
        "most may change\n";
    for (std::size_t m = 0; m < ledger.metrics.size(); ++m) {
        csv += cellOf(ledger.metrics[m].name);
        for (const auto place : bandOfMetric) csv += "," + text(ledger.metrics[m].*place);
        for (const auto place : allFigures) csv += "," + text(ledger.tolerances[m].base.*place);
        for (const auto place : allFigures) csv += "," + text(ledger.tolerances[m].allowed.*place);
        csv += "\n";
    }
    csv += "\ningredient,change,work saved,time saved,";
    for (const Metric& metric : ledger.metrics) csv += cellOf(metric.name) + ",";
    csv += "verdict,ending\n";
    for (const LedgerRow& row : ledger.rows) {
        csv += cellOf(row.part) + "," + cellOf(row.change) + "," + rounded("%.6g", row.work) + "," +
               rounded("%.2f", row.time) + ",";
        for (const double change : row.changes)
            csv += (std::isinf(change) ? "inf" : rounded("%.6g", change)) + ",";
        csv += wordOf(row.need) + "," + cellOf(row.ending) + "\n";
    }
    return csv;
}

Ledger ledgerFrom(const std::string& csv, const std::string& name) {
    Ledger ledger;
    Reader reader(csv, name);
    readSettings(reader, ledger);
    readMetrics(reader, ledger);
    readRows(reader, ledger);
    return ledger;
}

Run runOf(const Ledger& stored) {
    Settings settings{{"scene", stored.scene()}};
    for (const char* name : {"quality", "seconds"})
        settings.emplace_back(name, valueOf(stored.settings, name));
    return makeRun(settings);
}

std::vector<std::string> differences(const Ledger& stored, const Run& run) {
    std::vector<std::string> lines, before, now;
    compare("setting", wordsOf(stored.settings), wordsOf(settingsOf(run)), lines);
    compare("metric", wordsOf(stored.metrics), wordsOf(run.scene.metrics), lines);
    for (const LedgerRow& row : stored.rows) before.push_back(row.name());
    for (const Ingredient& ingredient : ingredientsOf(run))
        now.push_back(cellOf(ingredient.name()));
    compare("ingredient", before, now, lines);
    return lines;
}

std::vector<std::string> differences(const Ledger& stored, const Trial& base) {
    if (!base.whole()) return {base.ending};
    std::vector<std::string> lines;
    for (std::size_t m = 0; m < stored.metrics.size(); ++m)
        if (const double change =
                stored.tolerances[m].changeOf(figuresOf(stored.metrics[m], m, base.rows));
            !(change <= 1))
            lines.push_back(stored.metrics[m].name + ": moved by " + rounded("%.2g", change) +
                            " tolerances");
    if (std::fabs(static_cast<double>(base.evaluations() - stored.work)) >
        mayDiffer * static_cast<double>(stored.work))
        lines.push_back("work: " + std::to_string(base.evaluations()) + " for " +
                        std::to_string(stored.work));
    return lines;
}

}  // namespace plait
