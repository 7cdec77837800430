// A heavy elastic rod, held level at one end, as the chain of links that it is computed as: what is
// left between this and a simulation is the solver's own error, none of the mesh's (validation A2).
#pragma once

namespace plait {

struct RodTip {
    double reach, drop;  // of its length, from where it is clamped
};

// Where the tip rests. The chain is clamped in the middle of its first link; its hinges have the
// energy B psi^2 / 2 l and its vertices the mass of half of either link. `gamma` is w L^3 / B,
// weight against stiffness, above 0; `links` 2 or more.
RodTip heavyRodTip(double gamma, int links);

}  // namespace plait
