// Explicit Euler (Stam 2009, section 4.2): every constraint is a spring, and both lines take what
// the substep began with.
//
//   x <- x + h v,  v <- v + h W f(x)
//
// Kept to be seen failing: a mode of frequency omega grows by sqrt(1 + h^2 omega^2) in every
// substep, whatever h (validation A0). Damping that outweighs it has to come from elsewhere.
#pragma once

#include "springs.h"

namespace plait {

template <class Real>
class Explicit : public WholeStep<Real> {
public:
    long take(WholeSubstep<Real>& s) override {
        const long work = springs_.atStart(s);  // f(x)
        const Real h = static_cast<Real>(s.h);
        for (std::size_t i = 0; i < springs_.force.size(); ++i) {
            Particle<Real>& p = s.state.particles[i];
            Vec<Real>& v = s.state.velocity[i].v;
            const Vec<Real> start = s.state.before[i].v;
            if (p.w == Real(0)) {
                v = (1 / h) * (p.d - start);  // a pin moves as told
            } else {
                p.d = start + h * s.state.lastVelocity[i].v;  // x + h v
                v += (h * p.w) * springs_.force[i];           // v + h W f(x)
            }
        }
        return work;
    }
    bool setsVelocities() const override { return true; }

private:
    Springs<Real> springs_;
};

}  // namespace plait
