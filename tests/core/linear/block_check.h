// The multifrontal solver against sparse factors in double.
#pragma once

#include "block_system.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <string>

namespace plait::test {

struct Solved {
    Factored factored;
    Vectors x;
};

inline Solved solved(const System& system, int threads = 1,
                     const MultifrontalOptions& options = {}) {
    Multifrontal factors(system.rest, system.edges, system.pinned, options);
    Workers workers(threads);
    const Factored factored = factors.factor(system.vertexBlocks, system.edgeBlocks, workers);
    Vectors x = system.b;
    factors.solve(x, workers);
    return {factored, x};
}

// Largest eigenvalues of a matrix and of its inverse, by the power method.
struct Norms {
    double matrix, inverse;
};

template <class Factors>
Norms normsOf(const Eigen::SparseMatrix<double>& a, const Factors& factors) {
    Eigen::VectorXd high = Eigen::VectorXd::LinSpaced(a.rows(), 1, 2), low = high;
    for (Eigen::Index i = 0; i < high.size(); i += 2) high[i] = -high[i];
    for (int i = 0; i < 50; ++i) {
        high = a * high.normalized();
        low = factors.solve(low.normalized());
    }
    return {high.norm(), low.norm()};
}

// Rounding errors of a factorisation add up like steps of a random walk, to sqrt(n) of them (Higham
// and Mary, "A new approach to probabilistic rounding error analysis", 2019), and count in the
// solution times the condition of the matrix. `frozen` components are 0 in the solution and as if
// they were not there in the matrix.
template <class Factors>
void checkAgainst(const std::string& name, const System& system, int leaf = 16,
                  const std::vector<int>& frozen = {}) {
    Eigen::SparseMatrix<double> a = system.matrix();
    Eigen::VectorXd b = system.right(), x(b.size());
    std::vector<bool> gone(static_cast<std::size_t>(b.size()), false);
    for (const int i : frozen) gone[i] = true, b[i] = 0;
    a.prune(
        [&](Eigen::Index r, Eigen::Index c, double) { return r == c || (!gone[r] && !gone[c]); });
    for (const int i : frozen) a.coeffRef(i, i) = 1;
    const Factors factors(a);
    const Eigen::VectorXd expected = factors.solve(b);
    const Solved found = solved(system, 1, {.leaf = leaf});
    for (std::size_t v = 0; v < system.rest.size(); ++v)
        x.segment<3>(static_cast<Eigen::Index>(3 * v)) =
            Eigen::Vector3d(found.x[v].x, found.x[v].y, found.x[v].z);
    CHECK(found.factored.finite);
    CHECK(found.factored.frozen == static_cast<int>(frozen.size()));
    for (const int i : frozen) CHECK(x[i] == 0);
    const Norms norms = normsOf(a, factors);
    const double rounding = 0x1p-24 * std::sqrt(static_cast<double>(b.size()));
    CHECK(report(name + ", residual", (b - a * x).norm() / (norms.matrix * x.norm()), rounding));
    CHECK(report(name + ", error", (x - expected).norm() / expected.norm(),
                 rounding * norms.matrix * norms.inverse));
}

}  // namespace plait::test
