#include "liquid_set.h"

#include "../numbers/convert.h"
#include "spline.h"

#include <algorithm>
#include <utility>

namespace plait {
namespace {

constexpr int grain = 64;  // cells a thread takes at least

// 1/(kg m^2): what a constraint answers in a lattice, but for the part of its own particle.
double latticeAnswer(double inverseMass, double spacing) {
    double sum = 0;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const double r = squareRoot(static_cast<double>(x * x + y * y + z * z));
                const double slope = r > 0 ? CubicSpline::slope(r / radiusInSpacings) : 0;
                sum += slope * slope;
            }
    const double perLength = 1 / (radiusInSpacings * spacing * restSum);
    return inverseMass * perLength * perLength * sum;
}

}  // namespace

template <class Real>
LiquidSet<Real>::LiquidSet(const World& world, const Liquid& liquid, const std::string& name,
                           KernelChoice kernels)
    : particles_(liquid.particles),
      origin_(as<Real>(world.start[liquid.particles.first])),
      radius_(static_cast<Real>(kernelRadius(liquid))),
      relaxation_(static_cast<Real>(liquid.relaxation)),
      walls_(liquid.walls, kernelRadius(liquid), name, liquid.shades),
      kernels_(liquidKernels<Real>(kernels)) {
    // Where particles fall into one there is next to no gradient: then a correction has no more
    // than twenty times the multiplier of ordinary water.
    double heaviest = 0;
    for (int v = liquid.particles.first; v < liquid.particles.last; ++v)
        heaviest = std::max(heaviest, world.mass[v]);
    const double inverse = 1 / heaviest;
    least_ = static_cast<Real>(0.05 * latticeAnswer(inverse, liquid.spacing));
    const auto n = static_cast<std::size_t>(particles_.size());
    inverse_.resize(n + slotPadding);
    lambda_.resize(n + slotPadding);
    wall_.resize(n);
    vertex_.resize(n);
    for (int v = particles_.first; v < particles_.last; ++v) {
        present_.push_back(v);
        comes_ = comes_ || world.isSpare(v);
    }
}

template <class Real>
void LiquidSet<Real>::begin(const Substep& substep, Workers&) {
    walls_.begin(substep);
    evaluated_ = false;
}

// Jacobi: all multipliers from where everything is, then all corrections, so that forward and
// backward are the same, and one of them is an evaluation.
template <class Real>
void LiquidSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    if (direction == Direction::backward && std::exchange(evaluated_, false)) return;
    evaluated_ = direction == Direction::forward;
    sort(sweep, workers);
    shade(workers);
    const LiquidPass<Real> pass{.x = cells_.x(),
                                .y = cells_.y(),
                                .z = cells_.z(),
                                .inverse = inverse_.data(),
                                .wall = &wall_[0].v.x,
                                .vertex = vertex_.data(),
                                .start = cells_.start(),
                                .occupied = cells_.occupied().data(),
                                .row = cells_.row(),
                                .layer = cells_.layer(),
                                .radius = radius_,
                                .scale = static_cast<Real>(1 / restSum),
                                .relaxation = sweep.strength * relaxation_,
                                .least = least_,
                                .lambda = lambda_.data(),
                                .particles = sweep.particles};
    const auto cells = static_cast<int>(cells_.occupied().size());
    workers.forBlocks(cells, grain, [&](int begin, int end) { kernels_.weigh(pass, begin, end); });
    workers.forBlocks(cells, grain, [&](int begin, int end) { kernels_.move(pass, begin, end); });
}

template <class Real>
void LiquidSet<Real>::sort(const Sweep<Real>& sweep, Workers& workers) {
    if (comes_) {
        present_.clear();
        for (int v = particles_.first; v < particles_.last; ++v)
            if (sweep.particles[8L * v + 3] > 0) present_.push_back(v);
    }
    const auto position = [&](int i) {
        const Real* const p = sweep.particles + 8L * present_[i];
        return Vec<Real>{(p[0] - origin_.x) + p[4], (p[1] - origin_.y) + p[5],
                         (p[2] - origin_.z) + p[6]};
    };
    cells_.sort(static_cast<int>(present_.size()), radius_, position, workers);
    workers.forBlocks(cells_.count(), 1024, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            vertex_[s] = present_[cells_.order()[s]];
            inverse_[s] = sweep.particles[8L * vertex_[s] + 3];
        }
    });
}

template <class Real>
void LiquidSet<Real>::shade(Workers& workers) {
    const auto cells = static_cast<int>(cells_.occupied().size());
    const Vec<double> origin = as<double>(origin_);
    const double reach = 0.867 * double(cells_.width());  // half a cell's diagonal
    workers.forBlocks(cells, grain, [&](int begin, int end) {
        for (int c = begin; c < end; ++c) {
            const int cell = cells_.occupied()[c];
            // Those at the edge may be outside of their cell.
            const Vec<double> middle = origin + as<double>(cells_.middle(cell));
            const bool near = cells_.isAtEdge(cell) || walls_.near(middle, reach);
            for (int s = cells_.start()[cell]; s < cells_.start()[cell + 1]; ++s) {
                Padded<Real>& wall = wall_[s] = {};
                if (!near) continue;
                const Shade shade = walls_.at(origin + as<double>(cells_.point(s)));
                wall = {as<Real>(shade.gradient), static_cast<Real>(shade.part)};
            }
        }
    });
}

template class LiquidSet<float>;
template class LiquidSet<double>;

}  // namespace plait
