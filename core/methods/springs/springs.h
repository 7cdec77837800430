// Constraints as springs of the potential U = C^2 / (2 alpha), for the methods of Stam 2009,
// section 4.2: the force f = -C grad C / alpha of every set. Constraints that do not act where C
// lies give none.
#pragma once

#include "../../constraints/constants.h"
#include "../../whole_step.h"

namespace plait {

template <class Real>
struct Springs {
    std::vector<Vec<Real>> force;    // N, by vertex
    std::vector<Terms<Real>> terms;  // by set, of the last call

    // f(x) where the substep began. With `curved`, second derivatives as well, of constraints of
    // one and two vertices. Returns the constraints evaluated.
    long atStart(WholeSubstep<Real>& s, bool curved = false) {
        swapStart(s.state);
        force.assign(s.state.particles.size(), {0, 0, 0});
        terms.resize(s.sets.size());
        long work = 0;
        for (std::size_t k = 0; k < s.sets.size(); ++k) {
            s.sets[k]->terms(s.state, false, terms[k]);
            if (curved && terms[k].arity <= 2) s.sets[k]->terms(s.state, true, terms[k]);
            work += terms[k].size();
            add(terms[k]);
        }
        swapStart(s.state);
        return work;
    }

private:
    // Between where the vertices are and where the substep began.
    static void swapStart(State<Real>& state) {
        for (std::size_t i = 0; i < state.particles.size(); ++i)
            std::swap(state.particles[i].d, state.before[i].v);
    }

    void add(const Terms<Real>& t) {
        for (int n = 0; n < t.size(); ++n) {
            if (!(t.compliance(n) < Real(slack))) continue;
            const Real lambda = -t.value[n] / t.compliance(n);
            for (int a = t.arity * n; a < t.arity * (n + 1); ++a)
                force[t.ids[a]] += lambda * t.gradient[a];
        }
    }
};

}  // namespace plait
