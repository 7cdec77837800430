// The border between the solver and its inner loops, which are compiled once per instruction set
// (kernels.cpp) and chosen at run time. Only plain pointers cross it.
#pragma once

#include <cstdint>

namespace plait {

// Constraints are stored in blocks of this many, so that every lane width divides them.
inline constexpr int blockSize = 16;

// What a sweep does to every constraint alike.
template <class Real>
struct Sweep {
    Real* particles;  // 8 numbers a vertex: x y z w, dx dy dz 0
    Real* out;        // 4 a vertex: velocities (damp), sums of corrections (smooth)
    Real inverseH2;   // 1/h^2, 1/s^2; 0 for methods that know no compliance
    Real keep;        // 1: multipliers accumulate within the substep; 0: each evaluation anew
    Real strength;    // part of the correction that is applied, 0 to 1
    const Real* before = nullptr;  // 4 a vertex: d when the substep began
    // Of the set's drawer.
    const Real* kept = nullptr;
    const std::int32_t* keptIntegers = nullptr;
};

// The constraints of one colour, in blocks: member m of constraint n of a block is at m * 16 + n.
template <class Real>
struct Batch {
    const int* ids;
    const Real* rows;
    Real* lambda;
    const Real* relax;  // 1 / (constraints on the busiest vertex), for smoothing
};

template <class Real>
using Kernel = void (*)(const Sweep<Real>&, const Batch<Real>&, int begin, int end);

template <class Real>
struct KernelTable {
    Kernel<Real> project;
    Kernel<Real> smooth;  // corrections are summed into `out`, positions stay (Jacobi)
    Kernel<Real> damp;    // the rate of C is reduced by `strength` in the velocities `out`
};

enum class Isa { v2, v3, v4 };  // x86-64 levels

// Which copy of the kernels runs. All give the same bits; the default is the fastest here.
struct KernelChoice {
    Isa isa;
    int lanes;  // floats side by side: 1 and 4 on v2, 4 and 8 on v3, and 16 on v4; doubles run
                // singly
};

// The widest level this processor has, with the lane width that is fastest there.
KernelChoice bestKernels();
// True if this processor can run it and it was built.
bool available(KernelChoice);

// Kernels of the kind at this place of the list in constraints/kinds.h.
// Throws std::invalid_argument if `choice` is not available.
const KernelTable<float>& floatKernels(KernelChoice choice, int kind);
const KernelTable<double>& doubleKernels(KernelChoice choice, int kind);

}  // namespace plait
