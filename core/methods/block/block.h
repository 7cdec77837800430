// Vertex block descent (Chen, Liu, Yang, Yuksel 2024), and augmented vertex block descent (Giles,
// Diaz, Yuksel 2025) for what is rigid. Implicit Euler as the minimum of
//
//   G(x) = |x - y|^2_M / 2 h^2 + sum over constraints of (k C^2 / 2 + lambda C)
//
// over one vertex after another, coloured so that no two of a colour share a constraint. A vertex
// takes one Newton step (VBD Eq. 4 to 8, AVBD Eq. 13 and 17):
//
//   (M / h^2 + sum of k g g^T + G) dx = M / h^2 (y - x) - sum of (k C + lambda) g
//
// G, diagonal, has the lengths of the columns of |k C + lambda| grad g: positive definite where the
// true Hessian need not be (AVBD section 3.5). Where a compliance alpha is above 0, k = 1 / alpha
// and lambda = 0. Else, after every sweep over all vertices, lambda <- k C + lambda (AVBD Eq. 11)
// and k <- k + beta |C| (Eq. 16). A one-sided constraint gives nothing where k C + lambda pulls.
// Before that a palindrome sweeps back as well, as it does for constraints.
//
// Not from the papers: x starts at y. lambda and k start anew in every substep, since a run that
// was stopped must go on with the same bits; k at the weight of the vertices, beta by that and by
// what C was, where the papers' constants have units that fit one scene (Eq. 16, 19). No error is
// held back (Eq. 18), no Chebyshev acceleration, no friction.
//
// Fails, slowly, where stiffnesses differ (validation B, primal against dual); what a long chain
// has to be told goes one vertex a sweep; momentum is kept only by what has converged; and rigid
// sheets that buckle within a substep need not converge at all. Serial.
#pragma once

#include "../../constraints/constants.h"
#include "../../whole_step.h"
#include "vertex_block.h"
#include "vertex_colors.h"

namespace plait {

template <class Real>
class Block : public WholeStep<Real> {
public:
    // The vertices that the constraints of `sets` join must stay the same.
    Block(const std::vector<NamedSet<Real>>& sets, const State<Real>& state) {
        std::vector<SetStencils> stencils;
        std::vector<unsigned char> pinned;
        for (const NamedSet<Real>& named : sets) {
            named.set->terms(state, false, terms_);
            stencils.push_back({terms_.arity, terms_.ids});
        }
        for (const Particle<Real>& p : state.particles) pinned.push_back(p.w == Real(0));
        colors_ = vertexColors(stencils, pinned);
    }

    long take(WholeSubstep<Real>& s) override {
        long work = prepare(s);
        const bool turn = s.sweeps == Sweeps::alternating && s.state.substep % 2 == 1;
        for (int column = 0; column < s.columns; ++column) {
            work += sweep(s, turn);  // primal
            if (s.sweeps == Sweeps::palindrome) work += sweep(s, true);
            work += raise(s);  // dual
        }
        return work;
    }

private:
    // k grows by as much, as a part of the weight of its vertices, for every |C| as large as that
    // of the prediction. More helps where masses differ and takes energy where they do not.
    static constexpr double growth = 0.1;

    // What is kept of a constraint that is rigid on either side; stiffness 0 on neither.
    struct Dual {
        Real lambda, stiffness;  // N, N/m
        Real start, growth;      // |C| of the prediction; N/m
    };
    struct Force {
        Real size, stiffness;  // along -grad C
        bool rigid;
    };

    long prepare(WholeSubstep<Real>& s) {
        long work = 0;
        inverseH2_ = static_cast<Real>(1 / (s.implied * s.implied));
        goal_.clear();
        for (const Particle<Real>& p : s.state.particles) goal_.push_back(p.d);
        duals_.resize(s.sets.size());
        for (std::size_t set = 0; set < s.sets.size(); ++set) {
            s.sets[set]->terms(s.state, false, terms_);
            work += terms_.size();
            duals_[set].clear();
            bool anyRigid = false;
            for (int n = 0; n < terms_.size(); ++n) {
                const bool rigid = terms_.rigid(n);
                const Real k = rigid ? weight(s.state, n) : Real(0);
                duals_[set].push_back({0, k, absolute(terms_.value[n]), Real(growth) * k});
                anyRigid = anyRigid || rigid;
            }
            if (!anyRigid) duals_[set].clear();
        }
        force_.resize(goal_.size());
        hessian_.resize(goal_.size());
        return work;
    }

    // How heavy constraint n is: 1 / (h^2 times the sum of w |g|^2), in N/m.
    Real weight(const State<Real>& state, int n) const {
        Real sum = 0;
        for (int i = terms_.arity * n; i < terms_.arity * (n + 1); ++i)
            sum += state.particles[terms_.ids[i]].w * dot(terms_.gradient[i], terms_.gradient[i]);
        return divide(inverseH2_, sum);
    }

    // Every vertex once. Returns the constraints evaluated.
    long sweep(WholeSubstep<Real>& s, bool back) {
        long work = 0;
        for (std::size_t c = 0; c < colors_.size(); ++c)
            work += move(s, colors_[back ? colors_.size() - 1 - c : c]);
        return work;
    }

    // One Newton step of every vertex of a colour. Returns the constraints evaluated.
    long move(WholeSubstep<Real>& s, const VertexColor& color) {
        long work = 0;
        for (const int v : color.vertices) {
            const Particle<Real>& p = s.state.particles[v];
            const Real inertia = divide(inverseH2_, p.w);
            force_[v] = inertia * (goal_[v] - p.d);
            hessian_[v] = Symmetric<Real>::diagonal(inertia);
        }
        for (std::size_t k = 0; k < s.sets.size(); ++k) {
            const VertexColor::Share& share = color.sets[k];
            if (share.constraints.empty()) continue;
            s.sets[k]->termsOf(share.constraints, s.state, true, terms_);
            work += terms_.size();
            for (int n = 0; n < terms_.size(); ++n)
                add(n, share.corners[n],
                    forceOf(n, duals_[k].empty() ? nullptr : &duals_[k][share.constraints[n]]));
        }
        for (const int v : color.vertices) s.state.particles[v].d += hessian_[v].solve(force_[v]);
        return work;
    }

    // The force of constraint n of terms_.
    Force forceOf(int n, const Dual* dual) const {
        const Real c = terms_.value[n];
        const Real size = dual && dual->stiffness > 0 ? dual->stiffness * c + dual->lambda : c;
        const Real compliance = terms_.compliance(n, size);
        if (compliance == Real(0)) return {size, dual->stiffness, true};
        if (!(compliance < Real(slack))) return {0, 0, false};
        return {c / compliance, 1 / compliance, false};
    }

    // Constraint n of terms_, at its vertex a.
    void add(int n, int a, const Force& f) {
        const int v = terms_.ids[terms_.arity * n + a];
        const Vec<Real>& g = terms_.gradient[terms_.arity * n + a];
        force_[v] -= f.size * g;
        hessian_[v].addOuter(f.stiffness, g);
        const Symmetric<Real> c = vertexBlock(terms_, n, a);
        const Real size = absolute(f.size);
        hessian_[v].xx += size * length(Vec<Real>{c.xx, c.xy, c.xz});
        hessian_[v].yy += size * length(Vec<Real>{c.xy, c.yy, c.yz});
        hessian_[v].zz += size * length(Vec<Real>{c.xz, c.yz, c.zz});
    }

    // The dual step: multipliers and stiffnesses of what is rigid. Returns the constraints
    // evaluated.
    long raise(WholeSubstep<Real>& s) {
        long work = 0;
        for (std::size_t k = 0; k < s.sets.size(); ++k) {
            if (duals_[k].empty()) continue;
            s.sets[k]->terms(s.state, false, terms_);
            work += terms_.size();
            for (int n = 0; n < terms_.size(); ++n) {
                Dual& dual = duals_[k][n];
                const Force f = forceOf(n, &dual);
                dual.lambda = f.rigid ? f.size : Real(0);
                const Real part = divide(absolute(terms_.value[n]), dual.start);
                if (f.rigid) dual.stiffness += (part < Real(1) ? part : Real(1)) * dual.growth;
            }
        }
        return work;
    }

    static Real absolute(Real a) { return a < Real(0) ? -a : a; }

    std::vector<VertexColor> colors_;
    std::vector<std::vector<Dual>> duals_;  // by set; empty where nothing is rigid
    Real inverseH2_ = 0;                    // 1/s^2
    std::vector<Vec<Real>> goal_;           // y, as d
    std::vector<Vec<Real>> force_;          // N, by vertex
    std::vector<Symmetric<Real>> hessian_;  // N/m
    Terms<Real> terms_;
};

}  // namespace plait
