#include "hanging_chain.h"

#include <Eigen/Dense>

#include <numeric>

namespace plait {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double g = 9.81;

double stepOf(const ChainSolve& solve) { return 1.0 / (60 * solve.substeps); }

MatrixXd power(MatrixXd base, int exponent) {
    MatrixXd product = MatrixXd::Identity(base.rows(), base.cols());
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2) product = product * base;
        base = base * base;
    }
    return product;
}

// Row i of n in the order of two colours.
int placeOf(int i, int n) { return i % 2 == 0 ? i / 2 : (n + 1) / 2 + i / 2; }

double excessOfLinks(const HangingChain& chain, const ChainSolve& solve) {
    const int n = chain.links();
    const double h = stepOf(solve);
    MatrixXd a = MatrixXd::Zero(n, n);
    VectorXd lambda(n);
    double tension = 0;
    for (int i = n - 1; i >= 0; --i) {
        const int p = placeOf(i, n);
        const double above = i == 0 ? 0 : 1 / chain.mass[i - 1];
        a(p, p) = above + 1 / chain.mass[i] + chain.compliance[i] / (h * h);
        if (i > 0) a(p, placeOf(i - 1, n)) = a(placeOf(i - 1, n), p) = -above;
        lambda(p) = h * h * (tension += g * chain.mass[i]);
    }
    const MatrixXd lower = a.triangularView<Eigen::Lower>();
    const MatrixXd m = lower * a.diagonal().cwiseInverse().asDiagonal() * lower.transpose();
    const MatrixXd one = MatrixXd::Identity(n, n);
    const MatrixXd left = power(one - m.llt().solve(a), solve.sweeps);
    return (a * ((one - left).fullPivLu().solve(lambda) - lambda)).sum();
}

double excessOfVertices(const HangingChain& chain, const ChainSolve& solve) {
    const int n = chain.links();
    const double h = stepOf(solve);
    MatrixXd stiffness = MatrixXd::Zero(n, n), inertia = MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        const int p = placeOf(i, n);
        const double k = 1 / chain.compliance[i];
        inertia(p, p) = chain.mass[i] / (h * h);
        stiffness(p, p) += k;
        if (i == 0) continue;
        const int q = placeOf(i - 1, n);
        stiffness(q, q) += k;
        stiffness(p, q) = stiffness(q, p) = -k;
    }
    const MatrixXd hessian = inertia + stiffness, one = MatrixXd::Identity(n, n);
    const MatrixXd lower = hessian.triangularView<Eigen::Lower>();
    const MatrixXd sweep = one - lower.triangularView<Eigen::Lower>().solve(hessian);
    const MatrixXd implicit = hessian.llt().solve(inertia);
    const MatrixXd q = implicit + power(sweep, solve.sweeps) * (one - implicit);
    const VectorXd fall = VectorXd::Constant(n, h * h * g);
    const VectorXd settled = (one - q).fullPivLu().solve(q * fall);
    const std::vector<double> exact = chain.exact();
    return settled(placeOf(n - 1, n)) - std::accumulate(exact.begin(), exact.end(), 0.0);
}

}  // namespace

double settledExcess(const HangingChain& chain, const ChainSolve& solve) {
    return solve.method == Method::block ? excessOfVertices(chain, solve)
                                         : excessOfLinks(chain, solve);
}

}  // namespace plait
