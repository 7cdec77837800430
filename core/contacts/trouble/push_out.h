// Moves what is inside a closed surface out along its normal (M 4.4) [FH1, FH2]: for what begins
// there, or is caught by what is animated. It needs no contacts, nor are they in its way where they
// leave out what is tangled (ContactOptions).
#pragma once

#include "../../complex/shapes.h"
#include "../../constraint.h"

#include <string>
#include <vector>

namespace plait {

struct World;

struct PushOutOptions {
    std::string name = "push-out";
    double strength = 1;  // part of the way out that is gone in a substep, from 0 to 2. 1: to where
                          // both touch; above, it overshoots, and what falls back is thrown up
                          // again
    double radius = 0.1;  // m below the surface to which points are moved; time grows with it
    double thickness = 0;  // m, that are left between the two
    int order = 100;       // after that of all contacts: it looks where they have left things
};

// What it did since the solver was made.
struct PushOutCounts {
    long pairs = 0;   // of a point and a triangle that were looked at, in a substep at most
    long pushed = 0;  // points moved, by substep
};

// Adds a set that does so, at the end of every substep, with the vertices of `points` that are not
// pinned. The way is no velocity, but a point keeps no speed into the surface. Points only: edges
// may still cross, and momentum is not kept. Throws std::invalid_argument, naming the set, for a
// mesh that is not closed, whose triangles do not all turn the same way, and for a value out of
// range.
void pushOut(World& world, Range mesh, const std::vector<Range>& points,
             const PushOutOptions& options = {});

}  // namespace plait
