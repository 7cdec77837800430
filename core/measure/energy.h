// Energies of a state, from positions and velocities alone: independent of the solver's code.
//
// All throw std::invalid_argument where spans differ in length or an index is out of range. Sums
// are compensated and in the order given, so the same input gives the same bits.
#pragma once

#include <array>
#include <span>

#include "../numbers/math.h"

namespace plait {

// Sum of m v^2 / 2, in J; masses in kg (0 for what should not count), velocities in m/s.
double kineticEnergy(std::span<const double> masses, std::span<const Vec<double>> velocities);

// -Sum of m g.x, in J, so 0 at the origin; g in m/s^2, positions in m.
double gravitationalEnergy(std::span<const double> masses, std::span<const Vec<double>> positions,
                           const Vec<double>& g);

// Sum of C^2 / (2 compliance), in J, over constraint values C. Compliance 0 is a hard constraint,
// which stores nothing whatever its C; a negative one is refused.
double harmonicEnergy(std::span<const double> values, std::span<const double> compliances);

// harmonicEnergy of C = length - rest over edges, in J; rest lengths in m, compliances in m/N.
// Where C < 0 the compression compliance holds, unless that span is empty.
double stretchEnergy(std::span<const Vec<double>> positions,
                     std::span<const std::array<int, 2>> edges, std::span<const double> rest,
                     std::span<const double> compliances,
                     std::span<const double> compressionCompliances = {});

}  // namespace plait
