// Mass of what a closed surface holds, taken as solid.
#pragma once

#include "../../numbers/symmetric.h"

#include <array>
#include <span>

namespace plait {

// Of density 1: volume (m^3), centre (m), and the integral of r r^T about it (m^5).
struct SolidMoments {
    double volume;
    Vec<double> centre;
    Symmetric<double> second;

    // Of inertia: trace of `second` less it.
    Symmetric<double> inertia() const;
};

// Of a closed surface whose triangles run anticlockwise seen from outside; volume and moments are
// negative if it is inside out. Exact but for rounding: tetrahedra from its first vertex.
SolidMoments solidMoments(std::span<const Vec<double>> positions,
                          std::span<const std::array<int, 3>> triangles);

}  // namespace plait
