// A set of sums, each with one multiplier: gradients are gathered vertex by vertex in the order of
// the elements, so that an evaluation is one orthogonal projection however many elements there are.
// Sums are evaluated in their order, or backward in the reverse.
#pragma once

#include "../constraint.h"
#include "../constraints/constants.h"
#include "../numbers/convert.h"
#include "sums.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace plait {

// Inside all is double. Elements of an anchored kind are measured from the first vertex of their
// sum in place of their origin: of use only where C does not depend on it. Smoothing leaves the set
// alone. Other methods than sweeps do not see into it.
template <class Kind, class Real>
class SumSet : public Constraint<Real> {
public:
    explicit SumSet(std::shared_ptr<const Sums<Kind>> sums)
        : sums_(std::move(sums)), laws_(sums_->laws) {
        for (int g = 0; g < sums_->size(); ++g) layOut(g);
        lambda_.resize(laws_.size());
    }

    void beginFrame(double t0, double t1) override {
        from_ = t0;
        to_ = t1;
    }
    void begin(const Substep& substep, Workers&) override {
        std::fill(lambda_.begin(), lambda_.end(), 0);
        time_ = from_ + substep.frameFraction * (to_ - from_);
        fresh_ = true;
    }

    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override {
        if (fresh_ && sums_->law) askLaws(sweep, workers);
        fresh_ = false;
        for (int i = 0; i < sums_->size(); ++i) {
            const int g = direction == Direction::forward ? i : sums_->size() - 1 - i;
            const double c = evaluate(g, sweep, sweep.particles + 4, 8, workers);
            const double weight = weigh(g, sweep, workers);
            const SumLaw& law = laws_[g];
            const double lambda = double(sweep.keep) * lambda_[g];
            const double lacks = law.softness * (double(sweep.inverseH2) * lambda - law.load) +
                                 law.stiffness * (c - law.rest);
            const double per = law.softness * double(sweep.inverseH2) + law.stiffness * weight;
            const double change =
                per > 0 ? bounded(g, -double(sweep.strength) * lacks / per, workers) : 0;
            lambda_[g] = lambda + change;
            move(g, sweep.particles + 4, 8, change, workers);
        }
    }

    void damp(const Sweep<Real>& sweep, Workers& workers) override {
        for (int g = 0; g < sums_->size(); ++g) {
            evaluate(g, sweep, sweep.particles + 4, 8, workers);
            const double weight = weigh(g, sweep, workers);
            const Group& group = groups_[g];
            const double rate = sumOf(group.size(), workers, [&](int v) {
                return dot(gradient_[v], three(sweep.out + 4 * group.vertices[v]));
            });
            if (weight > 0) move(g, sweep.out, 4, -double(sweep.strength) * rate / weight, workers);
        }
    }

    long size() const override { return static_cast<long>(sums_->elements.size()); }

    // Lagrange multiplier of sum i, of the substep last taken; the force along its gradient is
    // multiplier / h^2.
    double multiplier(int i) const { return lambda_[static_cast<std::size_t>(i)]; }
    const SumLaw& law(int i) const { return laws_[static_cast<std::size_t>(i)]; }  // likewise

private:
    static constexpr int arity = Kind::arity;
    static constexpr int block = 256;  // of elements or vertices whose sums are added up as one

    // Which vertices a sum has, and which corners meet in each.
    struct Group {
        int first, last;            // elements
        std::vector<int> vertices;  // ascending
        std::vector<int> corners;   // places in `vertices`, arity an element
        std::vector<int> start;     // by vertex and one more: its first in `of`
        std::vector<int> of;        // corners by vertex, ascending
        int size() const { return static_cast<int>(vertices.size()); }
    };

    void layOut(int g) {
        Group& group = groups_.emplace_back();
        group.first = sums_->start[g];
        group.last = sums_->start[g + 1];
        const auto ids = std::span(sums_->elements.ids)
                             .subspan(std::size_t(group.first) * arity,
                                      std::size_t(group.last - group.first) * arity);
        group.vertices.assign(ids.begin(), ids.end());
        std::ranges::sort(group.vertices);
        group.vertices.erase(std::unique(group.vertices.begin(), group.vertices.end()),
                             group.vertices.end());
        group.start.assign(group.vertices.size() + 1, 0);
        for (const int id : ids) {
            const auto at = std::ranges::lower_bound(group.vertices, id) - group.vertices.begin();
            group.corners.push_back(static_cast<int>(at));
            ++group.start[at + 1];
        }
        for (int v = 0; v < group.size(); ++v) group.start[v + 1] += group.start[v];
        group.of.resize(ids.size());
        std::vector<int> next(group.start.begin(), group.start.end() - 1);
        for (int c = 0; c < static_cast<int>(ids.size()); ++c)
            group.of[next[group.corners[c]]++] = c;
        x_.resize(std::max(x_.size(), group.vertices.size()));
        gradient_.resize(x_.size());
        response_.resize(x_.size());
        slopes_.resize(std::max(slopes_.size(), ids.size()));
        partial_.resize((std::max(x_.size(), slopes_.size()) + block - 1) / block);
    }

    // Values joined to 0, in blocks and then in the order of these.
    template <class Value, class Join>
    double joined(int count, Workers& workers, const Value& value, const Join& join) {
        const int blocks = (count + block - 1) / block;
        workers.forBlocks(blocks, 1, [&](int begin, int end) {
            for (int b = begin; b < end; ++b) {
                double all = 0;
                for (int i = b * block; i < std::min(count, (b + 1) * block); ++i)
                    all = join(all, value(i));
                partial_[b] = all;
            }
        });
        double all = 0;
        for (int b = 0; b < blocks; ++b) all = join(all, partial_[b]);
        return all;
    }
    template <class Value>
    double sumOf(int count, Workers& workers, const Value& value) {
        return joined(count, workers, value, [](double a, double b) { return a + b; });
    }
    double longest(const std::vector<Vec<double>>& of, int count, Workers& workers) {
        return squareRoot(joined(
            count, workers, [&](int v) { return dot(of[v], of[v]); },
            [](double a, double b) { return a > b ? a : b; }));
    }

    // C of sum g where its vertices are at x + d, with its elements' gradients; d of one is
    // `stride` numbers from that of the next.
    double evaluate(int g, const Sweep<Real>& sweep, const Real* d, int stride, Workers& workers) {
        const Group& group = groups_[g];
        if (group.vertices.empty()) return 0;
        const auto at = [&](int v) {
            return std::array{three(sweep.particles + 8 * group.vertices[v]),
                              three(d + stride * group.vertices[v])};
        };
        const auto apex = at(0);
        workers.forBlocks(group.size(), block, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                const auto [x, moved] = at(v);
                x_[v] = (x - apex[0]) + (moved - apex[1]);
            }
        });
        return sumOf(group.last - group.first, workers, [&](int e) {
            Stencil<Vec<double>, arity> x, slope;
            const int* const corner = &group.corners[e * arity];
            for (int a = 0; a < arity; ++a) x[a] = x_[corner[a]];
            if constexpr (!anchored<Kind>)
                for (int a = arity - 1; a >= 0; --a) x[a] -= x[0];
            const double c = Kind::evaluate(sums_->elements.rows[group.first + e], x, slope);
            for (int a = 0; a < arity; ++a) slopes_[e * arity + a] = slope[a];
            return c;
        });
    }

    // Gathers the gradient; returns what it weighs, g W g.
    double weigh(int g, const Sweep<Real>& sweep, Workers& workers) {
        const Group& group = groups_[g];
        return sumOf(group.size(), workers, [&](int v) {
            Vec<double> sum{0, 0, 0};
            for (int c = group.start[v]; c < group.start[v + 1]; ++c) sum += slopes_[group.of[c]];
            const double w = double(sweep.particles[8 * group.vertices[v] + 3]);
            gradient_[v] = sum;
            response_[v] = w * sum;
            return dot(sum, response_[v]);
        });
    }

    // The part of a change to make: no vertex goes further than the sum is wide. What has all but
    // collapsed would else be thrown a million times its size; no sound step is so long.
    double bounded(int g, double change, Workers& workers) {
        const double size = longest(x_, groups_[g].size(), workers);
        const double furthest =
            (change > 0 ? change : -change) * longest(response_, groups_[g].size(), workers);
        return furthest > size ? change * (size / furthest) : change;
    }

    // Adds change W gradient to the three numbers of each vertex that moves.
    void move(int g, Real* to, int stride, double change, Workers& workers) const {
        const Group& group = groups_[g];
        workers.forBlocks(group.size(), block, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                Real* const p = to + stride * group.vertices[v];
                if (response_[v] == Vec<double>{0, 0, 0}) continue;
                put(p, three(p) + change * response_[v]);
            }
        });
    }

    void askLaws(const Sweep<Real>& sweep, Workers& workers) {
        for (int g = 0; g < sums_->size(); ++g)
            laws_[g] = sums_->law(g, evaluate(g, sweep, sweep.before, 4, workers), time_);
    }

    std::shared_ptr<const Sums<Kind>> sums_;
    std::vector<SumLaw> laws_;  // of the substep
    std::vector<Group> groups_;
    std::vector<double> lambda_;
    double from_ = 0, to_ = 0, time_ = 0;  // s
    bool fresh_ = true;                    // no evaluation yet in this substep
    // Of the sum at hand, by vertex, by corner and by block.
    std::vector<Vec<double>> x_, gradient_, response_, slopes_;
    std::vector<double> partial_;
};

// A set of them. Throws as checkSums() does, when a solver is made.
template <class Kind>
void constrainSums(World& world, Sums<Kind> sums, SetOptions options) {
    const auto make = [set = std::make_shared<const Sums<Kind>>(std::move(sums)),
                       name = options.name]<class Real>(
                          const World& w, KernelChoice) -> std::unique_ptr<Constraint<Real>> {
        checkSums(name, *set, w.start.size());
        return std::make_unique<SumSet<Kind, Real>>(set);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
