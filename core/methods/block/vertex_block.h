// What a vertex alone has of a Hessian.
#pragma once

#include "../../numbers/symmetric.h"
#include "../../terms.h"

namespace plait {

// Second derivatives of constraint n at its vertex a.
template <class Real>
Symmetric<Real> vertexBlock(const Terms<Real>& terms, int n, int a) {
    const Real* const x = terms.block(n, a, a);
    const Real* const y = x + 3 * terms.arity;
    return {x[0], x[1], x[2], y[1], y[2], y[3 * terms.arity + 2]};
}

}  // namespace plait
