// Area, volume, lowest point and centre of mass of a state.
//
// All throw std::invalid_argument on an index out of range, on spans that differ in length and
// where the result is undefined. Sums are compensated, in the order given.
#pragma once

#include <array>
#include <span>

#include "../../numbers/math.h"

namespace plait {

// Sum of the triangles' areas, in m^2; positions in m.
double area(std::span<const Vec<double>> positions, std::span<const std::array<int, 3>> triangles);

// Volume in m^3 inside a closed surface, positive if its triangles run anticlockwise seen from
// outside. A surface with a boundary gives a number without meaning.
double volume(std::span<const Vec<double>> positions,
              std::span<const std::array<int, 3>> triangles);

// The first of the positions least far along `up` (any length but 0). Refuses no positions.
Vec<double> lowestPoint(std::span<const Vec<double>> positions, const Vec<double>& up);

// Sum of m x over the sum of m, in m; masses in kg. Refuses masses that do not add up to above 0.
Vec<double> centreOfMass(std::span<const double> masses, std::span<const Vec<double>> positions);

}  // namespace plait
