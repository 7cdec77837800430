// Momentum and angular momentum of a state: what every force and constraint between the points
// themselves must leave as it is.
//
// Throw std::invalid_argument where spans differ in length. Sums are compensated, in the order
// given.
#pragma once

#include <span>

#include "../numbers/math.h"
#include "checks.h"
#include "compensated_sum.h"

namespace plait {

// Sum of m v, in kg m/s; masses in kg (0 for what should not count), velocities in m/s.
inline Vec<double> momentum(std::span<const double> masses,
                            std::span<const Vec<double>> velocities) {
    checkSameSize(masses.size(), velocities.size(), "masses and velocities");
    CompensatedVecSum sum;
    for (std::size_t i = 0; i < masses.size(); ++i) sum.add(masses[i] * velocities[i]);
    return sum.value();
}

// Sum of m (x - about) x v, in kg m^2/s; positions in m.
inline Vec<double> angularMomentum(std::span<const double> masses,
                                   std::span<const Vec<double>> positions,
                                   std::span<const Vec<double>> velocities,
                                   const Vec<double>& about = {}) {
    checkSameSize(masses.size(), positions.size(), "masses and positions");
    checkSameSize(masses.size(), velocities.size(), "masses and velocities");
    CompensatedVecSum sum;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        sum.add(masses[i] * cross(positions[i] - about, velocities[i]));
    }
    return sum.value();
}

}  // namespace plait
