// Coulomb's law at one contact, in multipliers: what has slipped in this substep is taken back,
// with as much as friction allows.
#pragma once

#include "../numbers/math.h"

#include <algorithm>

namespace plait {

// Of a pair the mean counts, at most 1 (M 5.5) [FR1].
struct Friction {
    double standing, sliding;

    Friction(double standingA, double standingB, double slidingA, double slidingB)
        : standing(std::min(1.0, 0.5 * (standingA + standingB))),
          sliding(std::min(1.0, 0.5 * (slidingA + slidingB))) {}

    explicit operator bool() const { return standing != 0 || sliding != 0; }

    // The new multiplier along the surface (kg m) after a slip along it (m, not 0), of which a
    // multiplier of 1 takes back `answer` (1/kg); `pressed` is the multiplier across (kg m).
    Vec<double> grip(const Vec<double>& before, const Vec<double>& slip, double answer,
                     const Vec<double>& normal, double pressed) const {
        Vec<double> grip = before - divide(1.0, answer) * slip;
        grip -= dot(grip, normal) * normal;
        const double force = length(grip);
        if (sliding < 0) return (-sliding * pressed / length(slip)) * slip;
        if (force > standing * pressed) grip = divide(sliding * pressed, force) * grip;
        return grip;
    }
};

}  // namespace plait
