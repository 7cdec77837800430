// Packs of 4, 8 or 16 floats, or of 2, 4 or 8 doubles, over compiler vectors, and the transposes
// between vertex records and packs of floats. Kernels are written for a number type T and never
// mention this file: they run as double (checks), float, and Pack<n>, with the same bits in every
// lane.
//
// 128-bit loads with in-register transposes halve the time of a projection against scalar code;
// hardware gathers gain nothing (measured on AVX2 and AVX-512). Eigen arrays are not used as lanes:
// their float square root is approximate unless told otherwise.
#pragma once

#include "math.h"

#include <immintrin.h>
#include <utility>

namespace plait {
inline namespace PLAIT_ISA {

// The integer as wide as a number, in which comparisons answer.
template <class S>
struct MaskOf {
    using Integer = int;
};
template <>
struct MaskOf<double> {
    using Integer = long;
};

template <int n, class S = float>
struct Mask {
    typedef typename MaskOf<S>::Integer V __attribute__((vector_size(sizeof(S) * n)));
    V v;
    friend Mask operator&(Mask a, Mask b) { return {a.v & b.v}; }
    friend Mask operator|(Mask a, Mask b) { return {a.v | b.v}; }
};

template <int n, class S = float>
struct Pack {
    typedef S V __attribute__((vector_size(sizeof(S) * n)));
    V v;

    Pack() = default;
    explicit Pack(V lanes) : v(lanes) {}
    template <class Number>
        requires(__is_same(Number, float) || __is_same(Number, double) || __is_same(Number, int))
    explicit Pack(Number s) : v(static_cast<S>(s) - V{}) {}  // s - 0 keeps the sign of zero

    friend Pack operator+(Pack a, Pack b) { return Pack(V(a.v + b.v)); }
    friend Pack operator-(Pack a, Pack b) { return Pack(V(a.v - b.v)); }
    friend Pack operator*(Pack a, Pack b) { return Pack(V(a.v * b.v)); }
    friend Pack operator/(Pack a, Pack b) { return Pack(V(a.v / b.v)); }
    friend Pack operator-(Pack a) { return Pack(V(-a.v)); }
    friend Mask<n, S> operator<(Pack a, Pack b) { return {a.v < b.v}; }
    friend Mask<n, S> operator>(Pack a, Pack b) { return {a.v > b.v}; }
    friend Mask<n, S> operator<=(Pack a, Pack b) { return {a.v <= b.v}; }
    friend Mask<n, S> operator>=(Pack a, Pack b) { return {a.v >= b.v}; }
    friend Mask<n, S> operator==(Pack a, Pack b) { return {a.v == b.v}; }
};

template <int n, class S>
Pack<n, S> select(Mask<n, S> mask, Pack<n, S> yes, Pack<n, S> no) {
    return Pack<n, S>(typename Pack<n, S>::V(mask.v ? yes.v : no.v));
}

// The compilers have no common vector square root; each branch is correctly rounded.
template <int n>
Pack<n> squareRoot(Pack<n> a) {
    using V = typename Pack<n>::V;
    if constexpr (n == 4) {
        return Pack<n>(V(_mm_sqrt_ps(a.v)));
#ifdef __AVX512F__
    } else if constexpr (n == 16) {
        return Pack<n>(V(_mm512_maskz_sqrt_ps(0xffff, a.v)));  // the plain one trips a warning
#endif
#ifdef __AVX__
    } else if constexpr (n == 8) {
        return Pack<n>(V(_mm256_sqrt_ps(a.v)));
#endif
    } else {
        for (int i = 0; i < n; ++i) a.v[i] = __builtin_sqrtf(a.v[i]);
        return a;
    }
}

template <int n>
Pack<n, double> squareRoot(Pack<n, double> a) {
    using V = typename Pack<n, double>::V;
    if constexpr (n == 2) {
        return Pack<n, double>(V(_mm_sqrt_pd(a.v)));
#ifdef __AVX512F__
    } else if constexpr (n == 8) {
        return Pack<n, double>(V(_mm512_maskz_sqrt_pd(0xff, a.v)));
#endif
#ifdef __AVX__
    } else if constexpr (n == 4) {
        return Pack<n, double>(V(_mm256_sqrt_pd(a.v)));
#endif
    } else {
        for (int i = 0; i < n; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
        return a;
    }
}

template <int n, class S>
struct Lanes<Pack<n, S>> {
    using Scalar = S;
    static constexpr int count = n;
};

template <class T>
T load(const Scalar<T>* from) {
    T value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

template <class T>
void store(Scalar<T>* to, const T& value) {
    __builtin_memcpy(to, &value, sizeof value);
}

// Four numbers of a vertex record: a point and what comes with it.
template <class T>
struct Quad {
    Vec<T> xyz;
    T w;
};

namespace detail {

template <int n>
using V = typename Pack<n>::V;

template <int n>
V<n> joined(V<n / 2> low, V<n / 2> high) {
    return [&]<int... i>(std::integer_sequence<int, i...>) {
        return __builtin_shufflevector(low, high, i...);
    }(std::make_integer_sequence<int, n>{});
}

// Records k, k + 4, k + 8, ... side by side, so that 4x4 transposes stay within 128-bit groups.
template <int n>
V<n> side(const float* base, const int* ids, int stride) {
    if constexpr (n == 4) {
        V<4> v;
        __builtin_memcpy(&v, base + static_cast<long>(*ids) * stride, sizeof v);
        return v;
    } else {
        return joined<n>(side<n / 2>(base, ids, stride), side<n / 2>(base, ids + n / 2, stride));
    }
}

// The same of (Xi - X0) + (Di - D0), with wi in the fourth place. Subtracting whole records before
// they are transposed saves three transposes in four.
template <int n>
V<n> sideRelative(const float* base, const int* from, const int* ids) {
    if constexpr (n == 4) {
        const V<4> keep = {1, 1, 1, 0};
        const V<4> x0 = side<4>(base, from, 8), d0 = side<4>(base + 4, from, 8);
        const V<4> x = side<4>(base, ids, 8), d = side<4>(base + 4, ids, 8);
        return (x - keep * x0) + (d - d0);
    } else {
        return joined<n>(sideRelative<n / 2>(base, from, ids),
                         sideRelative<n / 2>(base, from + n / 2, ids + n / 2));
    }
}

template <int n, bool add>
void unside(float* base, const int* ids, int stride, V<n> v) {
    if constexpr (n == 4) {
        if constexpr (add) v = side<4>(base, ids, stride) + v;
        __builtin_memcpy(base + static_cast<long>(*ids) * stride, &v, sizeof v);
    } else {
        [&]<int... i>(std::integer_sequence<int, i...>) {
            unside<n / 2, add>(base, ids, stride, __builtin_shufflevector(v, v, i...));
            unside<n / 2, add>(base, ids + n / 2, stride,
                               __builtin_shufflevector(v, v, (i + n / 2)...));
        }(std::make_integer_sequence<int, n / 2>{});
    }
}

// Within each group of four: elements `from` and `from + step` of a and b, interleaved or joined.
template <int n, bool high>
V<n> interleave(V<n> a, V<n> b) {
    return [&]<int... i>(std::integer_sequence<int, i...>) {
        return __builtin_shufflevector(
            a, b, (i / 4 * 4 + i % 4 / 2 + (high ? 2 : 0) + (i % 2 ? n : 0))...);
    }(std::make_integer_sequence<int, n>{});
}

template <int n, bool high>
V<n> join(V<n> a, V<n> b) {
    return [&]<int... i>(std::integer_sequence<int, i...>) {
        return __builtin_shufflevector(
            a, b, (i / 4 * 4 + i % 2 + (high ? 2 : 0) + (i % 4 > 1 ? n : 0))...);
    }(std::make_integer_sequence<int, n>{});
}

template <int n>
void transpose(Stencil<V<n>, 4>& r) {
    const V<n> a = interleave<n, false>(r[0], r[1]), b = interleave<n, true>(r[0], r[1]);
    const V<n> c = interleave<n, false>(r[2], r[3]), d = interleave<n, true>(r[2], r[3]);
    r = {join<n, false>(a, c), join<n, true>(a, c), join<n, false>(b, d), join<n, true>(b, d)};
}

}  // namespace detail

// Reads record ids[lane] (four scalars at base + stride * id) into each lane.
template <class T>
Quad<T> gather(const Scalar<T>* base, const int* ids, int stride) {
    if constexpr (Lanes<T>::count == 1) {
        const T* r = base + static_cast<long>(*ids) * stride;
        return {{r[0], r[1], r[2]}, r[3]};
    } else {
        constexpr int n = Lanes<T>::count;
        Stencil<detail::V<n>, 4> r;
        for (int k = 0; k < 4; ++k) r[k] = detail::side<n>(base, ids + k, stride);
        detail::transpose<n>(r);
        return {{T(r[0]), T(r[1]), T(r[2])}, T(r[3])};
    }
}

// The sum of `count` records in each lane: ids[lane], ids[lane + step], and so on, in this order.
// Records are added before they are transposed.
template <class T>
Quad<T> gatherSum(const Scalar<T>* base, const int* ids, int step, int count, int stride) {
    if constexpr (Lanes<T>::count == 1) {
        Quad<T> sum{{T(0), T(0), T(0)}, T(0)};
        for (int i = 0; i < count; ++i) {
            const Quad<T> next = gather<T>(base, ids + i * step, stride);
            sum = {sum.xyz + next.xyz, sum.w + next.w};
        }
        return sum;
    } else {
        constexpr int n = Lanes<T>::count;
        Stencil<detail::V<n>, 4> r{};
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < 4; ++k)
                r[k] = r[k] + detail::side<n>(base, ids + i * step + k, stride);
        detail::transpose<n>(r);
        return {{T(r[0]), T(r[1]), T(r[2])}, T(r[3])};
    }
}

// (Xi - X0) + (Di - D0) of the particles ids[lane] and from[lane], and wi: differences of nearby
// numbers, exact or nearly so, in place of coordinates whose digits say where the scene stands.
template <class T>
Quad<T> gatherRelative(const Scalar<T>* base, const int* from, const int* ids) {
    if constexpr (Lanes<T>::count == 1) {
        const T* a = base + static_cast<long>(*from) * 8;
        const T* b = base + static_cast<long>(*ids) * 8;
        return {{(b[0] - a[0]) + (b[4] - a[4]), (b[1] - a[1]) + (b[5] - a[5]),
                 (b[2] - a[2]) + (b[6] - a[6])},
                b[3]};
    } else {
        constexpr int n = Lanes<T>::count;
        Stencil<detail::V<n>, 4> r;
        for (int k = 0; k < 4; ++k) r[k] = detail::sideRelative<n>(base, from + k, ids + k);
        detail::transpose<n>(r);
        return {{T(r[0]), T(r[1]), T(r[2])}, T(r[3])};
    }
}

// Adds v to the first three numbers of each lane's record, and 0 to the fourth. Lanes must name
// different records, or add zeros.
template <class T>
void scatterAdd(Scalar<T>* base, const int* ids, int stride, const Vec<T>& v) {
    if constexpr (Lanes<T>::count == 1) {
        T* r = base + static_cast<long>(*ids) * stride;
        r[0] += v.x, r[1] += v.y, r[2] += v.z;
    } else {
        constexpr int n = Lanes<T>::count;
        Stencil<detail::V<n>, 4> r{v.x.v, v.y.v, v.z.v, detail::V<n>{}};
        detail::transpose<n>(r);
        for (int k = 0; k < 4; ++k) detail::unside<n, true>(base, ids + k, stride, r[k]);
    }
}

// Writes v to each lane's record. Lanes must name different records, or write the same.
template <class T>
void scatter(Scalar<T>* base, const int* ids, int stride, const Quad<T>& v) {
    if constexpr (Lanes<T>::count == 1) {
        T* r = base + static_cast<long>(*ids) * stride;
        r[0] = v.xyz.x, r[1] = v.xyz.y, r[2] = v.xyz.z, r[3] = v.w;
    } else {
        constexpr int n = Lanes<T>::count;
        Stencil<detail::V<n>, 4> r{v.xyz.x.v, v.xyz.y.v, v.xyz.z.v, v.w.v};
        detail::transpose<n>(r);
        for (int k = 0; k < 4; ++k) detail::unside<n, false>(base, ids + k, stride, r[k]);
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
