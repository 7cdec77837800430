// The border between the air and its inner loops, which are compiled once per instruction set
// (air_kernels.cpp) and chosen at run time. Only plain pointers cross it.
#pragma once

#include "../kernels/kernels.h"

namespace plait {

// Facets with the same number of corners, in blocks of blockSize: number m of facet n of a block is
// at m * 16 + n.
template <class Real>
struct FacetBlocks {
    const int* ids;     // a number a corner
    const Real* rows;   // rest area (m^2), inverse of it or of the rest length (an edge), and the
                        // part of it that counts on each corner's mass (m^2)
    const Real* gusts;  // velocity at the frame's start, and its change in it; null without noise
    Real* sides;        // 4 a facet: vector area, or edge, and m^2/kg of its share of its vertices
    Real* impulses;     // 4 a facet: N s on each corner
};

// The vertices of those facets, in blocks: row r of block b, of blockSize facets, one a vertex, is
// start[b] <= r < start[b + 1].
template <class Real>
struct AroundBlocks {
    const int* vertices;
    const int* start;
    const int* facets;
    const Real* added;  // kg of air, a number a vertex
};

// A substep, for all facets alike.
template <class Real>
struct AirStep {
    const Real* particles;        // 8 numbers a vertex: x y z w, dx dy dz 0
    Real* velocity;               // 4 a vertex
    Real* inertia;                // 4 a vertex: q of w I - q q^T; null without added mass
    Real wind[3];                 // m/s
    Real gust;                    // how much of the frame has passed, 0 to 1
    Real drag, tangential, lift;  // force per area and speed or speed squared, times h
};

template <class Real>
using FacetKernel = void (*)(const AirStep<Real>&, const FacetBlocks<Real>&, int begin, int end);
template <class Real>
using AroundKernel = void (*)(const AirStep<Real>&, const AroundBlocks<Real>&, const Real* records,
                              int begin, int end);

// By what they write.
template <class Real>
struct AirTable {
    FacetKernel<Real> sides[2];        // from positions; [0] of edges, [1] of triangles
    AroundKernel<Real> inertia;        // from the sides of triangles
    FacetKernel<Real> impulses[2][2];  // from sides and velocities; [1][]: in `legacy`
    AroundKernel<Real> velocities;     // from impulses
};

// Throws std::invalid_argument if `choice` is not available.
template <class Real>
const AirTable<Real>& airKernels(KernelChoice choice);
template <>
const AirTable<float>& airKernels<float>(KernelChoice choice);
template <>
const AirTable<double>& airKernels<double>(KernelChoice choice);

}  // namespace plait
