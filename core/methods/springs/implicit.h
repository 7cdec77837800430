// Implicit Euler with one Newton step (Baraff and Witkin, "Large steps in cloth simulation", 1998,
// Eq. 6): every constraint is a spring, linearised where the substep began.
//
//   (M - h^2 K) dv = h (f + h K v),  K = df/dx = -(g g^T + C grad g) / alpha,  g = grad C
//
// v has the external forces in it already, which takes them from f. In u = h dv this is
// (M / h^2 - K) u = f + K p, with p the predicted step. It is solved by their modified conjugate
// gradients (section 5.2): what is pinned is filtered out and keeps its step.
//
// The system must be positive definite. g g^T is; C grad g is where a distance, which is a convex
// function, is too long. Elsewhere, in compression and for angles, it is left out, as is usual
// (Choi and Ko 2002).
//
// Stable at any h, but a mode of frequency omega keeps only (1 + h^2 omega^2)^(-1/2) of its
// amplitude in every substep, wanted or not (validation A0); and one Newton step does not solve the
// implicit equation: what turns far in a substep comes out stretched.
#pragma once

#include "../block/vertex_block.h"
#include "springs.h"

#include <type_traits>

namespace plait {

template <class Real>
class Implicit : public WholeStep<Real> {
public:
    long take(WholeSubstep<Real>& s) override {
        const long work = springs_.atStart(s, true);  // f and K
        const std::size_t n = springs_.force.size();
        inertia_.resize(n), step_.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const Particle<Real>& p = s.state.particles[i];
            inertia_[i] = divide(static_cast<Real>(1 / (s.h * s.h)), p.w);  // 0 where pinned
            step_[i] = p.d - s.state.before[i].v;
        }
        residual_ = springs_.force;
        addStiffness(step_, residual_);  // f + K p
        makePreconditioner();
        return work + solve(s.state);
    }

private:
    static constexpr double tolerance = std::is_same_v<Real, double> ? 1e-12 : 1e-6;
    static constexpr int maxIterations = 2000;
    using Vectors = std::vector<Vec<Real>>;

    // Conjugate gradients, until the residual in the norm of the inverse preconditioner is
    // `tolerance` of what it was. Adds u to d. Returns the constraints passed.
    long solve(State<Real>& state) {
        long work = 0;
        precondition();
        Vectors& c = direction_ = preconditioned_;
        double rz = dotOf(residual_, preconditioned_);
        const double enough = rz * tolerance * tolerance;
        for (int i = 0; rz > enough && i < maxIterations; ++i) {
            image_.resize(c.size());
            for (std::size_t k = 0; k < c.size(); ++k) image_[k] = -inertia_[k] * c[k];
            work += addStiffness(c, image_);  // -A c
            const double slope = -dotOf(c, image_);
            if (!(slope > 0)) break;
            const Real a = static_cast<Real>(rz / slope);
            for (std::size_t k = 0; k < c.size(); ++k) {
                state.particles[k].d += a * c[k];
                residual_[k] += a * image_[k];
            }
            precondition();
            const double next = dotOf(residual_, preconditioned_);
            const Real b = static_cast<Real>(next / rz);
            for (std::size_t k = 0; k < c.size(); ++k) c[k] = preconditioned_[k] + b * c[k];
            rz = next;
        }
        return work;
    }

    // to += K v. Returns the constraints passed.
    long addStiffness(const Vectors& v, Vectors& to) const {
        long work = 0;
        for (const Terms<Real>& t : springs_.terms) {
            work += t.size();
            for (int n = 0; n < t.size(); ++n) {
                if (!(t.compliance(n) < Real(slack))) continue;
                const Real k = 1 / t.compliance(n);
                const int* const ids = &t.ids[t.arity * n];
                const Vec<Real>* const g = &t.gradient[t.arity * n];
                Real rate = 0;
                for (int a = 0; a < t.arity; ++a) rate += dot(g[a], v[ids[a]]);
                for (int a = 0; a < t.arity; ++a) to[ids[a]] -= (k * rate) * g[a];
                if (!bends(t, n)) continue;
                for (int a = 0; a < t.arity; ++a)
                    for (int b = 0; b < t.arity; ++b)
                        to[ids[a]] -= (k * t.value[n]) * product(t, n, a, b, v[ids[b]]);
            }
        }
        return work;
    }

    // The geometric part counts.
    static bool bends(const Terms<Real>& t, int n) {
        return !t.curvature.empty() && t.value[n] > Real(0);
    }

    static Vec<Real> product(const Terms<Real>& t, int n, int a, int b, const Vec<Real>& v) {
        const Real* const x = t.block(n, a, b);
        const Real* const y = x + 3 * t.arity;
        const Real* const z = y + 3 * t.arity;
        return {x[0] * v.x + x[1] * v.y + x[2] * v.z, y[0] * v.x + y[1] * v.y + y[2] * v.z,
                z[0] * v.x + z[1] * v.y + z[2] * v.z};
    }

    // The blocks of single vertices in M / h^2 - K.
    void makePreconditioner() {
        diagonal_.resize(inertia_.size());
        for (std::size_t i = 0; i < inertia_.size(); ++i)
            diagonal_[i] = Symmetric<Real>::diagonal(inertia_[i]);
        for (const Terms<Real>& t : springs_.terms)
            for (int n = 0; n < t.size(); ++n) {
                if (!(t.compliance(n) < Real(slack))) continue;
                const Real k = 1 / t.compliance(n);
                for (int a = 0; a < t.arity; ++a) {
                    Symmetric<Real>& d = diagonal_[t.ids[t.arity * n + a]];
                    d.addOuter(k, t.gradient[t.arity * n + a]);
                    if (bends(t, n)) d.add(k * t.value[n], vertexBlock(t, n, a));
                }
            }
    }

    void precondition() {
        preconditioned_.resize(residual_.size());
        for (std::size_t i = 0; i < residual_.size(); ++i)
            preconditioned_[i] =
                inertia_[i] > Real(0) ? diagonal_[i].solve(residual_[i]) : Vec<Real>{0, 0, 0};
    }

    static double dotOf(const Vectors& a, const Vectors& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += double(dot(a[i], b[i]));
        return sum;
    }

    Springs<Real> springs_;
    std::vector<Real> inertia_;              // M / h^2, kg/s^2
    std::vector<Symmetric<Real>> diagonal_;  // N/m
    Vectors step_, residual_, preconditioned_, direction_, image_;
};

}  // namespace plait
