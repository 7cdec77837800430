// Newton's method on a whole substep, to convergence, in double: the reference that other methods
// are charted against. Backward Euler, BDF2 and midpoint, so that two integrators check each other.
//
// Each iteration solves the equations of newton_equations.h, linearised, for positions and
// multipliers at once (sparse LDL^T; LU under midpoint, whose matrix is not symmetric, at five
// times the cost); a line search keeps what is left of them falling. Converged: forces balance to
// 1e-12 of the largest and constraints hold to 1e-15 of the size of the world, or to a hundred
// times that where rounding allows no more. Where it is not reached, Diverged says so: a sheet of
// rigid links that lies flat, or passes close by it in a large step, has equations that are all but
// singular.
//
// The order is 1, 2 and 2 for constraints, gravity and whatever else does not change within a
// substep. Other forces are taken where the substep begins (force.h): with fields and air
// the order of midpoint is 1, and that of BDF2 stays 2 only for linear drag on facets that do not
// turn. A reference with such forces needs small steps and its self-difference. Moving rows of soft
// sets are seen as they are at the end.
//
// A factorisation counts as work: as many constraints as are links swept with as many
// multiplications.
//
// Midpoint damps nothing: what leaves a rigid constraint in velocity stays there, with its sign
// changing, so let it start without.
#pragma once

#include "../../whole_step.h"

namespace plait {

// Throws std::invalid_argument for a set that is rigid and has no gradient where it starts, such as
// a hard Attach.
std::unique_ptr<WholeStep<double>> makeNewton(const SolverOptions& options,
                                              const std::vector<NamedSet<double>>& sets,
                                              const State<double>& state);

}  // namespace plait
