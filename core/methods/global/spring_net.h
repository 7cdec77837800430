// The net of springs that a Newton iteration on tensions comes to (README.md): its equations, and
// their solution to what float leaves of them.
#pragma once

#include "../../linear/multifrontal.h"
#include "../../linear/smoothed_aggregation.h"
#include "../../numbers/convert.h"
#include "../../sets/link_blocks.h"
#include "../../whole_step.h"

#include <cmath>
#include <memory>

namespace plait {

template <class Real>
class SpringNet {
public:
    // Of these links, by slot, which must live as long, from where the run starts.
    SpringNet(const LinkBlocks<Real>& links, const State<Real>& state, KernelChoice kernels)
        : links_(links) {
        const auto vertices = state.particles.size();
        edgeBlocks.resize(static_cast<std::size_t>(links.size()));
        vertexBlocks.resize(vertices);
        right.resize(vertices);
        step.resize(vertices);
        left_.resize(vertices);
        std::vector<int> edges;
        for (int n = 0; n < links.size(); ++n)
            edges.insert(edges.end(), {links.vertex(n, 0), links.vertex(n, 1)});
        std::vector<Vec<double>> start;
        std::vector<unsigned char> pinned;
        for (int v = 0; v <= state.count(); ++v) {
            start.push_back(state.position(v));
            pinned.push_back(state.particles[v].w == Real(0));
        }
        if (state.count() > largestFactored) {
            multigrid_ = std::make_unique<SmoothedAggregation>(edges, pinned);
            work_ = static_cast<long>(multigrid_->multiplications(cycles) / multiplicationsOfALink);
            places_.resize(start.size());
            return;
        }
        factors_ = std::make_unique<Multifrontal>(start, edges, pinned,
                                                  MultifrontalOptions{.kernels = kernels});
        work_ = static_cast<long>(factors_->multiplications() / multiplicationsOfALink);
    }

    std::vector<Symmetric<float>> vertexBlocks, edgeBlocks;  // N/m, by vertex, by slot
    std::vector<Vec<double>> right;                          // N, by vertex
    std::vector<Vec<float>> step;                            // m, by vertex: the solution

    // The counted work of a solution.
    long work() const { return work_; }

    // Finds the step. False where rounding leaves too little of it. What is left of the equations
    // is in `right` then.
    bool solve(const State<Real>& state, Workers& workers) {
        for (std::size_t v = 0; v < step.size(); ++v) step[v] = as<float>(right[v]);
        if (multigrid_) return approximate(state, workers);
        if (factors_->factorAndSolve(vertexBlocks, edgeBlocks, step, workers).frozen > 0)
            return false;
        constexpr double sharp = 1.0 / 64, blurred = 1.0 / 4;
        for (int pass = 0; pass < 3; ++pass) {
            const double correction = refine(pass == 0 ? step : left_, workers);
            if (!(correction < blurred)) return false;
            if (correction < sharp) break;
        }
        return true;
    }

private:
    // Vertices up to which factoring the matrix takes no longer than cycles of multigrid, and how
    // many of these a sheet cannot tell from it: linear/README.md has the measurements.
    static constexpr int largestFactored = 100'000, cycles = 4;

    bool approximate(const State<Real>& state, Workers& workers) {
        for (std::size_t v = 0; v < places_.size(); ++v)
            places_[v] = state.position(static_cast<int>(v));
        multigrid_->setUp(vertexBlocks, edgeBlocks, places_, workers);
        return multigrid_->solve(step, cycles, workers) < 1.0 / 4;
    }

    // With what rounding has left of the equations, in double; without, a free sheet loses 3e-4 of
    // its momentum in 120 steps. `added`: to the step since the last time.
    // Returns how large the correction was, as a part of the step.
    double refine(const std::vector<Vec<float>>& added, Workers& workers) {
        for (std::size_t v = 0; v < step.size(); ++v)
            right[v] -= as<double>(vertexBlocks[v]) * as<double>(added[v]);
        links_.forColors(false, workers, [&](int begin, int end) {
            for (int n = begin; n < end; ++n) {
                const int a = links_.vertex(n, 0), b = links_.vertex(n, 1);
                const Vec<double> d = as<double>(added[b]) - as<double>(added[a]);
                const Vec<double> force = as<double>(edgeBlocks[n]) * d;
                right[a] += force;
                right[b] -= force;
            }
        });
        for (std::size_t v = 0; v < step.size(); ++v) left_[v] = as<float>(right[v]);
        factors_->solve(left_, workers);
        double error = 0, size = 0;
        for (std::size_t v = 0; v < step.size(); ++v) {
            error += dot(left_[v], left_[v]);
            size += dot(step[v], step[v]);
            step[v] += left_[v];
        }
        return std::sqrt(divide(error, size));
    }

    const LinkBlocks<Real>& links_;
    std::unique_ptr<Multifrontal> factors_;
    std::unique_ptr<SmoothedAggregation> multigrid_;  // in its place, of many vertices
    std::vector<Vec<double>> places_;                 // m, by vertex; of these only
    std::vector<Vec<float>> left_;
    long work_ = 0;
};

}  // namespace plait
