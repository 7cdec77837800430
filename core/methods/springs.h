// Constraints as springs: the force -C grad C / alpha of every set, for the methods of Stam 2009,
// section 4.2. Constraints that do not act where C lies give none.
#pragma once

#include "../constraints/constants.h"
#include "whole_step.h"

namespace plait {

template <class Real>
struct Springs {
    std::vector<Vec<Real>> force;      // N, by vertex
    std::vector<Terms<Real>> terms;    // by set, of the last call
    std::vector<Vec<Real>> predicted;  // m, what d was

    // Forces where the vertices were at `d`, which need not be where they are. Returns the
    // constraints evaluated.
    long at(WholeSubstep<Real>& s, const std::vector<Padded<Real>>& d, bool curved = false) {
        State<Real>& state = s.state;
        predicted.resize(state.particles.size());
        for (std::size_t i = 0; i < predicted.size(); ++i) {
            predicted[i] = state.particles[i].d;
            state.particles[i].d = d[i].v;
        }
        force.assign(state.particles.size(), {0, 0, 0});
        terms.resize(s.sets.size());
        long work = 0;
        for (std::size_t k = 0; k < s.sets.size(); ++k) {
            s.sets[k]->terms(state, curved, terms[k]);
            work += terms[k].size();
            add(terms[k]);
        }
        for (std::size_t i = 0; i < predicted.size(); ++i) state.particles[i].d = predicted[i];
        return work;
    }

private:
    void add(const Terms<Real>& t) {
        for (int n = 0; n < t.size(); ++n) {
            if (!(t.compliance[n] < Real(slack))) continue;
            const Real lambda = -t.value[n] / t.compliance[n];
            for (int a = t.arity * n; a < t.arity * (n + 1); ++a)
                force[t.ids[a]] += lambda * t.gradient[a];
        }
    }
};

}  // namespace plait
