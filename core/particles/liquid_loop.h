// The inner loops of a liquid: over the particles of a cell, over the nine rows around, over what
// is near in these. Sums are of sixteen lanes in the order of slots, folded at the end, on every
// processor.
#pragma once

#include "liquid_kernels.h"
#include "near.h"

namespace plait {
inline namespace PLAIT_ISA {

// What is evaluated together is in packs as wide as registers are: compilers take wider ones apart
// number by number.
#if defined(__AVX512F__)
using EvaluatedPack = Pack<16>;
#elif defined(__AVX2__)
using EvaluatedPack = Pack<8>;
#else
using EvaluatedPack = Pack<4>;
#endif
template <class Real>
struct EvaluatedOf {
    using T = Real;
};
template <>
struct EvaluatedOf<float> {
    using T = EvaluatedPack;
};
template <class Real>
using Evaluated = typename EvaluatedOf<Real>::T;
template <class Real>
inline constexpr int evaluatedParts = nearWidth / Lanes<Evaluated<Real>>::count;

// A sum of nearWidth lanes, by part.
template <class Real>
using Sum = Stencil<Evaluated<Real>, evaluatedParts<Real>>;

template <class S>
S foldedLanes(S a) {
    return a;
}
template <int n, class S>
S foldedLanes(const Pack<n, S>& a) {
    if constexpr (n == 2) {
        return a.v[0] + a.v[1];
    } else {
        Pack<n / 2, S> half[2];
        __builtin_memcpy(half, &a, sizeof a);
        return foldedLanes(half[0] + half[1]);
    }
}

// Of all lanes: of halves, of quarters, and so on, whatever the parts.
template <class Real>
Real folded(Sum<Real> sum) {
    for (int step = evaluatedParts<Real> / 2; step > 0; step /= 2)
        for (int i = 0; i < step; ++i) sum[i] = sum[i] + sum[i + step];
    return foldedLanes(sum[0]);
}

// Of the cubic spline, by distance r: value, and slope over r.
template <class T>
struct SplineAt {
    T value, pull;
};
template <class T>
SplineAt<T> splineAt(T squared, Scalar<T> perRadius) {
    const T zero(0), r = squareRoot(squared), q = r * T(perRadius);
    const T t = select(q < T(1), T(1) - q, zero);
    const T u = select(q < T(Scalar<T>(0.5)), T(Scalar<T>(0.5)) - q, zero);
    const T tt = t * t, uu = u * u;
    const T slope = (T(24) * uu - T(6) * tt) * T(perRadius);
    return {T(2) * tt * t - T(8) * uu * u, divide(slope, r)};
}

template <class Real>
Vec<Evaluated<Real>> towards(const Near<Real>& near, int part) {
    using T = Evaluated<Real>;
    const int first = part * Lanes<T>::count;
    return {load<T>(near.x + first), load<T>(near.y + first), load<T>(near.z + first)};
}
template <class Real>
Evaluated<Real> numberOf(const Near<Real>& near, int part) {
    return load<Evaluated<Real>>(near.number + part * Lanes<Evaluated<Real>>::count);
}

// Of one cell: a crowd, or, where that would not hold all, the rows around as they lie.
template <class Real>
struct Surroundings {
    Crowd<Real> crowd;
    Points<Real> points;
    int begin[9], end[9], rows;
};

template <class Real>
void survey(const LiquidPass<Real>& pass, const Real* numbers, int cell, Surroundings<Real>& out) {
    const Points<Real> all{pass.x, pass.y, pass.z, numbers};
    const Real squared = pass.radius * pass.radius;
    int total = 0, row = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y, ++row) {
            const int* const start = pass.start + cell + z * pass.layer + y * pass.row;
            out.begin[row] = start[-1];
            out.end[row] = start[2];
            total += start[2] - start[-1];
        }
    out.rows = 9;
    out.points = all;
    if (total > mostInCrowd) return;
    const int first = pass.start[cell], last = pass.start[cell + 1];
    Box<Real> box{{pass.x[first], pass.y[first], pass.z[first]},
                  {pass.x[first], pass.y[first], pass.z[first]}};
    const auto lesser = [](Real a, Real b) { return b < a ? b : a; };
    const auto greater = [](Real a, Real b) { return b > a ? b : a; };
    for (int i = first + 1; i < last; ++i) {
        const Vec<Real> p{pass.x[i], pass.y[i], pass.z[i]};
        box.low = {lesser(box.low.x, p.x), lesser(box.low.y, p.y), lesser(box.low.z, p.z)};
        box.high = {greater(box.high.x, p.x), greater(box.high.y, p.y), greater(box.high.z, p.z)};
    }
    int count = 0;
    for (row = 0; row < 9; ++row)
        for (int s = out.begin[row]; s < out.end[row]; s += lookWidth<Real>)
            count = lookFrom(box, squared, all, s, out.end[row], out.crowd, count);
    out.begin[0] = 0;
    out.end[0] = count;
    out.rows = 1;
    out.points = out.crowd.points();
}

// Calls evaluate(near) with a pack of those near a point at a time, until all have been seen. What
// fills up the last pack is out of the kernel's reach. Inlined, or sums would be kept in memory.
template <class Real, class Evaluate>
[[gnu::always_inline]] inline void eachNear(const Surroundings<Real>& around, const Vec<Real>& at,
                                            Real radius, const Evaluate& evaluate) {
    Near<Real> near;
    int count = 0;
    for (int row = 0; row < around.rows; ++row)
        for (int s = around.begin[row]; s < around.end[row]; s += lookWidth<Real>) {
            count = look(at, radius * radius, around.points, s, around.end[row], near, count);
            if (count < nearWidth) continue;
            evaluate(near);
            count -= nearWidth;
            for (Real* array : {near.x, near.y, near.z, near.number})
                __builtin_memcpy(array, array + nearWidth, nearWidth * sizeof(Real));
        }
    if (count == 0) return;
    for (int i = 0; i < nearWidth; ++i) near.x[count + i] = 2 * radius;
    for (Real* array : {near.y, near.z, near.number})
        for (int i = 0; i < nearWidth; ++i) array[count + i] = 0;
    evaluate(near);
}

template <class Real>
void weigh(const LiquidPass<Real>& pass, const Surroundings<Real>& around, int i) {
    using T = Evaluated<Real>;
    const Real perRadius = 1 / pass.radius, scale = pass.scale;
    Sum<Real> sum{}, others{}, x{}, y{}, z{};
    const auto add = [&](const Near<Real>& near) __attribute__((always_inline)) {
        for (int part = 0; part < evaluatedParts<Real>; ++part) {
            const Vec<T> to = towards(near, part);
            const T squared = dot(to, to);
            const auto [value, pull] = splineAt(squared, perRadius);
            sum[part] = sum[part] + value;
            x[part] = x[part] + pull * to.x;
            y[part] = y[part] + pull * to.y;
            z[part] = z[part] + pull * to.z;
            others[part] = others[part] + pull * pull * squared * numberOf(near, part);
        }
    };
    eachNear(around, {pass.x[i], pass.y[i], pass.z[i]}, pass.radius, add);
    const Real* const wall = pass.wall + 4 * static_cast<long>(i);
    const Real value = scale * folded<Real>(sum) + wall[3] - 1;
    const Vec<Real> gradient{scale * folded<Real>(x) + wall[0], scale * folded<Real>(y) + wall[1],
                             scale * folded<Real>(z) + wall[2]};
    const Real inverse =
        pass.inverse[i] * dot(gradient, gradient) + scale * scale * folded<Real>(others);
    const Real safe = inverse > pass.least ? inverse : pass.least;
    pass.lambda[i] = value > 0 ? -pass.relaxation * value / safe : Real(0);
}

template <class Real>
void move(const LiquidPass<Real>& pass, const Surroundings<Real>& around, int i) {
    using T = Evaluated<Real>;
    const Real perRadius = 1 / pass.radius, scale = pass.scale, lambda = pass.lambda[i];
    Sum<Real> x{}, y{}, z{};
    const auto add = [&](const Near<Real>& near) __attribute__((always_inline)) {
        for (int part = 0; part < evaluatedParts<Real>; ++part) {
            const Vec<T> to = towards(near, part);
            const T push =
                splineAt(dot(to, to), perRadius).pull * (T(lambda) + numberOf(near, part));
            x[part] = x[part] + push * to.x;
            y[part] = y[part] + push * to.y;
            z[part] = z[part] + push * to.z;
        }
    };
    eachNear(around, {pass.x[i], pass.y[i], pass.z[i]}, pass.radius, add);
    const Real* const wall = pass.wall + 4 * static_cast<long>(i);
    Real* const d = pass.particles + 8 * static_cast<long>(pass.vertex[i]) + 4;
    d[0] += pass.inverse[i] * (scale * folded<Real>(x) + lambda * wall[0]);
    d[1] += pass.inverse[i] * (scale * folded<Real>(y) + lambda * wall[1]);
    d[2] += pass.inverse[i] * (scale * folded<Real>(z) + lambda * wall[2]);
}

// Of all particles of occupied cells begin .. end - 1.
template <class Real>
void weighCells(const LiquidPass<Real>& pass, int begin, int end) {
    Surroundings<Real> around;
    for (int c = begin; c < end; ++c) {
        const int cell = pass.occupied[c];
        survey(pass, pass.inverse, cell, around);
        for (int i = pass.start[cell]; i < pass.start[cell + 1]; ++i) weigh(pass, around, i);
    }
}

template <class Real>
void moveCells(const LiquidPass<Real>& pass, int begin, int end) {
    Surroundings<Real> around;
    for (int c = begin; c < end; ++c) {
        const int cell = pass.occupied[c];
        survey<Real>(pass, pass.lambda, cell, around);
        for (int i = pass.start[cell]; i < pass.start[cell + 1]; ++i) move(pass, around, i);
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
