#include "newton.h"

#include "newton_equations.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace plait {
namespace {

class Newton : public WholeStep<double> {
public:
    explicit Newton(const SolverOptions& options)
        : midpoint_(options.integrator == Integrator::midpoint),
          substeps_(options.schedule.substeps),
          equations_(midpoint_) {}

    // Multipliers are kept from substep to substep, but not from frame to frame, so that a run that
    // is resumed has the same bits.
    long take(WholeSubstep<double>& s) override {
        work_ = 0;
        equations_.begin(s, s.state.substep % substeps_ == 0);
        if (!solve(s, 0) && !harden(s)) fail(s);
        if (midpoint_) setVelocities(s);
        return work_;
    }
    bool setsVelocities() const override { return midpoint_; }

private:
    [[noreturn]] void fail(const WholeSubstep<double>& s) const {
        char what[96];
        std::snprintf(what, sizeof what,
                      "found no solution (left: %.0e of the forces, %.0e of the size)",
                      equations_.unbalanced(s.state), equations_.apart());
        throw Diverged("newton", s.state.substep, what);
    }

    // Newton's iteration, until forces balance to 1e-12 or, from 1e-10 on, no longer come closer to
    // it. False: no progress, or too slow.
    bool solve(WholeSubstep<double>& s, double softness) {
        constexpr int most = 20;
        constexpr double sharp = 1e-12, enough = 1e-10;
        work_ += equations_.evaluate(s, softness);
        double before = 1;
        for (int k = 0; k < most; ++k) {
            const double left = equations_.unbalanced(s.state);
            if (equations_.solved(s.state, sharp)) return true;
            if (equations_.solved(s.state, enough) && left > before / 2) return true;
            before = left;
            equations_.linearise(s.state, matrix_, right_);
            if (!(midpoint_ ? step(lu_) : step(ldlt_)) || !search(s, softness)) break;
        }
        return equations_.solved(s.state, enough);
    }

    // Where Newton's iteration fails, all but singular equations (a flat sheet of rigid links) have
    // turned it round: the substep is solved with soft constraints first, and these hardened.
    bool harden(WholeSubstep<double>& s) {
        equations_.begin(s, true);
        constexpr double softest = 1, hardest = 1e-14;
        double softness = softest, factor = 0.1;
        if (!solve(s, softness)) return false;
        while (softness > 0) {
            const NewtonEquations::Unknowns last = equations_.unknowns(s.state);
            const double next = softness * factor > hardest ? softness * factor : 0;
            if (solve(s, next)) {
                softness = next;
                factor = std::max(factor * factor, 0.01);
            } else {
                equations_.restore(s.state, last);
                factor = std::sqrt(factor);
                if (factor > 0.9) return false;
            }
        }
        return true;
    }

    template <class Factors>
    bool step(Factors& factors) {
        if (fresh_) factors.analyzePattern(matrix_);
        fresh_ = false;
        factors.factorize(matrix_);
        if (factors.info() != Eigen::Success) return false;
        work_ += static_cast<long>(std::ceil(multiplications(factors) / multiplicationsOfALink));
        solution_ = factors.solve(right_);
        return solution_.allFinite();
    }

    // Of the factors and one solution with them.
    static double multiplications(const Eigen::SimplicialLDLT<NewtonEquations::Matrix>& factors) {
        const auto& l = factors.matrixL().nestedExpression();
        double sum = 0;
        for (Eigen::Index column = 0; column < l.cols(); ++column) {
            const double below = l.outerIndexPtr()[column + 1] - l.outerIndexPtr()[column];
            sum += below * (below + 7) / 2 + 1;
        }
        return sum;
    }
    // As if all columns of L were equally long, and all rows of U: at least.
    static double multiplications(const Eigen::SparseLU<NewtonEquations::Matrix>& factors) {
        const double l = double(factors.nnzL()), u = double(factors.nnzU());
        return l * u / double(factors.rows()) + l + u;
    }

    bool search(WholeSubstep<double>& s, double softness) {
        const double merit = equations_.merit(s.state);
        for (double part = 1; part > 1e-3; part /= 2) {
            equations_.move(s.state, solution_, part);
            work_ += equations_.evaluate(s, softness);
            if (equations_.merit(s.state) < (1 - 1e-4 * part) * merit ||
                equations_.rounded(s.state))
                return true;
        }
        return false;
    }

    // v = 2 (x - x0) / h - v0.
    static void setVelocities(WholeSubstep<double>& s) {
        State<double>& state = s.state;
        for (std::size_t i = 0; i < state.particles.size(); ++i) {
            const Vec<double> mean = (1 / s.h) * (state.particles[i].d - state.before[i].v);
            const bool moves = state.particles[i].w > 0;
            state.velocity[i].v = moves ? mean + (mean - state.lastVelocity[i].v) : mean;
        }
    }

    bool midpoint_;
    int substeps_;
    long work_ = 0;
    bool fresh_ = true;
    NewtonEquations equations_;
    NewtonEquations::Matrix matrix_;
    NewtonEquations::Vector right_, solution_;
    Eigen::SimplicialLDLT<NewtonEquations::Matrix> ldlt_;
    Eigen::SparseLU<NewtonEquations::Matrix> lu_;
};

}  // namespace

std::unique_ptr<WholeStep<double>> makeNewton(const SolverOptions& options,
                                              const std::vector<NamedSet<double>>& sets,
                                              const State<double>& state) {
    Terms<double> terms;
    for (const NamedSet<double>& named : sets) {
        named.set->terms(state, false, terms);
        for (int n = 0; n < terms.size(); ++n) {
            double weight = 0, mobility = 0;
            for (int a = terms.arity * n; a < terms.arity * (n + 1); ++a) {
                const double w = state.particles[terms.ids[a]].w;
                weight += w * dot(terms.gradient[a], terms.gradient[a]);
                mobility += w;
            }
            const bool rigid = terms.above[n] == 0 || terms.below[n] == 0;
            if (rigid && mobility > 0 && weight == 0)
                throw std::invalid_argument(
                    "method newton needs a gradient, and set " + named.name +
                    " is rigid and has none where it starts: give it a compliance, or take xpbd");
        }
    }
    return std::make_unique<Newton>(options);
}

}  // namespace plait
