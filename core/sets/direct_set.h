// A set of constraints of two vertices each that form chains and trees, solved all at once: an
// evaluation is one Newton step, exact and in O(N). It is the same forward and backward.
#pragma once

#include "../constraint.h"
#include "../constraints/constants.h"
#include "../constraints/moving_rows.h"
#include "../numbers/convert.h"
#include "forest.h"
#include "tree_solve.h"

#include <algorithm>

namespace plait {

// Inside all is double. Smoothing leaves the set alone, since it leaves no error to spread. Links
// without compliance that contradict each other (two pins further apart than the chain is long)
// have no solution: what they do is finite, and that is all; give them compliance.
template <class Kind, class Real>
class DirectSet : public Constraint<Real> {
    static_assert(Kind::arity == 2, "a direct solve is for kinds that join two vertices");

public:
    // `pinned`, by vertex: 1 where the inverse mass is zero. Throws std::invalid_argument for the
    // first constraint that closes a cycle of vertices that move.
    DirectSet(Rows<Kind> set, std::span<const unsigned char> pinned)
        : DirectSet(std::make_shared<const Rows<Kind>>(std::move(set)), pinned) {}
    DirectSet(SharedRows<Kind> set, std::span<const unsigned char> pinned)
        : set_(std::move(set)),
          rows_(set_->rows),
          moving_(*set_),
          forest_(forestOf(set_->ids, pinned)),
          nodes_(forest_.nodes.size()),
          lambda_(rows_.size(), 0) {
        for (std::size_t k = 0; k < nodes_.size(); ++k) nodes_[k].parent = forest_.nodes[k].parent;
    }

    void beginFrame(double t0, double t1) override { moving_.beginFrame(t0, t1); }

    void begin(const Substep& substep, Workers& workers) override {
        std::fill(lambda_.begin(), lambda_.end(), 0);
        fresh_ = true;
        if (!moving_) return;
        workers.forBlocks(static_cast<int>(size()), 1024, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) rows_[i] = moving_.at(i, substep.frameFraction);
        });
    }

    void project(const Sweep<Real>& sweep, Direction, Workers& workers) override {
        const double inverseH2 = double(sweep.inverseH2);
        forTrees(workers, [&](int begin, int end) {
            const double size = load(sweep, begin, end);
            for (int k = begin; k < end - 1; ++k) {
                // Multipliers that are zero because the substep has just begun say nothing of which
                // links pull, nor does C, which only one of them may have been predicted to break.
                const double s = fresh_ ? 1 : nodes_[k].c - nodes_[k].weight * nodes_[k].lambda;
                nodes_[k].a = softness(k, s, inverseH2);
            }
            solve(begin, end, inverseH2);
            const double strength = double(sweep.strength) * bounded(size, begin, end);
            for (int k = begin; k < end - 1; ++k)
                lambda_[forest_.nodes[k].constraint] =
                    nodes_[k].a < slack ? nodes_[k].lambda + strength * nodes_[k].change : 0;
            move(sweep.particles + 4, 8, strength, begin, end);
        });
        fresh_ = false;
    }

    // All rates at once, so that each loses exactly the part sweep.strength.
    void damp(const Sweep<Real>& sweep, Workers& workers) override {
        const auto rate = [&](int k, const Vec<double>& gradient) {
            return dot(gradient, three(sweep.out + 4 * forest_.nodes[k].vertex));
        };
        forTrees(workers, [&](int begin, int end) {
            load(sweep, begin, end);
            for (int k = begin; k < end - 1; ++k) {
                TreeNode<double>& n = nodes_[k];
                n.a = softness(k, n.c - n.weight * n.lambda, 0);
                n.c = rate(k, n.own) + rate(n.parent, n.up);
                n.lambda = 0;
            }
            solveTree(nodes_, begin, end);
            move(sweep.out, 4, double(sweep.strength), begin, end);
        });
    }

    bool termsOf(std::span<const int> which, const State<Real>& state, bool curved,
                 Terms<Real>& out) const override {
        setTerms<Kind>(out, set_->ids, which, curved, state,
                       [&](int i) { return narrow<Kind, Real>(rows_[i]); });
        return true;
    }

    long size() const override { return static_cast<long>(rows_.size()); }

    // Lagrange multiplier of constraint i, of the substep last taken; force along the gradient is
    // multiplier / h^2.
    double multiplier(int i) const { return lambda_[i]; }

private:
    // Trees share no vertex that moves.
    template <class Body>
    void forTrees(Workers& workers, const Body& body) {
        workers.forBlocks(forest_.trees(), 16, [&](int first, int last) {
            for (int t = first; t < last; ++t) body(forest_.start[t], forest_.start[t + 1]);
        });
    }

    // Parents first: the weight needs the w of both ends. Returns the length of all links of
    // the tree and of what they lack, in m.
    double load(const Sweep<Real>& sweep, int begin, int end) {
        double size = 0;
        for (int k = end - 1; k >= begin; --k) {
            const Forest::Node& node = forest_.nodes[k];
            TreeNode<double>& n = nodes_[k];
            const Real* const p = sweep.particles + 8 * node.vertex;
            n.w = double(p[3]);
            if (node.parent < 0) continue;
            const TreeNode<double>& parent = nodes_[node.parent];
            const Real* const o = sweep.particles + 8 * forest_.nodes[node.parent].vertex;
            const Vec<double> apart = (three(p) - three(o)) + (three(p + 4) - three(o + 4));
            Stencil<Vec<double>, 2> gradient;
            n.c = Kind::evaluate(rows_[node.constraint], {{{}, node.end == 1 ? apart : -apart}},
                                 gradient);
            n.own = gradient[node.end];
            n.up = gradient[1 - node.end];
            n.lambda = double(sweep.keep) * lambda_[node.constraint];
            n.weight = dot(n.own, n.w * n.own) + dot(n.up, parent.w * n.up);
            size += length(apart) + (n.c < 0 ? -n.c : n.c);
        }
        return size;
    }

    // Compliance / h^2 on the side of C where s, the C that would be without this constraint, lies.
    double softness(int k, double s, double inverseH2) const {
        const double compliance = Kind::compliance(rows_[forest_.nodes[k].constraint], s);
        return compliance < slack ? compliance * inverseH2 : slack;
    }

    // Which links pull and which are slack depends on the solution: solved again until the two
    // agree (primal-dual active sets, Hintermüller et al. 2003). Links alike on both sides need one
    // round.
    void solve(int begin, int end, double inverseH2) {
        constexpr int rounds = 16;  // 12 were seen, in chains of 10 to 10,000 links bent at random
        for (int round = 1;; ++round) {
            solveTree(nodes_, begin, end);
            if (round == rounds || !changeSides(begin, end, inverseH2)) return;
        }
    }

    // True if the solution lies on another side of any link than the one it was found for.
    bool changeSides(int begin, int end, double inverseH2) {
        bool changed = false;
        for (int k = begin; k < end - 1; ++k) {
            TreeNode<double>& n = nodes_[k];
            const TreeNode<double>& parent = nodes_[n.parent];
            const double c =
                n.c + dot(n.own, n.w * n.impulse) + dot(n.up, parent.w * parent.impulse);
            const double a = softness(k, c - n.weight * (n.lambda + n.change), inverseH2);
            changed |= a != n.a;
            n.a = a;
        }
        return changed;
    }

    // The part of the step to take: no vertex goes further than the tree is long. A contradiction
    // that is all but straight would else throw it millions of metres; no sound step is so long.
    double bounded(double size, int begin, int end) const {
        double furthest = 0;
        for (int k = begin; k < end; ++k)
            furthest = std::max(furthest, length(nodes_[k].w * nodes_[k].impulse));
        return furthest > size ? size / furthest : 1;
    }

    // Adds strength w impulse to the three numbers of each vertex that moves.
    void move(Real* to, int stride, double strength, int begin, int end) const {
        for (int k = begin; k < end; ++k) {
            const TreeNode<double>& n = nodes_[k];
            if (n.w == 0) continue;
            const Vec<double> d = strength * (n.w * n.impulse);
            Real* const v = to + stride * forest_.nodes[k].vertex;
            v[0] = static_cast<Real>(double(v[0]) + d.x);
            v[1] = static_cast<Real>(double(v[1]) + d.y);
            v[2] = static_cast<Real>(double(v[2]) + d.z);
        }
    }

    SharedRows<Kind> set_;
    std::vector<typename Kind::template Row<double>> rows_;
    MovingRows<Kind> moving_;
    Forest forest_;
    std::vector<TreeNode<double>> nodes_;
    std::vector<double> lambda_;  // by constraint
    bool fresh_ = true;           // no evaluation yet in this substep
};

}  // namespace plait
