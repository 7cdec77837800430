// What a study leaves: points.csv, a chart for each kind of error, and index.html with all of it.
#pragma once

#include "points.h"
#include "tasks.h"

#include <string>
#include <vector>

namespace plait {

// Writes the report of these rows; `command` is what was typed. Returns what it prints: reference,
// tables, findings.
std::string writeReport(const Study& study, const std::vector<StudyRow>& rows,
                        const Reference& reference, const StudyFolder& folder,
                        const std::string& command);

// Loud if the reference is not 100 times more exact than the best point, else empty.
std::string verdictOnReference(const Study& study, const Reference& reference,
                               const std::vector<StudyPoint>& points);

}  // namespace plait
