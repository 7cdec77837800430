// Which method a solver is made with.
#pragma once

#include "../whole_step.h"

namespace plait {

// Null for methods that sweep. `state` is where the run starts. Throws std::invalid_argument that
// says what the world has and the method has not: contacts, constraints without compliance, an
// integrator.
template <class Real>
std::unique_ptr<WholeStep<Real>> makeWholeStep(const SolverOptions& options,
                                               const std::vector<NamedSet<Real>>& sets,
                                               const State<Real>& state);

}  // namespace plait
