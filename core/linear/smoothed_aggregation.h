// Conjugate gradients under smoothed aggregation (Vanek, Mandel, Brezina, "Algebraic multigrid by
// smoothed aggregation for second and fourth order elliptic problems", 1996), in float, for the
// matrices of multifrontal.h where these are too large to factor: time and memory grow as the
// vertices do.
//
// An aggregate is a vertex and its neighbours, and moves as a rigid body does where it stands now.
// A cycle goes down the levels once, with a Gauss-Seidel sweep on the way down and its transpose on
// the way up; the last level is solved exactly.
//
// A sheet's links are 5e5 times as stiff as its inertia, and what holds a body that moves as a
// whole is inertia alone. So nothing may be taken as the difference of two products with a
// stiffness: on the finest level only differences of vectors are multiplied with the blocks of
// edges. With sums in place of these, crumpled sheets want 200 cycles in place of 20.
#pragma once

#include "../kernels/workers.h"
#include "../numbers/symmetric.h"

#include <memory>
#include <span>

namespace plait {

class SmoothedAggregation {
public:
    // `edges` come in pairs of vertices, all below `pinned.size()`, may repeat, and say nothing
    // where both are one. A pinned vertex has no rows.
    SmoothedAggregation(std::span<const int> edges, std::span<const unsigned char> pinned);
    ~SmoothedAggregation();

    // Blocks by vertex and by edge, as Multifrontal has them, and where the vertices are (m).
    void setUp(std::span<const Symmetric<float>> vertexBlocks,
               std::span<const Symmetric<float>> edgeBlocks, std::span<const Vec<double>> positions,
               Workers& workers);

    // Puts what `iterations` find in the place of the right-hand side, by vertex; 0 for pinned
    // ones. Returns what the last of them found left of the residual, in the norm of a cycle, as a
    // part of what it was; 1 where a cycle is not positive, or not a number. The same bits for any
    // number of threads; nothing is allocated.
    double solve(std::span<Vec<float>> x, int iterations, Workers& workers);

    // Multiplications of both.
    double multiplications(int iterations) const;

private:
    struct Levels;
    std::unique_ptr<Levels> levels_;
};

}  // namespace plait
