#include "methods.h"

#include "../constraints/constants.h"
#include "block/block.h"
#include "global/global.h"
#include "linearised.h"
#include "newton/newton.h"
#include "springs/explicit.h"
#include "springs/implicit.h"
#include "springs/symplectic.h"

#include <stdexcept>

namespace plait {
namespace {

// What a method can do besides springs.
struct Scope {
    std::string name;
    bool rigid = false, contacts = false, bdf2 = false;
};

Scope scopeOf(Method method) {
    switch (method) {
        case Method::explicitEuler:
            return {.name = "explicit"};
        case Method::symplectic:
            return {.name = "symplectic"};
        case Method::implicit:
            return {.name = "implicit"};
        case Method::linearised:
            return {.name = "linearised", .rigid = true, .contacts = true, .bdf2 = true};
        case Method::block:
            return {.name = "block", .rigid = true, .contacts = true, .bdf2 = true};
        case Method::global:
            return {.name = "global", .rigid = true, .contacts = true, .bdf2 = true};
        case Method::newton:
            return {.name = "newton", .rigid = true, .contacts = true, .bdf2 = true};
        default:
            throw std::invalid_argument("no such method");
    }
}

template <class Real>
void check(const Scope& scope, const NamedSet<Real>& named, const State<Real>& state) {
    const std::string method = "method " + scope.name + " ", set = "set " + named.name;
    Terms<Real> terms;
    if (!named.set->terms(state, false, terms))
        throw std::invalid_argument(method + "cannot see into " + set +
                                    ": let it have terms, or take xpbd");
    if (named.contact && !scope.contacts)
        throw std::invalid_argument(method + "has no contacts, and " + set +
                                    " is one: leave it out, or take xpbd or block");
    if (scope.rigid) return;
    for (int n = 0; n < terms.size(); ++n)
        if (terms.rigid(n))
            throw std::invalid_argument(method + "has no rigid constraints, and " + set +
                                        " has: give it a compliance, or take xpbd or block");
}

}  // namespace

template <class Real>
std::unique_ptr<WholeStep<Real>> makeWholeStep(const SolverOptions& options,
                                               const std::vector<NamedSet<Real>>& sets,
                                               const State<Real>& state) {
    if (options.integrator == Integrator::midpoint && options.method != Method::newton)
        throw std::invalid_argument("integrator midpoint is for method newton alone");
    if (options.method == Method::xpbd || options.method == Method::nucleus) return nullptr;
    const Scope scope = scopeOf(options.method);
    const std::string method = "method " + scope.name + " ";
    if (options.integrator != Integrator::first && !scope.bdf2)
        throw std::invalid_argument(
            method + "has an integrator of its own: choose the integrator \"first\"");
    for (const NamedSet<Real>& named : sets) check(scope, named, state);
    switch (options.method) {
        case Method::explicitEuler:
            return std::make_unique<Explicit<Real>>();
        case Method::symplectic:
            return std::make_unique<Symplectic<Real>>();
        case Method::implicit:
            return std::make_unique<Implicit<Real>>();
        case Method::linearised:
            return std::make_unique<Linearised<Real>>();
        case Method::newton:
            if constexpr (std::is_same_v<Real, double>) return makeNewton(options, sets, state);
            throw std::invalid_argument("method newton runs in double: set precision double");
        case Method::global:
            return makeGlobal(options, sets, state);
        default:
            return std::make_unique<Block<Real>>(sets, state);
    }
}

template std::unique_ptr<WholeStep<float>> makeWholeStep(const SolverOptions&,
                                                         const std::vector<NamedSet<float>>&,
                                                         const State<float>&);
template std::unique_ptr<WholeStep<double>> makeWholeStep(const SolverOptions&,
                                                          const std::vector<NamedSet<double>>&,
                                                          const State<double>&);

}  // namespace plait
