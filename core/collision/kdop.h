// Bounds of what a simplex sweeps in a step: discrete oriented polytopes (Klosowski, Held,
// Mitchell, Sowizral, Zikan, Efficient collision detection using bounding volume hierarchies of
// k-DOPs, 1998).
#pragma once

#include "../numbers/math.h"

#include <xmmintrin.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace plait {

// The step as bounds see it. Bounds can be compared if they have the same origin.
struct Travel {
    std::span<const Vec<double>> start, end;  // of every vertex, m; each moves along a line
    double radius = 0;                        // half the thickness, m, at least 0
    Vec<double> origin{};                     // m; bounds are 5e-7 of the way from it too wide
};

// k / 2 slabs low <= direction . (x - origin) <= high: 6 the axes (AABB), 14 and the diagonals of a
// cube, 18 the axes and the diagonals of its faces, 26 all of them. Directions have coordinates -1,
// 0, 1, not unit length.
template <int k>
struct KDop {
    static_assert(k == 6 || k == 14 || k == 18 || k == 26);
    static constexpr int slabs = k / 2;
    static constexpr int padded = (slabs + 3) / 4 * 4;  // whole registers; the rest stays 0
    static constexpr float infinity = std::numeric_limits<float>::infinity();

    alignas(16) float low[padded]{}, high[padded]{};

    static KDop nothing() { return filled(infinity); }
    static KDop everything() { return filled(-infinity); }

    void include(const KDop& b) {
        for (int i = 0; i < padded; ++i) low[i] = std::min(low[i], b.low[i]);
        for (int i = 0; i < padded; ++i) high[i] = std::max(high[i], b.high[i]);
    }

    // Closed: bounds that touch overlap.
    bool overlaps(const KDop& b) const {
        __m128 apart = _mm_setzero_ps();
        for (int i = 0; i < padded; i += 4) {
            apart = _mm_or_ps(apart, _mm_cmpgt_ps(_mm_load_ps(low + i), _mm_load_ps(b.high + i)));
            apart = _mm_or_ps(apart, _mm_cmpgt_ps(_mm_load_ps(b.low + i), _mm_load_ps(high + i)));
        }
        return _mm_movemask_ps(apart) == 0;
    }

    // Twice as far from the origin, and 0 along what is not finite.
    Vec<float> centre() const {
        const auto middle = [&](int i) {
            const float sum = low[i] + high[i];
            return std::isfinite(sum) ? sum : 0.0F;
        };
        return {middle(0), middle(1), middle(2)};
    }

private:
    static KDop filled(float a) {
        KDop bounds;
        std::fill_n(bounds.low, slabs, a);
        std::fill_n(bounds.high, slabs, -a);
        return bounds;
    }
};

// Bounds of what moves along straight lines where it starts and where it ends. What a slab's
// direction has in order at both ends, lowest against highest, it has in order all the way: what
// moves alike does not meet, however far it goes.
template <int k>
struct MovingKDop {
    KDop<k> start, end;

    static MovingKDop nothing() { return {KDop<k>::nothing(), KDop<k>::nothing()}; }
    void include(const MovingKDop& b) {
        start.include(b.start);
        end.include(b.end);
    }
    bool overlaps(const MovingKDop& b) const {
        __m128 apart = _mm_setzero_ps();
        const auto above = [&](const float* low, const float* high) {
            return _mm_cmpgt_ps(_mm_load_ps(low), _mm_load_ps(high));
        };
        for (int i = 0; i < KDop<k>::padded; i += 4) {
            apart = _mm_or_ps(apart, _mm_and_ps(above(start.low + i, b.start.high + i),
                                                above(end.low + i, b.end.high + i)));
            apart = _mm_or_ps(apart, _mm_and_ps(above(b.start.low + i, start.high + i),
                                                above(b.end.low + i, end.high + i)));
        }
        return _mm_movemask_ps(apart) == 0;
    }
    Vec<float> centre() const { return start.centre(); }
};

namespace detail {

// The slabs of a point.
template <int k>
KDop<k> pointBounds(const Vec<float>& p) {
    KDop<k> at;
    float* to = at.low;
    for (const float a : {p.x, p.y, p.z}) *to++ = a;
    if constexpr (k == 14 || k == 26) {
        const float plus = p.x + p.y, minus = p.x - p.y;
        for (const float a : {plus + p.z, plus - p.z, minus + p.z, minus - p.z}) *to++ = a;
    }
    if constexpr (k == 18 || k == 26)
        for (const float a : {p.x + p.y, p.x - p.y, p.y + p.z, p.y - p.z, p.z + p.x, p.z - p.x})
            *to++ = a;
    std::copy_n(at.low, KDop<k>::slabs, at.high);
    return at;
}

// The length of a slab's direction.
template <int k>
constexpr float directionLength(int slab) {
    constexpr float face = 1.41421356F, cube = 1.73205081F;
    return slab < 3 ? 1 : k == 18 || slab >= 7 ? face : cube;
}

}  // namespace detail

// Contains every point within the radius of where the simplex is between start and end: two
// simplices that come as close as their radii together have bounds that overlap, however things
// round. What is not finite, or beyond 1e37 m, overlaps everything.
template <int k>
KDop<k> sweptBounds(std::span<const int> vertices, const Travel& travel) {
    KDop<k> bounds = KDop<k>::nothing();
    const float radius = static_cast<float>(travel.radius);
    float size = 2 * radius;
    for (const int v : vertices)
        for (const Vec<double>& x : {travel.start[v], travel.end[v]}) {
            const Vec<double> d = x - travel.origin;
            const Vec<float> p{static_cast<float>(d.x), static_cast<float>(d.y),
                               static_cast<float>(d.z)};
            const float s =
                __builtin_fabsf(p.x) + __builtin_fabsf(p.y) + __builtin_fabsf(p.z) + 2 * radius;
            if (!(s < 1e37F)) return KDop<k>::everything();
            size = std::max(size, s);
            bounds.include(detail::pointBounds<k>(p));
        }
    // A conversion, two sums and the thickness lose less than 6 2^-24 of size, and 2^-120 where
    // they underflow; a slab is widened by 8 2^-24.
    const float rounding = 0x1p-21F * size + 0x1p-120F;
    for (int i = 0; i < KDop<k>::slabs; ++i) {
        const float reach = radius * detail::directionLength<k>(i) + rounding;
        bounds.low[i] -= reach;
        bounds.high[i] += reach;
    }
    return bounds;
}

}  // namespace plait
