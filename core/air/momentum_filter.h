// How much of the air moves with a sheet: all of it with long waves, hardly any with short ones.
#pragma once

#include "skin.h"

#include <Eigen/SparseCholesky>

#include <array>
#include <span>
#include <vector>

namespace plait {

// A = m a (a + l^2 K)^-1 a, in kg, of a sheet with areas a by vertex (m^2, a diagonal) and linear
// elements K: the air's momentum along the normal by vertex is A times the normal speed. A wave of
// number k carries m / (1 + l^2 k^2) kg/m^2. In potential flow that is 2 rho / k: the two meet
// where k = 1 / l and m = 4 rho l, and neither knows fine waves. At borders the slope is 0.
//
// Sums of vertices with smooth weights (smoothed aggregation, Vanek, Mandel, Brezina 1996) take the
// vertices' place while they lie closer than a third of l: what is left out is what A leaves out.
class MomentumFilter {
public:
    // Triangles at rest; `mass` m (kg/m^2) > 0 and `reach` l (m) > 0. `vertices`: how many the
    // world has. Vectors below go by place(), which counts those that have a triangle.
    MomentumFilter(std::span<const RestFacet> triangles, int vertices, double mass, double reach);

    int size() const { return static_cast<int>(area_.size()); }
    int place(int vertex) const { return place_[static_cast<std::size_t>(vertex)]; }  // -1: none
    int unknowns() const { return static_cast<int>(weights_.cols()); }

    // For vertices of inverse mass w (1/kg).
    void factor(std::span<const double> w);
    // phi with (w^-1 + A) u' = w^-1 u + p and A u' = m a phi; `right` is a (u + w a p / a). Where w
    // is 0 u' is u.
    void solve(std::span<const double> right, std::span<double> phi) const;

private:
    using Matrix = Eigen::SparseMatrix<double>;

    void coarsen(const Matrix& stiffness, double spacing);

    double mass_;
    std::vector<int> place_;
    std::vector<double> area_;
    Matrix weights_, inside_;  // of the sums; a + l^2 K of them
    Eigen::SimplicialLDLT<Matrix> factors_;
};

}  // namespace plait
