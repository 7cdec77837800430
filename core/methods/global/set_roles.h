// What a set of constraints is to a method that solves for tensions.
#pragma once

#include "../../constraints/constants.h"
#include "../../numbers/convert.h"
#include "../../terms.h"

#include <algorithm>
#include <cmath>

namespace plait {

// From vertex a to vertex b, m.
template <class Real>
Vec<double> between(const State<Real>& state, int a, int b) {
    const Particle<Real>&p = state.particles[a], &q = state.particles[b];
    return (as<double>(q.x) - as<double>(p.x)) + (as<double>(q.d) - as<double>(p.d));
}

// Two vertices each, and C changes with their distance as that does.
template <class Real>
bool areLinks(const Terms<Real>& terms, const State<Real>& state) {
    if (terms.arity != 2) return false;
    for (int n = 0; n < terms.size(); ++n) {
        const Vec<double> d = between(state, terms.ids[2 * n], terms.ids[2 * n + 1]);
        const Vec<Real>&from = terms.gradient[2 * n], &to = terms.gradient[2 * n + 1];
        if (!(from == -to) || std::fabs(dot(as<double>(to), d) - length(d)) > 1e-5 * length(d))
            return false;
    }
    return true;
}

// At single vertices, and on both sides.
template <class Real>
bool areHolds(const Terms<Real>& terms) {
    if (terms.arity != 1) return false;
    for (int n = 0; n < terms.size(); ++n)
        if (!(std::max(terms.above[n], terms.below[n]) < Real(slack))) return false;
    return true;
}

template <class Real>
bool areRigid(const Terms<Real>& terms) {
    for (int n = 0; n < terms.size(); ++n)
        if (!terms.rigid(n)) return false;
    return true;
}

}  // namespace plait
