// Who of those that come and go is there.
#pragma once

#include "../numbers/convert.h"
#include "../state.h"

namespace plait {

// A vertex that comes, in place of nothing.
struct Arrival {
    std::int32_t id = 0;  // of its source, counted from 0
    Vec<double> x, v;     // m, m/s
    double mass = 1;      // kg
};

// A state whose substep of h seconds begins.
template <class Real>
class Population {
public:
    Population(State<Real>& state, double h) : state_(state), h_(h) {}

    bool isHere(int v) const { return state_.born[static_cast<std::size_t>(v)] >= 0; }
    double age(int v) const {  // s
        return static_cast<double>(state_.substep - state_.born[static_cast<std::size_t>(v)]) * h_;
    }

    // With a past that goes on as it comes, for BDF2.
    void bring(int v, const Arrival& arrival) {
        const auto i = static_cast<std::size_t>(v);
        move(v, arrival);
        state_.particles[i].w = static_cast<Real>(1 / arrival.mass);
        state_.id[i] = arrival.id;
        state_.born[i] = static_cast<std::int32_t>(state_.substep);
    }

    void move(int v, const Arrival& to) { put(static_cast<std::size_t>(v), to.x, as<Real>(to.v)); }

    // Where it waits (m) from now on.
    void take(int v, const Vec<double>& place) {
        const auto i = static_cast<std::size_t>(v);
        put(i, place, {0, 0, 0});
        state_.particles[i].w = 0;
        state_.id[i] = state_.born[i] = -1;
    }

private:
    void put(std::size_t i, const Vec<double>& x, const Vec<Real>& v) {
        Particle<Real>& p = state_.particles[i];
        split(p, x);
        state_.velocity[i].v = v;
        if (!state_.last.empty()) state_.last[i].v = p.d - static_cast<Real>(h_) * v;
        if (!state_.lastVelocity.empty()) state_.lastVelocity[i].v = v;
    }

    State<Real>& state_;
    double h_;
};

}  // namespace plait
