// The loops of the air: over facets, and over the vertices that facets are around. The mathematics
// is in facet.h.
#pragma once

#include "../numbers/lanes.h"
#include "air_kernels.h"
#include "facet.h"

namespace plait {
inline namespace PLAIT_ISA {

inline constexpr int consecutive[blockSize] = {0, 1, 2,  3,  4,  5,  6,  7,
                                               8, 9, 10, 11, 12, 13, 14, 15};

// Member m of the facet in each lane.
template <class T>
T member(const Scalar<T>* block, int m) {
    return load<T>(block + m * blockSize);
}
template <class T>
Vec<T> vector(const Scalar<T>* block, int m) {
    return {member<T>(block, m), member<T>(block, m + 1), member<T>(block, m + 2)};
}

template <class T, int corners>
[[gnu::flatten]] void writeSides(const AirStep<Scalar<T>>& step,
                                 const FacetBlocks<Scalar<T>>& facets, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int lane = n % blockSize, first = n - lane;
        const int* ids = facets.ids + corners * first + lane;
        const Scalar<T>* row = facets.rows + (2 + corners) * first + lane;
        const auto at = [&](int c) {
            return gatherRelative<T>(step.particles, ids, ids + c * blockSize);
        };
        const Quad<T> a = at(1);
        Quad<T> side{a.xyz, member<T>(row, 2) * gather<T>(step.particles, ids, 8).w +
                                member<T>(row, 3) * a.w};
        if constexpr (corners == 3) {
            const Quad<T> b = at(2);
            side = {T(0.5) * cross(a.xyz, b.xyz), side.w + member<T>(row, 4) * b.w};
        }
        scatter<T>(facets.sides + 4 * n, consecutive, 4, side);
    }
}

// The air where facet n is, m/s.
template <class T>
Vec<T> airAt(const AirStep<Scalar<T>>& step, const FacetBlocks<Scalar<T>>& facets, int n) {
    Vec<T> air{T(step.wind[0]), T(step.wind[1]), T(step.wind[2])};
    if (facets.gusts) {
        const int lane = n % blockSize;
        const Scalar<T>* gusts = facets.gusts + 6 * (n - lane) + lane;
        air += vector<T>(gusts, 0) + T(step.gust) * vector<T>(gusts, 3);
    }
    return air;
}

template <class T, int corners>
Facet<T> facetAt(const AirStep<Scalar<T>>& step, const FacetBlocks<Scalar<T>>& facets, int n,
                 bool legacy) {
    const int lane = n % blockSize, first = n - lane;
    const int* ids = facets.ids + corners * first + lane;
    const Scalar<T>* row = facets.rows + (2 + corners) * first + lane;
    const Quad<T> side = gather<T>(facets.sides + 4 * n, consecutive, 4);

    const Vec<T> u = airAt<T>(step, facets, n) -
                     T(1.0 / corners) * gatherSum<T>(step.velocity, ids, blockSize, corners, 4).xyz;

    const T size = length(side.xyz);
    Vec<T> normal = divide(T(1), size) * side.xyz;
    if constexpr (corners == 2) {
        normal = u - dot(u, normal) * normal;
        normal = divide(T(1), length(normal)) * normal;
    }
    return {normal, u, legacy ? T(1) : size * member<T>(row, 1), side.w};
}

template <class T, int corners, bool legacy>
[[gnu::flatten]] void writeImpulses(const AirStep<Scalar<T>>& step,
                                    const FacetBlocks<Scalar<T>>& facets, int begin, int end) {
    const AirForces<T> air{T(step.drag), T(step.tangential), T(step.lift)};
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const Facet<T> facet = facetAt<T, corners>(step, facets, n, legacy);
        const int lane = n % blockSize;
        const T area = member<T>(facets.rows + (2 + corners) * (n - lane) + lane, 0);
        const Vec<T> impulse = impulseOn<T, legacy>(facet, air, step.lift != 0);
        scatter<T>(facets.impulses + 4 * n, consecutive, 4,
                   {(T(1.0 / corners) * area) * impulse, T(0)});
    }
}

template <class T>
[[gnu::flatten]] void writeVelocities(const AirStep<Scalar<T>>& step,
                                      const AroundBlocks<Scalar<T>>& around,
                                      const Scalar<T>* impulses, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int lane = n % blockSize, block = n / blockSize, row = around.start[block];
        const int* vertices = around.vertices + n;
        const Vec<T> p = gatherSum<T>(impulses, around.facets + row * blockSize + lane, blockSize,
                                      around.start[block + 1] - row, 4)
                             .xyz;
        scatterAdd<T>(step.velocity, vertices, 4, gather<T>(step.particles, vertices, 8).w * p);
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
