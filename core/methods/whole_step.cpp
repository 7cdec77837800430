#include "whole_step.h"

#include "../constraints/constants.h"
#include "symplectic.h"

#include <stdexcept>

namespace plait {
namespace {

void refuse(const std::string& what) { throw std::invalid_argument(what); }

template <class Real>
void needCompliance(const std::string& method, const NamedSet<Real>& named,
                    const State<Real>& state) {
    Terms<Real> terms;
    named.set->terms(state, false, terms);
    for (const Real compliance : terms.compliance)
        if (!(compliance > 0))
            refuse("method " + method + " has no rigid constraints, and " + named.name +
                   " has: give it a compliance");
}

}  // namespace

template <class Real>
std::unique_ptr<WholeStep<Real>> makeWholeStep(const SolverOptions& options,
                                               const std::vector<NamedSet<Real>>& sets,
                                               const State<Real>& state, bool airHasInertia) {
    if (options.method == Method::xpbd || options.method == Method::nucleus) return nullptr;
    const std::string method = "symplectic";
    if (airHasInertia) refuse("method " + method + " knows no inertia of the air");
    if (options.integrator != Integrator::first)
        refuse("method " + method + " has an integrator of its own");
    if (options.smoothing > 0) refuse("method " + method + " has no sweeps to smooth after");
    Terms<Real> terms;
    for (const NamedSet<Real>& named : sets) {
        if (named.contact)
            refuse("method " + method + " has no contacts, and " + named.name + " is one");
        if (!named.set->terms(state, false, terms))
            refuse("method " + method + " cannot see into the set " + named.name);
        needCompliance(method, named, state);
    }
    return std::make_unique<Symplectic<Real>>();
}

template std::unique_ptr<WholeStep<float>> makeWholeStep(const SolverOptions&,
                                                         const std::vector<NamedSet<float>>&,
                                                         const State<float>&, bool);
template std::unique_ptr<WholeStep<double>> makeWholeStep(const SolverOptions&,
                                                          const std::vector<NamedSet<double>>&,
                                                          const State<double>&, bool);

}  // namespace plait
