// The set of the densities of a liquid's particles.
#pragma once

#include "cells.h"
#include "liquid.h"
#include "liquid_kernels.h"
#include "walls.h"

#include <span>
#include <string>
#include <vector>

namespace plait {

inline constexpr double radiusInSpacings = 2;
// The sum of the kernel over the particles of settled water, which are packed as chance has them;
// of a lattice of as many in as much space it is 3.1415.
inline constexpr double restSum = 3.094;

template <class Real>
class LiquidSet : public Constraint<Real> {
public:
    LiquidSet(const World& world, const Liquid& liquid, const std::string& name,
              KernelChoice kernels);

    void beginFrame(double t0, double t1) override { walls_.beginFrame(t0, t1); }
    void begin(const Substep& substep, Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    long size() const override { return static_cast<long>(present_.size()); }

    // Of the last evaluation, by slot: multipliers (kg m^2), what walls take and its gradient, and
    // which vertex it is.
    std::span<const Real> multipliers() const { return lambda_; }
    std::span<const Padded<Real>> wall() const { return wall_; }
    std::span<const int> vertices() const { return vertex_; }

private:
    void sort(const Sweep<Real>& sweep, Workers& workers);
    void shade(Workers& workers);

    Range particles_;
    Vec<Real> origin_;  // m; floats lose less near it
    Real radius_, relaxation_, least_;
    Walls walls_;
    const LiquidTable<Real>& kernels_;
    Cells<Real> cells_;
    std::vector<Real> inverse_, lambda_;  // by slot, padded
    std::vector<Padded<Real>> wall_;
    std::vector<int> vertex_, present_;
    bool comes_ = false;      // and goes: not all are present
    bool evaluated_ = false;  // forward, and not yet backward
};

extern template class LiquidSet<float>;
extern template class LiquidSet<double>;

}  // namespace plait
