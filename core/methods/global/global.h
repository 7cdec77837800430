// Newton's method on the tensions of links, for cloth that does not stretch at one step a frame.
//
// Each link keeps a tension T from step to step. A column is one iteration on the augmented
// Lagrangian (Hestenes 1969; Powell 1969; Nocedal and Wright, "Numerical Optimization", 17.3):
//
//   (M / h^2 + sum of D H D^T) dx = M / h^2 (y - x) - sum of T' grad C
//   T <- T' + k' grad C dx,  T' = (T + k C) / (1 + k alpha),  k' = k / (1 + k alpha)
//   H = k' u u^T + max(T, 0) / l (I - u u^T)
//
// u is the direction of the link, l its length, alpha its compliance; k sets how fast C falls and
// not where to, and is as large as float bears. The second term of H is what a taut thread has
// against being turned; without it a sheet of rigid links is stiff in no direction that matters.
// All of it is solved at once (multifrontal.h), or, of more than a hundred thousand vertices,
// nearly (smoothed_aggregation.h).
//
// What turns far in a step comes out too long. So XPBD sweeps over all links go before and after,
// and more of them over those that are still off, with the rings of neighbours around them.
//
// Sets that hold single vertices on both sides (Attach) are springs in the matrix, of stiffness k
// where they are rigid, and these are projected last. Contacts keep a force as links keep a
// tension; what they push, or what has passed them, they hold on both sides in an iteration, and
// let go what they then pulled. All other sets (bending, shear, tethers) are swept between the
// links by XPBD, and how they move vertices is added to y, so that the solution knows of their
// force.
//
// The condition of the matrix is about ten times k h^2 / m. What rounding leaves of the equations
// is solved for again; where that corrects the step by a quarter, or a pivot is lost, or a quarter
// of the residual is left, the matrix is made anew with a quarter of k.
#pragma once

#include "../../whole_step.h"

namespace plait {

// Tensions are in its drawer. Links are the sets whose constraint is the distance of two
// vertices.
template <class Real>
std::unique_ptr<WholeStep<Real>> makeGlobal(const SolverOptions& options,
                                            const std::vector<NamedSet<Real>>& sets,
                                            const State<Real>& state);

}  // namespace plait
