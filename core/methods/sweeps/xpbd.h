// Extended position-based dynamics (Macklin, Müller, Chentanez, "XPBD", 2016), with small steps
// (Macklin et al., "Small steps in physics simulation", 2019).
//
// A multiplier accumulates over all evaluations of a substep, so that compliance holds whatever
// their number: dlambda = -(C + a lambda) / (J W J^T + a), a = compliance / h^2 (Eq. 18). `h` is
// the step that the velocity rule implies: 2/3 of the substep under BDF2.
#pragma once

#include "../../kernels/kernels.h"

namespace plait {

template <class Real>
Sweep<Real> xpbdSweep(double h) {
    return {.particles = nullptr,
            .out = nullptr,
            .inverseH2 = static_cast<Real>(1 / (h * h)),
            .keep = 1,
            .strength = 1};
}

}  // namespace plait
