// Equal cost and equal error: both directions of the same chart, as tables.
#pragma once

#include "points.h"

#include <string>
#include <vector>

namespace plait {

// A table of words; the first row is its header.
using Table = std::vector<std::vector<std::string>>;

// For each curve the least error (the first kind) within each budget of time, ms for 1/24 s of
// playing time: powers of 4 that the points span. `seconds` is the playing time of the study.
Table equalCost(const Study& study, const std::vector<StudyPoint>& points, double seconds);

// For each curve the least time, in the same unit, and the least work, constraints swept a second
// of playing time, that reach 1e-1, 1e-2 ... as far as any point does.
Table equalError(const Study& study, const std::vector<StudyPoint>& points, double seconds);

// Columns side by side; and as HTML.
std::string textOf(const Table& table);
std::string htmlOf(const Table& table);

// ms of the thread that solves for 1/24 s of playing time. On a quiet machine it is the wall time,
// which `busyness` compares with it: the median of wall time over it, 1 where nothing else runs.
inline double frameCost(const StudyPoint& point, double seconds) {
    return 1000 * point.cpu / (24 * seconds);
}
double busyness(const std::vector<StudyPoint>& points);

}  // namespace plait
