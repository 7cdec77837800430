// What acts from outside: it changes velocities before positions are predicted.
#pragma once

#include "kernels/workers.h"
#include "state.h"

#include <string>

namespace plait {

template <class Real>
class Force {
public:
    virtual ~Force() = default;

    // The name that warnings and a divergence report use.
    virtual std::string name() const = 0;

    // What it keeps past a substep, as a run begins.
    virtual void furnish(Drawer<Real>&) const {}
    // The acceleration that it gives to all that is not pinned, m/s^2.
    virtual Vec<double> fall() const { return {0, 0, 0}; }

    // A frame begins, from time t0 to t1 (s): fields are evaluated here, once a frame (M 3.1.2)
    // [IN29].
    virtual void beginFrame(const State<Real>&, double /*t0*/, double /*t1*/, Workers&) {}
    // Before any force of a substep of h seconds that begins at time t, where everything stays
    // until all have been applied: what follows from positions, and what changes velocities at
    // once, lastVelocity among them where there is one. `kept` is its drawer.
    virtual void prepare(State<Real>&, Drawer<Real>& /*kept*/, double /*t*/, double /*h*/,
                         Workers&) {}
    // v <- v + h w f for a substep of h seconds that begins at time t. Vertices without inverse
    // mass stay as they are.
    virtual void apply(State<Real>&, double t, double h, Workers&) = 0;
    // A substep of h seconds is over, at time t: what comes apart is told in State::cuts.
    virtual void settle(State<Real>&, Drawer<Real>& /*kept*/, double /*t*/, double /*h*/) {}
};

// v <- v + w p for an impulse p in N s.
template <class Real>
void push(State<Real>& state, std::size_t i, const Vec<Real>& p) {
    state.velocity[i].v += state.particles[i].w * p;
}

}  // namespace plait
