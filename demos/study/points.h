// The points of a study: what every run was, took and missed, as rows of a table; and the medians.
#pragma once

#include "study.h"

#include <string>
#include <vector>

namespace plait {

// One run. points.csv has the settings' names, repeat, ending, evaluations, seconds[s], cpu[s], the
// keys of the errors and hash as its columns; an error that has no number is empty.
struct StudyRow {
    Settings settings;  // all of them, of the run
    int repeat = 1;
    std::string ending;
    long evaluations = 0;
    double seconds = 0, cpu = 0;
    std::vector<double> errors;
    std::string hash;

    bool operator==(const StudyRow&) const = default;
};

std::string csvOf(const Study& study, const std::vector<StudyRow>& rows);
// Throws FileError that begins with `name`, for other columns as well.
std::vector<StudyRow> rowsFrom(const Study& study, const std::string& csv, const std::string& name);

// All runs with the same settings.
struct StudyPoint {
    std::string curve;  // "" for settings that no curve has
    Settings settings;
    std::string ending;
    int runs = 0;
    double seconds = 0, cpu = 0, least = 0;  // medians, and the least by the clock
    double evaluations = 0;
    std::vector<double> errors = {};
    bool isDefault = false;  // the scene's own settings
    bool sameBits = true;    // in all runs

    bool omitted() const { return ending.starts_with("omitted"); }
    // Diverged or exploded: further off than twice the scene's size, strained by more than 200 %
    // (validation C7).
    bool failed() const;
};

// Curve by curve, in the order of their tasks; what no curve has comes last.
std::vector<StudyPoint> pointsOf(const Study& study, const std::vector<StudyRow>& rows);

// "bdf2, 16 x 1, double": what tells a point from the others of its curve.
std::string nameOf(const StudyPoint& point);

// Those of a curve that count, by work.
std::vector<const StudyPoint*> along(const std::vector<StudyPoint>& points,
                                     const std::string& curve);

// Work of the default over the least that reaches its error, by any curve that has no flaw: at most
// 1 on the front. Between two points a curve is straight, in logarithms of both. 0 if the study has
// no default that ran.
double defaultExcess(const Study& study, const std::vector<StudyPoint>& points);

// A line each: pairs of neighbours by work in a curve of which the dearer is worse, by more than a
// tenth; curves with a flaw that beat the default; runs that differ in their bits.
std::vector<std::string> findings(const Study& study, const std::vector<StudyPoint>& points);

}  // namespace plait
