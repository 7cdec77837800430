// The border between sets of strands and their inner loop, which is compiled once per instruction
// set (strand_kernels.cpp) and chosen at run time. Only plain pointers cross it.
#pragma once

#include "../../kernels/kernels.h"

namespace plait {

// blockSize strands side by side: number m of link k of strand n is at (k * members + m) * 16 + n.
// Shorter ones end in links of length 0 on their last vertex.
template <class Real>
struct StrandBlock {
    const int* ids;    // links + 1 vertices a strand
    const Real* rows;  // rest length (m), compliance (m/N)
    Real* lambda;      // of each link; null where all are rigid
    Real* work;  // strandWork numbers a link of those to solve, of no meaning before and after
    int links;
    int begin, end;  // the strands to solve: multiples of the lanes
    bool turns;      // with geometric stiffness
};
inline constexpr int strandWork = 7;

template <class Real>
using StrandKernel = void (*)(const Sweep<Real>&, const StrandBlock<Real>&);

template <class Real>
struct StrandTable {
    StrandKernel<Real> project, damp;
};

// Throws std::invalid_argument if `choice` is not available.
template <class Real>
const StrandTable<Real>& strandKernels(KernelChoice choice);
template <>
const StrandTable<float>& strandKernels<float>(KernelChoice choice);
template <>
const StrandTable<double>& strandKernels<double>(KernelChoice choice);

}  // namespace plait
