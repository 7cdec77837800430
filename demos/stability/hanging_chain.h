// A chain that hangs at rest, and how long theory says that a number of sweeps leaves it: what the
// maps of chains are made of.
#pragma once

#include "outcome.h"

#include <plait/solver.h>

#include <vector>

namespace plait {

// Straight down from a pin, 1 m at rest.
struct HangingChain {
    std::vector<double> mass;        // kg, of the lower end of each link, from the top
    std::vector<double> compliance;  // m/N, of each link

    int links() const { return static_cast<int>(mass.size()); }
    // In m, by which each link is longer than at rest in equilibrium.
    std::vector<double> exact() const;
};

// How many substeps there are in 1/60 s, and how one is solved: by xpbd or block.
struct ChainSolve {
    int substeps = 1;
    int sweeps = 1;  // in a substep; of xpbd forward and back
    Method method = Method::xpbd;
    double damping = 0.9;  // part of the velocity that is lost in 1/24 s, so that it settles
};

// By how much the chain is too long after it has settled, in m, by theory.
//
// xpbd, with A = J W J^T + compliance / h^2, swept forward and back in the order of its colours, G
// what a sweep leaves of an error in A's equations, lambda the tensions times h^2 and n the sweeps:
// a substep must make all of lambda anew, so
//
//   C - exact = A ((1 - G^n)^(-1) - 1) lambda
//
// block, whose sweeps are over vertices, with H = M / h^2 + J^T J / compliance, G the same for H,
// P = H^(-1) M / h^2 and Q = P + G^n (1 - P): it settles where u = Q (u + h^2 g).
double settledExcess(const HangingChain& chain, const ChainSolve& solve);

// Runs it for `seconds`, in which it settles; drifting where it ends further than
// `allowed` m from the length that it has in equilibrium.
Outcome settle(const HangingChain& chain, const ChainSolve& solve, double allowed, double seconds);

}  // namespace plait
