// A ledger as a file, and whether it still is about its scene.
#include "demos/tools/words.h"
#include "ledger.h"
#include "tables.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double mayDiffer = 0.02;  // counted work of the whole scene

// Verdicts follow from the figures, and are not read.
void readRows(TableReader& reader, Ledger& ledger) {
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

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

}  // namespace

std::string csvOf(const Ledger& ledger) {
    Settings settings = ledger.settings;
    settings.emplace_back("tolerance", text(ledger.tolerance));
    settings.emplace_back("work", std::to_string(ledger.work));
    std::string csv = settingsTable(settings) + "\n" +
                      metricsTable(ledger.metrics, ledger.tolerances) +
                      "\ningredient,change,work saved,time saved,";
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
    TableReader reader(csv, name);
    ledger.settings = readSettings(reader);
    ledger.tolerance = takeNumber(reader, ledger.settings, "tolerance");
    ledger.work = std::lround(takeNumber(reader, ledger.settings, "work"));
    readMetrics(reader, ledger.metrics, ledger.tolerances);
    readRows(reader, ledger);
    return ledger;
}

Run runOf(const Settings& stored) {
    Settings settings;
    for (const char* name : {"scene", "quality", "seconds"})
        settings.emplace_back(name, valueOf(stored, name));
    return makeRun(settings);
}

std::vector<std::string> differences(const Ledger& stored, const Run& run) {
    std::vector<std::string> lines = changesOf(stored.settings, settingsOf(run)), before, now;
    append(lines, changesOf(stored.metrics, run.scene.metrics));
    for (const LedgerRow& row : stored.rows) before.push_back(row.name());
    for (const Ingredient& ingredient : ingredientsOf(run))
        now.push_back(cellOf(ingredient.name()));
    append(lines, changesOf("ingredient", before, now));
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
