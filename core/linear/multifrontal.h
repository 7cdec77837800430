// A sparse Cholesky factorisation in float of matrices with a symmetric 3 x 3 block for each vertex
// and each edge of a mesh, multifrontal (Duff and Reid 1983) in an order by nested dissection:
// dense work alone, in N^1.5 multiplications for the N vertices of a sheet.
#pragma once

#include "../kernels/workers.h"
#include "../numbers/symmetric.h"
#include "fronts/analysis.h"

#include <span>
#include <vector>

namespace plait {

struct MultifrontalOptions {
    int leaf = 16;  // vertices, at least 1: sets of as many or fewer are not dissected further
    KernelChoice kernels = bestKernels();  // its lanes say nothing here
};

struct Factored {
    bool finite;  // false: the blocks at a vertex add up to no number, and every solution is 0
    int frozen;   // components whose pivot was not above 2^-24 of what stood on the diagonal: they
                  // are 0 in every solution
};

// The matrix is the sum of a block for each vertex and, for each edge,
//      H -H
//     -H  H
// on the rows of its ends: what a spring with the stiffness H adds. A pinned vertex has no rows. An
// edge that holds no more is a block of zeros: the analysis, which asks only where blocks may be,
// stays valid when a mesh is cut.
// The same bits for any number of threads and any kernels; nothing is allocated after the first
// factorisation with as many threads.
class Multifrontal {
public:
    // Any mesh: `rest` (m) by vertex decides only the order; `edges` come in pairs of vertices, may
    // repeat, and say nothing where both are one. Throws std::invalid_argument if they name others,
    // or a position is not finite.
    Multifrontal(std::span<const Vec<double>> rest, std::span<const int> edges,
                 std::span<const unsigned char> pinned, const MultifrontalOptions& options = {});

    // Blocks by vertex and by edge.
    Factored factor(std::span<const Symmetric<float>> vertexBlocks,
                    std::span<const Symmetric<float>> edgeBlocks, Workers& workers);

    // Both in one pass, with the same bits: the way there takes each front while it is at hand.
    Factored factorAndSolve(std::span<const Symmetric<float>> vertexBlocks,
                            std::span<const Symmetric<float>> edgeBlocks, std::span<Vec<float>> x,
                            Workers& workers);

    // Puts the solution in the place of the right-hand side, by vertex; 0 for pinned ones, and
    // everywhere before anything is factored.
    void solve(std::span<Vec<float>> x, Workers& workers);

    // Numbers in the factor, with those that pad it.
    long size() const { return fronts_.panelColumns * stripRows; }
    // Multiplications of a factorisation and one solution, likewise.
    double multiplications() const;

private:
    struct alignas(64) Column {
        float number[stripRows];
    };
    using Columns = std::vector<Column>;
    using Blocks = std::span<const Symmetric<float>>;

    Factored factorForward(Blocks vertexBlocks, Blocks edgeBlocks, std::span<const Vec<float>> b,
                           Workers& workers);
    void checkSize(std::size_t vertices) const;
    void solveBackward(std::span<Vec<float>> x, Workers& workers);
    bool assemble(const Front& front, Blocks vertexBlocks, Blocks edgeBlocks);
    int eliminate(int f, Columns& memory, Workers& workers);
    void extend(int f, bool panel, Columns& memory, Workers& workers);
    void forward(int f, std::span<const Vec<float>> b);
    void backward(int f, std::span<Vec<float>> solution);
    template <class Visit>
    void childrenFirst(Workers& workers, const Visit& visit);
    FrontView viewOf(const Front& front, Columns& memory);
    float* rowsOf(const Front& front) { return rows_.data()->number + front.rows; }

    Fronts fronts_;
    const FrontTable& kernels_;
    std::size_t vertices_, edges_;
    bool factored_ = false;
    Columns panels_, own_;
    std::vector<Columns> threads_;  // Schur complements within a subtree
    Columns rows_;                  // of all fronts: solutions
    Columns least_;                 // by row: pivots up to it are frozen
    Workers alone_{1};
};

}  // namespace plait
