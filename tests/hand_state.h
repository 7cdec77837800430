// A state made from a world without a solver, and forces that act on it alone.
#pragma once

#include <plait/world.h>

#include <initializer_list>

namespace plait::test {

template <class Real>
Vec<Real> narrowed(const Vec<double>& a) {
    return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
}

template <class Real>
Vec<double> widened(const Vec<Real>& a) {
    return {double(a.x), double(a.y), double(a.z)};
}

template <class Real>
State<Real> stateOf(const World& world) {
    State<Real> state;
    const std::size_t n = world.start.size();
    state.particles.resize(n + 1, Particle<Real>{});
    state.velocity.resize(n + 1, Padded<Real>{});
    for (std::size_t i = 0; i < n; ++i) {
        state.particles[i].x = narrowed<Real>(world.start[i]);
        state.particles[i].w = world.pinned[i] ? Real(0) : static_cast<Real>(1 / world.mass[i]);
        state.velocity[i].v = narrowed<Real>(world.velocity[i]);
    }
    return state;
}

// One substep of forces alone; positions stay.
template <class Real>
void act(State<Real>& state, std::initializer_list<Force<Real>*> forces, double h, Workers& workers,
         double t = 0) {
    Drawer<Real> none;
    for (Force<Real>* force : forces) force->prepare(state, none, t, h, workers);
    for (Force<Real>* force : forces) force->apply(state, t, h, workers);
}

// Largest difference of any velocity from v.
template <class Real>
double deviation(const State<Real>& state, const Vec<double>& v) {
    double worst = 0;
    for (int i = 0; i < state.count(); ++i)
        worst = std::max(worst, length(widened(state.velocity[static_cast<std::size_t>(i)].v) - v));
    return worst;
}

}  // namespace plait::test
