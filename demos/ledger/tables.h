// The tables of a CSV file that a ledger or a tuning is stored as: an empty line ends each.
#pragma once

#include "trials.h"

#include <sstream>
#include <string>
#include <vector>

namespace plait {

// Without the commas that part columns.
std::string cellOf(std::string words);

// Reads line by line, and knows where it is.
class TableReader {
public:
    TableReader(const std::string& csv, std::string name);

    // The cells of the next line; none where a table ends.
    std::vector<std::string> row();
    // Throws FileError that begins with the name, for what is not good.
    void expect(bool good) const;
    double number(const std::string& word) const;

private:
    std::istringstream lines_;
    std::string name_;
    int at_ = 0;
};

// "setting,value", and the settings.
std::string settingsTable(const Settings& settings);
Settings readSettings(TableReader& reader);
// Takes a setting out of these; 0 where it is none.
double takeNumber(const TableReader& reader, Settings& settings, const std::string& name);

// Bands of metrics, what they come to and what that may change by; the rest of a metric stays as it
// is made.
std::string metricsTable(const std::vector<Metric>& metrics,
                         const std::vector<MetricTolerance>& tolerances);
void readMetrics(TableReader& reader, std::vector<Metric>& metrics,
                 std::vector<MetricTolerance>& tolerances);

// Where what was stored differs from what is now, a line each.
std::vector<std::string> changesOf(const Settings& stored, const Settings& now);
std::vector<std::string> changesOf(const std::vector<Metric>& stored,
                                   const std::vector<Metric>& now);
// Of these names.
std::vector<std::string> changesOf(const std::string& what, const std::vector<std::string>& stored,
                                   const std::vector<std::string>& now);

}  // namespace plait
