// The border between a liquid and its inner loops, which are compiled once per instruction set
// (liquid_kernels.cpp) and chosen at run time. Only plain pointers cross it.
#pragma once

#include "../kernels/kernels.h"

namespace plait {

// One evaluation of the densities of all particles of a liquid. By slot unless said, padded where
// cells.h says so; cells as Cells has them.
template <class Real>
struct LiquidPass {
    const Real *x, *y, *z;  // m, padded
    const Real* inverse;    // 1/kg, padded
    const Real* wall;       // 4 each: gradient (1/m) and part of the kernel that walls take
    const int* vertex;
    const int* start;     // by cell
    const int* occupied;  // cells
    int row, layer;
    Real radius;      // m, of the kernel
    Real scale;       // of the kernel: the sum of water at rest is 1
    Real relaxation;  // part of a correction that is applied
    Real least;       // 1/(kg m^2): a constraint's inverse mass counts as no less
    Real* lambda;     // kg m^2, padded
    Real* particles;  // as Sweep has them
};

template <class Real>
struct LiquidTable {
    // Of occupied cells begin .. end - 1. First all multipliers, then all corrections.
    using Pass = void (*)(const LiquidPass<Real>&, int begin, int end);
    Pass weigh, move;
};

// Throws std::invalid_argument if `choice` is not available; lanes are always sixteen side by side,
// whatever the width of registers, so that the bits are the same.
template <class Real>
const LiquidTable<Real>& liquidKernels(KernelChoice choice);
template <>
const LiquidTable<float>& liquidKernels<float>(KernelChoice choice);
template <>
const LiquidTable<double>& liquidKernels<double>(KernelChoice choice);

}  // namespace plait
