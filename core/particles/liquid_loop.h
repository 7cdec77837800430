// The inner loops of a liquid: over the particles of a cell, over the nine rows around, over what
// is near in these. Sums are of sixteen lanes in the order of slots, folded at the end, on every
// processor.
#pragma once

#include "liquid_kernels.h"
#include "near.h"

namespace plait {
inline namespace PLAIT_ISA {

template <class Real>
using NearPack = Pack<nearWidth, Real>;

template <int n, class S>
Pack<n, S> rootOf(Pack<n, S> a) {
    // The widest root that there is; packs are made of as many as it takes.
#if defined(__AVX512F__)
    constexpr int most = 64 / sizeof(S);
#elif defined(__AVX__)
    constexpr int most = 32 / sizeof(S);
#else
    constexpr int most = 16 / sizeof(S);
#endif
    if constexpr (n <= most) {
        return squareRoot(a);
    } else {
        using Half = Pack<n / 2, S>;
        Half half[2];
        __builtin_memcpy(half, &a, sizeof a);
        half[0] = rootOf(half[0]);
        half[1] = rootOf(half[1]);
        __builtin_memcpy(&a, half, sizeof a);
        return a;
    }
}

// The sum of all lanes: of halves, of quarters, and so on.
template <int n, class S>
S folded(const Pack<n, S>& a) {
    if constexpr (n == 2) {
        return a.v[0] + a.v[1];
    } else {
        Pack<n / 2, S> half[2];
        __builtin_memcpy(half, &a, sizeof a);
        return folded(half[0] + half[1]);
    }
}

// Of the cubic spline, by distance r: value, and slope over r.
template <class T>
struct SplineAt {
    T value, pull;
};
template <class T>
SplineAt<T> splineAt(T squared, Scalar<T> perRadius) {
    const T zero(0), r = rootOf(squared), q = r * T(perRadius);
    const T t = select(q < T(1), T(1) - q, zero);
    const T u = select(q < T(Scalar<T>(0.5)), T(Scalar<T>(0.5)) - q, zero);
    const T tt = t * t, uu = u * u;
    const T slope = (T(24) * uu - T(6) * tt) * T(perRadius);
    return {T(2) * tt * t - T(8) * uu * u, divide(slope, r)};
}

template <class T>
Vec<T> towards(const Near<Scalar<T>>& near) {
    return {load<T>(near.x), load<T>(near.y), load<T>(near.z)};
}

// Calls evaluate() whenever `near` holds a pack of what is near, until all around one of the cell
// has been seen. `at` says who looks. What fills up the last pack is out of the kernel's reach.
template <class Real, class Evaluate>
void eachNear(const LiquidPass<Real>& pass, const Looker<Real>& at, int cell, Near<Real>& near,
              const Evaluate& evaluate) {
    int count = 0;
    for (int layer = -pass.layer; layer <= pass.layer; layer += pass.layer)
        for (int row = -pass.row; row <= pass.row; row += pass.row) {
            const int end = pass.start[cell + layer + row + 2];
            for (int s = pass.start[cell + layer + row - 1]; s < end; s += lookWidth<Real>) {
                count = look(at, s, end, near, count);
                if (count < nearWidth) continue;
                evaluate();
                count -= nearWidth;
                for (Real* array : {near.x, near.y, near.z, near.number})
                    __builtin_memcpy(array, array + nearWidth, nearWidth * sizeof(Real));
            }
        }
    if (count == 0) return;
    for (; count < nearWidth; ++count) {
        near.x[count] = 2 * pass.radius;
        near.y[count] = near.z[count] = near.number[count] = 0;
    }
    evaluate();
}

template <class Real>
void weighCells(const LiquidPass<Real>& pass, int begin, int end) {
    using T = NearPack<Real>;
    const Real perRadius = 1 / pass.radius, scale = pass.scale;
    Near<Real> near;
    Looker<Real> at{0, 0, 0, pass.radius * pass.radius, pass.x, pass.y, pass.z, pass.inverse};
    for (int c = begin; c < end; ++c) {
        const int cell = pass.occupied[c];
        for (int i = pass.start[cell]; i < pass.start[cell + 1]; ++i) {
            at.x = pass.x[i], at.y = pass.y[i], at.z = pass.z[i];
            T sum(0), others(0);
            Vec<T> own{T(0), T(0), T(0)};
            eachNear(pass, at, cell, near, [&] {
                const Vec<T> to = towards<T>(near);
                const T squared = dot(to, to);
                const auto [value, pull] = splineAt(squared, perRadius);
                sum = sum + value;
                own += pull * to;
                others = others + pull * pull * squared * load<T>(near.number);
            });
            const Real* const wall = pass.wall + 4 * static_cast<long>(i);
            const Real value = scale * folded(sum) + wall[3] - 1;
            const Vec<Real> gradient{scale * folded(own.x) + wall[0],
                                     scale * folded(own.y) + wall[1],
                                     scale * folded(own.z) + wall[2]};
            const Real inverse =
                pass.inverse[i] * dot(gradient, gradient) + scale * scale * folded(others);
            const Real safe = inverse > pass.least ? inverse : pass.least;
            pass.lambda[i] = value > 0 ? -pass.relaxation * value / safe : Real(0);
        }
    }
}

template <class Real>
void moveCells(const LiquidPass<Real>& pass, int begin, int end) {
    using T = NearPack<Real>;
    const Real perRadius = 1 / pass.radius, scale = pass.scale;
    Near<Real> near;
    Looker<Real> at{0, 0, 0, pass.radius * pass.radius, pass.x, pass.y, pass.z, pass.lambda};
    for (int c = begin; c < end; ++c) {
        const int cell = pass.occupied[c];
        for (int i = pass.start[cell]; i < pass.start[cell + 1]; ++i) {
            if (pass.inverse[i] == 0) continue;
            at.x = pass.x[i], at.y = pass.y[i], at.z = pass.z[i];
            const Real lambda = pass.lambda[i];
            Vec<T> sum{T(0), T(0), T(0)};
            eachNear(pass, at, cell, near, [&] {
                const Vec<T> to = towards<T>(near);
                const auto [value, pull] = splineAt(dot(to, to), perRadius);
                sum += pull * (T(lambda) + load<T>(near.number)) * to;
            });
            const Real* const wall = pass.wall + 4 * static_cast<long>(i);
            Real* const d = pass.particles + 8 * static_cast<long>(pass.vertex[i]) + 4;
            d[0] += pass.inverse[i] * (scale * folded(sum.x) + lambda * wall[0]);
            d[1] += pass.inverse[i] * (scale * folded(sum.y) + lambda * wall[1]);
            d[2] += pass.inverse[i] * (scale * folded(sum.z) + lambda * wall[2]);
        }
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
