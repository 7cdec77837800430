// A heavy elastic rod, held level at one end, as the chain of links that it is computed as: what is
// left between this and a simulation is the solver's own error, none of the mesh's (validation A2).
#pragma once

#include <vector>

namespace plait {

// A planar chain of links (m) on hinges of the energy B psi^2 / 2 l, l being half of both links and
// B the `stiffness` (N m^2, above 0); the first link is clamped and level, and `loads` (N) pull
// down on each of the others at its far end and beyond. The angles below the horizontal of all
// links but the first that leave no moment at a hinge.
std::vector<double> hangingAngles(const std::vector<double>& lengths, double stiffness,
                                  const std::vector<double>& loads);

struct RodTip {
    double reach, drop;  // of its length, from where it is clamped
};

// Where the tip of a chain of `links`, 2 or more, rests whose vertices have the mass of half of
// either link; clamped where `held` of its first link is left behind. `gamma` is w L^3 / B, weight
// against stiffness, above 0.
RodTip heavyRodTip(double gamma, int links, double held = 0.5);

}  // namespace plait
