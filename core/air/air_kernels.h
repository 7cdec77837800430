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
};

// The air that a sheet carries, beside the facets and vertices of its triangles. What is by vertex
// goes by its place in AroundBlocks, but for what says so.
template <class Real>
struct CarriedBlocks {
    Real* ways;     // 4 a facet: area times how fast the air goes along it to each of its corners
                    // from the side across, m^2/s, and what goes through it, m^3/s
    Real* rates;    // of a facet, 1/s: the largest of these by area at rest
    Real fastest;   // 1/s: through larger or faster facets air goes at this rate and no more
    Real* slopes;   // of a facet: a third of its area times how a field changes for the air
    Real* normals;  // 4: unit normal, and the air's speed along it, m/s
    Real* right;    // MomentumFilter::solve()
    const Real* phi;
    const Real* areas;  // at rest, m^2
    const Real* open;   // 1/m^2: the inverse of it, less where air flows in at a border
    Real* momentum;     // of a vertex of the world: along the normal and by area, N s/m^2
    Real* velocity;     // 4 a vertex of the world: m/s, when the substep began
    Real* other;        // likewise, as changed since or where `velocity` is; or null
    Real* impulses;     // 4: N s
    Real mass;          // kg/m^2
};

// A substep, for all facets alike.
template <class Real>
struct AirStep {
    const Real* particles;        // 8 numbers a vertex: x y z w, dx dy dz 0
    Real* velocity;               // 4 a vertex
    Real wind[3];                 // m/s
    Real gust;                    // how much of the frame has passed, 0 to 1
    Real drag, tangential, lift;  // force per area and speed or speed squared, times h
};

template <class Real>
using FacetKernel = void (*)(const AirStep<Real>&, const FacetBlocks<Real>&, int begin, int end);
template <class Real>
using AroundKernel = void (*)(const AirStep<Real>&, const AroundBlocks<Real>&, const Real* records,
                              int begin, int end);

template <class Real>
using WayKernel = void (*)(const AirStep<Real>&, const FacetBlocks<Real>&,
                           const CarriedBlocks<Real>&, int begin, int end);
template <class Real>
using SlopeKernel = void (*)(const FacetBlocks<Real>&, const CarriedBlocks<Real>&,
                             const Real* field, int begin, int end);
template <class Real>
using CarryKernel = void (*)(const AroundBlocks<Real>&, const CarriedBlocks<Real>&, Real seconds,
                             const Real* from, Real* to, int begin, int end);
template <class Real>
using MeetKernel = void (*)(const AirStep<Real>&, const FacetBlocks<Real>&,
                            const AroundBlocks<Real>&, const CarriedBlocks<Real>&, int begin,
                            int end);

// By what they write.
template <class Real>
struct AirTable {
    FacetKernel<Real> sides[2];        // from positions; [0] of edges, [1] of triangles
    FacetKernel<Real> impulses[2][2];  // from sides and velocities; [1][]: in `legacy`
    AroundKernel<Real> velocities;     // from impulses
    WayKernel<Real> ways;              // and rates
    SlopeKernel<Real> slopes;
    CarryKernel<Real> carried;  // a field a time later, if slopes were those of `from`
    MeetKernel<Real> normals, right, exchanged;
};

// Throws std::invalid_argument if `choice` is not available.
template <class Real>
const AirTable<Real>& airKernels(KernelChoice choice);
template <>
const AirTable<float>& airKernels<float>(KernelChoice choice);
template <>
const AirTable<double>& airKernels<double>(KernelChoice choice);

}  // namespace plait
