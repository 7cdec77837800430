// The straight paths of a pair's vertices in a substep, as contacts ask about them.
#pragma once

#include "../../collision/query.h"
#include "nearest.h"

namespace plait {

// Where the vertices of a pair are, m.
using PairPoints = std::array<Vec<double>, 4>;

// Whether a vertex of the one simplex moves as far as this, or further, against one of the other
// (m). If not, and they were further apart than that, they did not meet.
bool movesBy(double distance, const Pairing& pair, const PairPoints& start, const PairPoints& end);

// Whether the boxes round both simplices and their paths come within `reach` (m).
bool mayMeet(const Pairing& pair, const PairPoints& start, const PairPoints& end, double reach);

// Whether the two come within `reach` (m) on their way; `now` is where they are nearest at its
// start. Never true because of how things lie in space: whoever looked for near pairs, and
// whenever, has all for which this holds.
bool comesWithin(double reach, const Pairing& pair, const Nearest& now, const PairPoints& start,
                 const PairPoints& end);

// When the two are no more than `thickness` (m) apart for the first time.
Impact impactOf(const Pairing& pair, const PairPoints& start, const PairPoints& end,
                double thickness);

}  // namespace plait
