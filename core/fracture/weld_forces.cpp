#include "weld_forces.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

using Six = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Axes {
    Vec<double> normal, along, through;
};

Axes axesOf(const Weld& weld) { return {weld.normal, weld.along, cross(weld.normal, weld.along)}; }

// Forces and moments by what the second has moved from the first, in global axes. Twist counts as
// bending does, so that a plate has no Poisson's ratio.
Six springOf(const Weld& weld, double stiffness) {
    const double l = weld.length, t = weld.height, per = stiffness / weld.span;
    const double thin = per * l * t * t * t / 12, wide = per * t * l * l * l / 12;
    const Axes axes = axesOf(weld);
    Six k = Six::Zero();
    const auto add = [&](int from, double s, const Vec<double>& u) {
        const double c[3] = {u.x, u.y, u.z};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) k(from + i, from + j) += s * c[i] * c[j];
    };
    for (const Vec<double>& u : {axes.normal, axes.along, axes.through}) add(0, per * l * t, u);
    add(3, thin, axes.normal);
    add(3, thin, axes.along);
    add(3, wide, axes.through);
    return k;
}

// How what is at `arm` from a centre moves and turns by the motion of that centre.
Six carry(const Vec<double>& arm) {
    Six j = Six::Identity();
    j(0, 4) = arm.z, j(0, 5) = -arm.y;
    j(1, 3) = -arm.z, j(1, 5) = arm.x;
    j(2, 3) = arm.y, j(2, 4) = -arm.x;
    return j;
}

// A weld's spring, and how it takes part in the motion of its pieces.
struct Spring {
    Six stiffness, first, second;
};

Spring springOf(const Weld& weld, double stiffness, std::span<const PieceMass> masses) {
    return {springOf(weld, stiffness), carry(weld.at - masses[weld.first].centre),
            carry(weld.at - masses[weld.second].centre)};
}

// By piece: where its unknowns begin; -1: it is pinned.
std::vector<int> rowsOf(const Cluster& cluster, std::span<const unsigned char> pinned,
                        std::size_t pieces, bool holdOne, int& size) {
    std::vector<int> rows(pieces, -1);
    size = 0;
    for (std::size_t i = 0; i < cluster.pieces.size(); ++i)
        if (!pinned[i] && !(holdOne && i == 0)) rows[cluster.pieces[i]] = 6 * size++;
    size *= 6;
    return rows;
}

}  // namespace

double stressOf(const Weld& weld, const WeldForce& force) {
    const double l = weld.length, t = weld.height;
    const Axes axes = axesOf(weld);
    return -dot(force.force, axes.normal) / (l * t) +
           6 * std::fabs(dot(force.moment, axes.along)) / (l * t * t) +
           6 * std::fabs(dot(force.moment, axes.through)) / (t * l * l);
}

WeldForces::Matrix WeldForces::matrixOf(const Cluster& cluster, std::span<const int> rows, int size,
                                        double time) const {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int column, const Six& k) {
        if (row < 0 || column < 0) return;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (row + i >= column + j) entries.emplace_back(row + i, column + j, k(i, j));
    };
    for (const int w : cluster.welds) {
        const Weld& weld = (*welds_)[w];
        const Spring s = springOf(weld, stiffness_, masses_);
        const int a = rows[weld.first], b = rows[weld.second];
        add(a, a, s.first.transpose() * s.stiffness * s.first);
        add(b, b, s.second.transpose() * s.stiffness * s.second);
        add(std::max(a, b), std::min(a, b),
            a > b ? Six(-s.first.transpose() * s.stiffness * s.second)
                  : Six(-s.second.transpose() * s.stiffness * s.first));
    }
    const double perSecond2 = time > 0 ? 1 / (time * time) : 0;
    for (const int p : cluster.pieces) {
        if (rows[p] < 0 || time <= 0) continue;
        const PieceMass& m = masses_[p];
        Six k = Six::Zero();
        k.topLeftCorner<3, 3>().diagonal().setConstant(m.mass);
        const Symmetric<double>& i = m.inertia;
        k.bottomRightCorner<3, 3>() << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
        add(rows[p], rows[p], perSecond2 * k);
    }
    Matrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

const WeldForces::Factors& WeldForces::factorsOf(const Cluster& cluster, std::span<const int> rows,
                                                 int size) {
    if (known_.empty()) known_.resize(masses_.size());
    Known& known = known_[cluster.pieces[0]];
    if (!known.factors || known.pieces != cluster.pieces || known.welds != cluster.welds) {
        known.pieces = cluster.pieces;
        known.welds = cluster.welds;
        known.factors = std::make_unique<Factors>(matrixOf(cluster, rows, size, 0));
        ++factors_;
    }
    return *known.factors;
}

// Takes from the loads what moves the cluster as one.
void WeldForces::balance(const Cluster& cluster, std::vector<PieceForce>& loads) const {
    double mass = 0;
    Vec<double> centre{}, force{}, torque{};
    for (const int p : cluster.pieces) {
        mass += masses_[p].mass;
        centre += masses_[p].mass * masses_[p].centre;
    }
    centre = (1 / mass) * centre;
    Symmetric<double> inertia{};
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const PieceMass& m = masses_[cluster.pieces[i]];
        const Vec<double> arm = m.centre - centre;
        force += loads[i].force;
        torque += loads[i].torque + cross(arm, loads[i].force);
        inertia += m.inertia;
        inertia += Symmetric<double>::diagonal(m.mass * dot(arm, arm));
        inertia.addOuter(-m.mass, arm);
    }
    const Vec<double> spin = inertia.solve(torque);
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const PieceMass& m = masses_[cluster.pieces[i]];
        loads[i].force -= m.mass * ((1 / mass) * force + cross(spin, m.centre - centre));
        loads[i].torque -= m.inertia * spin;
    }
}

// Whether a load lasts as far as the springs of a cluster can tell. Beside their stiffness the
// inertia of one that is free would be lost in rounding, and the matrix be singular, where two
// touch so slowly that Hertz's time is years.
bool WeldForces::lasts(const Cluster& cluster, double time) const {
    if (time <= 0) return true;
    if (cluster.pinned) return false;
    constexpr double least = 1e-11;
    double mass = 0, stiffest = 0;
    for (const int p : cluster.pieces) mass += masses_[p].mass;
    for (const int w : cluster.welds) {
        const Weld& weld = (*welds_)[w];
        stiffest = std::max(stiffest, stiffness_ * weld.length * weld.height / weld.span);
    }
    return mass < least * stiffest * time * time;
}

void WeldForces::add(const Cluster& cluster, std::span<const unsigned char> pinned,
                     std::vector<PieceForce> loads, double time, std::vector<WeldForce>& forces) {
    const bool still = lasts(cluster, time), holdOne = still && !cluster.pinned;
    int size = 0;
    const std::vector<int> rows = rowsOf(cluster, pinned, masses_.size(), holdOne, size);
    if (size == 0) return;
    if (holdOne) balance(cluster, loads);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const int row = rows[cluster.pieces[i]];
        if (row < 0) continue;
        const auto& [f, t] = loads[i];
        u.segment<6>(row) << f.x, f.y, f.z, t.x, t.y, t.z;
    }
    if (still) {
        u = factorsOf(cluster, rows, size).solve(u).eval();
    } else {
        u = Factors(matrixOf(cluster, rows, size, time)).solve(u).eval();
        ++factors_;
    }
    ++solves_;
    const auto motionOf = [&](int piece) {
        return rows[piece] < 0 ? Vector6(Vector6::Zero()) : Vector6(u.segment<6>(rows[piece]));
    };
    for (std::size_t i = 0; i < cluster.welds.size(); ++i) {
        const Weld& weld = (*welds_)[cluster.welds[i]];
        const Spring s = springOf(weld, stiffness_, masses_);
        const Vector6 w =
            -s.stiffness * (s.second * motionOf(weld.second) - s.first * motionOf(weld.first));
        forces[i].force += {w(0), w(1), w(2)};
        forces[i].moment += {w(3), w(4), w(5)};
    }
}

}  // namespace plait
