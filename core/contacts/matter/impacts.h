// Impacts that bounce: one after the other in time, at a fixed step (S 7, figure 20). Nothing moves
// to the time of an impact; the straight paths of what meets are bent there, and later impacts are
// found on the bent paths. There are only so many a substep, so a ball whose bounces come ever
// faster comes to rest and locks nothing up.
#pragma once

#include "../search/paths.h"

#include <span>
#include <vector>

namespace plait {

// Two that may meet in a substep, and on which terms.
struct Bounce {
    Pairing pair;
    double gap;          // m, at which they meet
    double restitution;  // speed apart over speed of approach
    double friction;     // impulse along over impulse across, at most
};

// The way of a vertex in a substep, as a straight line; of a bent path the last part, drawn back
// to where it would have begun.
struct Path {
    Vec<double> start, end;  // m
    Vec<double> gain{};      // m, by which it is longer than the last substep's: acceleration h^2
    double from = 0;         // part of the substep, from which on it is the way
    bool bent = false;
};

struct Bounced {
    int count;
    bool cut;  // there are more, which are not followed
};

// Bends `paths` (by vertex) at the impacts of `bounces`, earliest first, at most `limit`. The speed
// of an impact is the one it has at its time, not the path's mean: bounces that took the mean would
// gain as much as they lose where they are low, and never end. Inverse masses in 1/kg; what
// approaches by less than `least` (m in the substep) does not bounce.
Bounced bounce(std::span<const Bounce> bounces, std::span<const double> inverseMass,
               std::span<Path> paths, double least, int limit);

}  // namespace plait
