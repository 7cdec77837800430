// Strain of edges: how far a cloth or rope is from inextensible.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../numbers/math.h"

namespace plait {

// Over the edges' strains e = length / rest - 1, in units of 1.
struct StrainSummary {
    double maximum = 0;  // the largest e: the greatest extension, below 0 if all are compressed
    double percentile99 = 0;  // of |e|: the least value that 99 % of all edges do not exceed
    double mean = 0;          // of |e|
    double minimum = 0;  // the smallest e: the greatest compression, above 0 if all are extended
};

// Each edge's e, in the order given; positions and rest lengths in m. Throws std::invalid_argument
// where spans differ in length, an index is out of range or a rest length is not above 0.
std::vector<double> strains(std::span<const Vec<double>> positions,
                            std::span<const std::array<int, 2>> edges,
                            std::span<const double> rest);

// Summary of the above; all 0 for no edges.
StrainSummary summarizeStrain(std::span<const Vec<double>> positions,
                              std::span<const std::array<int, 2>> edges,
                              std::span<const double> rest);

}  // namespace plait
