// When things that move have met: the pictures of Stam 2009, section 7, drawn by the queries of
// core/collision.
#pragma once

#include "render/charts/chart.h"

#include <filesystem>
#include <vector>

namespace plait {

inline constexpr const char* collisionTitle = "Space and time: what has met in between";

// A particle on a line, from start to end in a step; all are as heavy.
struct LineParticle {
    double start, end;
};

// The sets of paths that end with no two having met, each with one meeting less than the one
// before: the earliest is resolved, by what restitution in [0, 1] leaves of the relative velocity,
// and the rest of the step changes, while nothing is moved to the time of the meeting. At most
// `most` meetings. `particles` from left to right.
std::vector<std::vector<LineParticle>> resolveOnLine(std::vector<LineParticle> particles,
                                                     double restitution, int most);

// Of `count` bullets that pass a sheet of thickness h in a step of `length` thicknesses, the part
// that is found where they are at its end, and on their way.
struct Found {
    double atEnd, onTheWay;
};
Found foundBullets(double length, int count);

Figure spaceTimeFigure();  // S figures 15, 16 and 20
Figure bulletFigure();     // S figure 14
Figure thickFigure();      // S figure 19

// Leaves space-time, bullet and thick, .svg and .png each, and index.html. Throws FileError or
// std::runtime_error, "file: cause".
void writeCollision(const std::filesystem::path& folder, bool quiet);

}  // namespace plait
