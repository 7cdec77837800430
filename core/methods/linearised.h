// The alternative that Stam 2009, section 5, tried first and gave up: all constraints at once, made
// linear where the prediction has the vertices, and solved in the sense of least squares.
//
//   C(x + h v) + grad C(x + h v) h dv = 0,   A u = b  by LSQR (Paige and Saunders 1982)
//
// In u = W^(-1/2) dx the solution of least norm moves mass least, and keeps momentum. A compliance
// alpha is one more unknown z of a constraint, in grad C dx + sqrt(a) z = -C with a = alpha / h^2:
// that is the linear system of XPBD (2016, Eq. 18), solved as a whole. Rows are scaled to length 1,
// so that metres and radians weigh alike. One-sided constraints, contacts among them, take part
// where the prediction violates them, and then as if two-sided.
//
// Good to second order in how far a constraint turns in a substep. At large rotations the result
// is further off than the prediction was, and nothing is done about it.
#pragma once

#include "../constraints/constants.h"
#include "../whole_step.h"

#include <cmath>
#include <type_traits>

namespace plait {

template <class Real>
class Linearised : public WholeStep<Real> {
public:
    long take(WholeSubstep<Real>& s) override {
        start_.assign(1, 0);
        ids_.clear(), row_.clear(), soft_.clear(), left_.clear();
        for (const auto& set : s.sets) {
            set->terms(s.state, false, terms_);
            addRows(s);
        }
        solution_.v.assign(s.state.particles.size(), {0, 0, 0});
        solution_.z.assign(soft_.size(), 0);
        const long passes = solve();
        for (std::size_t i = 0; i < solution_.v.size(); ++i)  // dx = W^(1/2) u
            s.state.particles[i].d += squareRoot(s.state.particles[i].w) * solution_.v[i];
        return static_cast<long>(left_.size()) * (1 + passes);
    }

private:
    static constexpr double tolerance = std::is_same_v<Real, double> ? 1e-12 : 1e-6;
    // On sheets, whose flatness leaves directions that hardly change any constraint, it ends here.
    static constexpr int maxIterations = 500;

    struct Unknowns {
        std::vector<Vec<Real>> v;  // by vertex
        std::vector<Real> z;       // by constraint
    };

    void addRows(const WholeSubstep<Real>& s) {
        const Terms<Real>& t = terms_;
        const Real inverseH2 = static_cast<Real>(1 / (s.implied * s.implied));
        for (int n = 0; n < t.size(); ++n) {
            const bool acts = t.compliance(n) < Real(slack);
            const Real a = acts ? t.compliance(n) * inverseH2 : Real(0);
            Real norm2 = a;
            for (int i = t.arity * n; i < t.arity * (n + 1); ++i)
                norm2 += s.state.particles[t.ids[i]].w * dot(t.gradient[i], t.gradient[i]);
            const Real scale = acts ? divide(Real(1), squareRoot(norm2)) : Real(0);
            for (int i = t.arity * n; i < t.arity * (n + 1); ++i) {
                ids_.push_back(t.ids[i]);
                row_.push_back((scale * squareRoot(s.state.particles[t.ids[i]].w)) * t.gradient[i]);
            }
            start_.push_back(static_cast<int>(ids_.size()));
            soft_.push_back(scale * squareRoot(a));
            left_.push_back(-scale * t.value[n]);
        }
    }

    // Paige and Saunders' letters, but left_ for their u. Returns how often A and A^T were passed.
    int solve() {
        const double start = normalise(left_);
        double beta = start, phi = start;
        v_.v.assign(solution_.v.size(), {0, 0, 0});
        v_.z.assign(solution_.z.size(), 0);
        double alpha = bidiagonalise(beta), rho = alpha;
        w_ = v_;
        int i = 0;
        while (alpha > 0 && phi > tolerance * start && i < maxIterations) {
            ++i;
            beta = applyTo(alpha);
            alpha = bidiagonalise(beta);
            const double length = std::sqrt(rho * rho + beta * beta);
            const double c = rho / length, sine = beta / length;
            combine(1, solution_, c * phi / length, w_);
            combine(-sine * alpha / length, w_, 1, v_);
            rho = -c * alpha;
            phi *= sine;
            if (alpha * std::fabs(c) <= tolerance) break;  // A^T r / (|A| |r|)
        }
        return i;
    }

    // u <- (A v - alpha u) / beta; returns beta.
    double applyTo(double alpha) {
        for (std::size_t n = 0; n < left_.size(); ++n) {
            Real sum = soft_[n] * v_.z[n];
            for (int i = start_[n]; i < start_[n + 1]; ++i) sum += dot(row_[i], v_.v[ids_[i]]);
            left_[n] = sum - static_cast<Real>(alpha) * left_[n];
        }
        return normalise(left_);
    }

    // v <- (A^T u - beta v) / alpha; returns alpha.
    double bidiagonalise(double beta) {
        const Real b = static_cast<Real>(beta);
        for (Vec<Real>& v : v_.v) v = -b * v;
        for (std::size_t n = 0; n < left_.size(); ++n) {
            v_.z[n] = soft_[n] * left_[n] - b * v_.z[n];
            for (int i = start_[n]; i < start_[n + 1]; ++i) v_.v[ids_[i]] += left_[n] * row_[i];
        }
        double square = 0;
        for (const Vec<Real>& v : v_.v) square += double(dot(v, v));
        for (const Real z : v_.z) square += double(z) * double(z);
        const double alpha = std::sqrt(square);
        if (alpha > 0) combine(1 / alpha, v_, 0, v_);
        return alpha;
    }

    static double normalise(std::vector<Real>& u) {
        double square = 0;
        for (const Real n : u) square += double(n) * double(n);
        const double norm = std::sqrt(square);
        if (norm > 0)
            for (Real& n : u) n *= static_cast<Real>(1 / norm);
        return norm;
    }

    // to <- a to + b from
    static void combine(double a, Unknowns& to, double b, const Unknowns& from) {
        const Real ra = static_cast<Real>(a), rb = static_cast<Real>(b);
        for (std::size_t i = 0; i < to.v.size(); ++i) to.v[i] = ra * to.v[i] + rb * from.v[i];
        for (std::size_t i = 0; i < to.z.size(); ++i) to.z[i] = ra * to.z[i] + rb * from.z[i];
    }

    Terms<Real> terms_;
    std::vector<int> start_, ids_;  // vertices of row n: ids_[start_[n]] to ids_[start_[n + 1]]
    std::vector<Vec<Real>> row_;    // the entries of A there
    std::vector<Real> soft_;        // and that of z
    std::vector<Real> left_;        // b, then u of the bidiagonalisation
    Unknowns solution_, v_, w_;
};

}  // namespace plait
