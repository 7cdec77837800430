// What every kind may use. A kind is one header with the local mathematics of one constraint:
//
//   arity                    how many vertices it joins
//   Row<T>                   its parameters, members of type T only
//   evaluate(row, x, g)      C(x) and its gradient. x is relative to the first vertex, or, where
//                            the kind is anchored, to origin(row); so no digits go to where the
//                            scene stands. What joins vertices to nothing else is not anchored
//   compliance(row, s)       inverse stiffness, given the sign of s: the value C would have without
//                            this constraint. `slack` means that the constraint does not act there
//   rest(x)                  the row for which x is the rest shape
//
// All but the last run as double, float and packs: no branches, no library, no bare division.
// Kinds do not know particles, sets, methods or time.
#pragma once

#include "../numbers/math.h"

namespace plait {
inline namespace PLAIT_ISA {

// The compliance where a constraint does not act: its multiplier is 0 there. One-sided constraints
// are two-sided ones with this on their free side.
inline constexpr double slack = 1e30;

// Positions come relative to origin(row): a kind that acts on the world, or is part of a sum.
template <class Kind>
inline constexpr bool anchored =
    requires(const typename Kind::template Row<double>& row) { Kind::origin(row); };

}  // namespace PLAIT_ISA
}  // namespace plait
