// Nucleus (Stam 2009, sections 5 and 6): every evaluation projects each constraint onto C = 0 by
// one Newton iteration along its gradient, and forgets. Softness is not a compliance but the number
// of evaluations, weakened by `strength` where the schedule forces more of them than were asked for
// (M 2.4). Kept as the paper has it, although stiffness then depends on everything.
#pragma once

#include "../../kernels/kernels.h"

namespace plait {

template <class Real>
Sweep<Real> nucleusSweep(double strength) {
    return {.particles = nullptr,
            .out = nullptr,
            .inverseH2 = 0,
            .keep = 0,
            .strength = static_cast<Real>(strength)};
}

}  // namespace plait
