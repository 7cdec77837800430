// Symplectic Euler (Stam 2009, section 4.2; the velocity-first form): every constraint is a spring
// whose force is taken where the substep began.
//
//   v <- v + h W f(x),  x <- x + h v
//
// Stable up to h = 2 / omega of the fastest mode, and beyond it not at all (validation A0).
#pragma once

#include "springs.h"

namespace plait {

template <class Real>
class Symplectic : public WholeStep<Real> {
public:
    long take(WholeSubstep<Real>& s) override {
        const long work = springs_.atStart(s);  // f(x)
        const Real h2 = static_cast<Real>(s.h * s.h);
        for (std::size_t i = 0; i < springs_.force.size(); ++i)  // x + h v, v with h W f(x)
            s.state.particles[i].d += (h2 * s.state.particles[i].w) * springs_.force[i];
        return work;
    }

private:
    Springs<Real> springs_;
};

}  // namespace plait
