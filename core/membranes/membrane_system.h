// One step of Newton's method on a membrane: the symmetric matrix of inertia, elements and gases,
// and conjugate gradients that solve it, in double. Sums are of parts of fixed size in fixed order,
// so that bits do not depend on threads.
#pragma once

#include "../kernels/workers.h"
#include "elements.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

// Three numbers and a zero, side by side.
using Four = double __attribute__((vector_size(32)));

inline Four four(const Vec<double>& v) { return Four{v.x, v.y, v.z, 0}; }
inline Vec<double> three(const Four& v) { return {v[0], v[1], v[2]}; }

class MembraneSystem {
public:
    // s g g^T: what a gas adds.
    struct RankOne {
        double s;
        std::span<const Four> g;
    };

    MembraneSystem(int vertices, std::span<const std::array<int, 2>> springs,
                   std::span<const std::array<int, 3>> patches);

    // inertia (kg/s^2) by vertex; one without (a pinned vertex) does not move.
    void assemble(std::span<const double> inertia, std::span<const Block> springs,
                  std::span<const std::array<Block, 6>> patches, Workers& workers);

    // The sum of the elements' forces on a vertex; a spring's is that on its first end.
    Vec<double> forceOn(int v, std::span<const Vec<double>> springs,
                        std::span<const std::array<Vec<double>, 3>> patches) const;

    // Puts into `x` what at most `iterations` find for `b`; fewer where the residual has fallen to
    // `tolerance` of what it was. Returns the iterations taken.
    int solve(std::span<const Four> b, std::span<const RankOne> gases, int iterations,
              double tolerance, std::span<Four> x, Workers& workers);

    // body(v) of every vertex, as a sum over parts.
    template <class Body>
    double sum(Workers& workers, const Body& body) {
        forParts(workers, [&](int at, int begin, int end) {
            double of = 0;
            for (int v = begin; v < end; ++v) of += body(v);
            partial_[at] = of;
        });
        return total(partial_);
    }

private:
    struct Columns {
        Four column[3];
    };
    // Where a corner of an element adds its blocks: to the row of its vertex, at these places.
    struct Corner {
        int element, corner;
        std::array<int, 3> places;
    };
    static constexpr int part = 128;  // vertices

    template <class Body>
    void forParts(Workers& workers, const Body& body) {
        workers.forBlocks(parts_, 1, [&](int begin, int end) {
            for (int p = begin; p < end; ++p)
                body(p, p * part, p + 1 < parts_ ? (p + 1) * part : vertices_);
        });
    }
    static double total(std::span<const double> sums);
    void multiply(std::span<const RankOne> gases, Workers& workers);
    void addRow(int v, std::span<const Block> springs,
                std::span<const std::array<Block, 6>> patches);

    int vertices_, parts_;
    std::vector<int> start_, column_;  // rows, the diagonal first
    std::vector<Columns> blocks_, preconditioner_;
    std::vector<int> springStart_, patchStart_;
    std::vector<Corner> springCorners_, patchCorners_;
    std::vector<Four> r_, z_, p_, product_;
    std::vector<double> partial_, curvature_, along_, pull_;  // along: by gas, by part
};

}  // namespace plait
