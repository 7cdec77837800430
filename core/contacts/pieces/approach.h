// When two pieces on their ways first come near each other.
#pragma once

#include "parting.h"

#include <optional>

namespace plait {

struct Meeting {
    double part;  // of the way
    Parting parting;
    Placed first, second;  // there
};

// The first time at which a plane parts them by `near` (m) or less, to a twentieth of it, by
// conservative advancement (Mirtich 1996); if they do not come so near, where they end, if a plane
// parts them there by `far` or less. The ways are those of rigid motions.
bool findMeeting(const Convex& first, const PoseWay& firstWay, const Convex& second,
                 const PoseWay& secondWay, double near, double far, Meeting& meeting);

}  // namespace plait
