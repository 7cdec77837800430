// The loops of the air that a sheet carries: over triangles, and over the vertices that they are
// around. What they are for is in carried_air.h.
#pragma once

#include "air_loop.h"

namespace plait {
inline namespace PLAIT_ISA {

// The number of each lane's id.
template <class T>
T pick(const Scalar<T>* numbers, const int* ids) {
    Scalar<T> picked[Lanes<T>::count];
    for (int k = 0; k < Lanes<T>::count; ++k) picked[k] = numbers[ids[k]];
    return load<T>(picked);
}

// Of vertices in ascending order, those that fill up a block last, all of them the padding vertex.
template <class T>
void put(Scalar<T>* numbers, const int* ids, T value) {
    Scalar<T> each[Lanes<T>::count];
    store<T>(each, value);
    for (int k = 0; k < Lanes<T>::count; ++k) numbers[ids[k]] = each[k];
}

// With N the linear function that is 1 at a corner, area (a . grad) N is a . (n x e) / 2, n the
// unit normal and e the side across.
template <class T>
[[gnu::flatten]] void writeWays(const AirStep<Scalar<T>>& step,
                                const FacetBlocks<Scalar<T>>& facets,
                                const CarriedBlocks<Scalar<T>>& carried, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int lane = n % blockSize;
        const int* ids = facets.ids + 3 * (n - lane) + lane;
        const Vec<T> first = gatherRelative<T>(step.particles, ids, ids + blockSize).xyz,
                     second = gatherRelative<T>(step.particles, ids, ids + 2 * blockSize).xyz,
                     side = gather<T>(facets.sides + 4 * n, consecutive, 4).xyz,
                     air = airAt<T>(step, facets, n),
                     along = air -
                             T(1.0 / 3) * gatherSum<T>(carried.velocity, ids, blockSize, 3, 4).xyz;
        const T size = length(side);
        const Vec<T> turned = cross(along, divide(T(0.5), size) * side);
        const T toFirst = -dot(turned, second), toSecond = dot(turned, first),
                toOrigin = -(toFirst + toSecond);
        const auto magnitude = [](T a) { return select(a < T(0), -a, a); };
        const auto larger = [](T a, T b) { return select(a < b, b, a); };
        const T perArea = member<T>(facets.rows + 5 * (n - lane) + lane, 1);
        const T rate =
            perArea * larger(magnitude(toOrigin), larger(magnitude(toFirst), magnitude(toSecond)));
        const T most(carried.fastest), part = select(rate > most, divide(most, rate), T(1));
        scatter<T>(carried.ways + 4 * n, consecutive, 4,
                   {part * Vec<T>{toOrigin, toFirst, toSecond}, dot(side, air)});
        store<T>(carried.rates + n, part * rate);
    }
}

template <class T>
[[gnu::flatten]] void writeSlopes(const FacetBlocks<Scalar<T>>& facets,
                                  const CarriedBlocks<Scalar<T>>& carried, const Scalar<T>* field,
                                  int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int lane = n % blockSize;
        const int* ids = facets.ids + 3 * (n - lane) + lane;
        const T origin = pick<T>(field, ids);
        const Vec<T> way = gather<T>(carried.ways + 4 * n, consecutive, 4).xyz;
        const T change = way.y * (pick<T>(field, ids + blockSize) - origin) +
                         way.z * (pick<T>(field, ids + 2 * blockSize) - origin);
        store<T>(carried.slopes + n, T(1.0 / 3) * change);
    }
}

// The sum over what is around the vertex at place n.
template <class T>
Quad<T> sumAround(const AroundBlocks<Scalar<T>>& around, const Scalar<T>* records, int n) {
    const int lane = n % blockSize, block = n / blockSize, row = around.start[block];
    return gatherSum<T>(records, around.facets + row * blockSize + lane, blockSize,
                        around.start[block + 1] - row, 4);
}

template <class T>
[[gnu::flatten]] void writeCarried(const AroundBlocks<Scalar<T>>& around,
                                   const CarriedBlocks<Scalar<T>>& carried, Scalar<T> seconds,
                                   const Scalar<T>* from, Scalar<T>* to, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int lane = n % blockSize, block = n / blockSize;
        const int* vertices = around.vertices + n;
        T slope = T(0);
        for (int row = around.start[block]; row < around.start[block + 1]; ++row)
            slope = slope + pick<T>(carried.slopes, around.facets + row * blockSize + lane);
        const T part = T(seconds) * load<T>(carried.open + n);
        put<T>(to, vertices, pick<T>(from, vertices) - part * slope);
    }
}

template <class T>
[[gnu::flatten]] void writeNormals(const AirStep<Scalar<T>>&, const FacetBlocks<Scalar<T>>& facets,
                                   const AroundBlocks<Scalar<T>>& around,
                                   const CarriedBlocks<Scalar<T>>& carried, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const Vec<T> area = sumAround<T>(around, facets.sides, n).xyz;
        const T inverse = divide(T(1), length(area));
        scatter<T>(carried.normals + 4 * n, consecutive, 4,
                   {inverse * area, inverse * sumAround<T>(around, carried.ways, n).w});
    }
}

template <class T>
[[gnu::flatten]] void writeRight(const AirStep<Scalar<T>>& step, const FacetBlocks<Scalar<T>>&,
                                 const AroundBlocks<Scalar<T>>& around,
                                 const CarriedBlocks<Scalar<T>>& carried, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int* vertices = around.vertices + n;
        const Quad<T> normal = gather<T>(carried.normals + 4 * n, consecutive, 4);
        const T area = load<T>(carried.areas + n), w = gather<T>(step.particles, vertices, 8).w,
                p = pick<T>(carried.momentum, vertices),
                u = dot(normal.xyz, gather<T>(carried.velocity, vertices, 4).xyz) - normal.w;
        store<T>(carried.right + n, area * (u + w * area * p));
    }
}

template <class T>
[[gnu::flatten]] void writeExchanged(const AirStep<Scalar<T>>& step, const FacetBlocks<Scalar<T>>&,
                                     const AroundBlocks<Scalar<T>>& around,
                                     const CarriedBlocks<Scalar<T>>& carried, int begin, int end) {
    for (int n = begin; n < end; n += Lanes<T>::count) {
        const int* vertices = around.vertices + n;
        const Vec<T> normal = gather<T>(carried.normals + 4 * n, consecutive, 4).xyz;
        const T left = T(carried.mass) * load<T>(carried.phi + n),
                w = gather<T>(step.particles, vertices, 8).w;
        const T given = load<T>(carried.areas + n) * (pick<T>(carried.momentum, vertices) - left);
        const Vec<T> change = (w * given) * normal;
        scatterAdd<T>(carried.velocity, vertices, 4, change);
        if (carried.other) scatterAdd<T>(carried.other, vertices, 4, change);
        put<T>(carried.momentum, vertices, left);
        scatter<T>(carried.impulses + 4 * n, consecutive, 4, {given * normal, T(0)});
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
