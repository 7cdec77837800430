// Who is near, of those in the 27 cells around: first a crowd for all particles of a cell, of those
// near enough to the box around them; then for each of these those within the kernel's radius,
// packed side by side. Three in twenty of the 27 cells' are, and only they cost a square root and a
// division; half are in the crowd.
#pragma once

#include "../numbers/lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

// As many as are looked at together.
#if defined(__AVX512F__)
using LookPack = Pack<16>;
#elif defined(__AVX2__)
using LookPack = Pack<8>;
#else
using LookPack = float;
#endif
template <class Real>
struct LookOf {
    using T = Real;
};
template <>
struct LookOf<float> {
    using T = LookPack;
};
template <class Real>
inline constexpr int lookWidth = Lanes<typename LookOf<Real>::T>::count;

// By lane, a bit: a < b, of the first `left` lanes.
template <class S>
unsigned below(S a, S b, int) {
    return a < b;
}
// Writes the lanes whose bits are set side by side, and anything up to a pack's width behind.
template <class S>
void squeeze(S* to, S v, unsigned) {
    *to = v;
}

#if defined(__AVX512F__)

inline unsigned below(Pack<16> a, Pack<16> b, int left) {
    const auto in = static_cast<__mmask16>(left < 16 ? (1 << left) - 1 : 0xffff);
    return _mm512_mask_cmp_ps_mask(in, a.v, b.v, _CMP_LT_OQ);
}
// In a register first: packing into memory takes some processors a hundred times longer.
inline void squeeze(float* to, Pack<16> v, unsigned bits) {
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(static_cast<__mmask16>(bits), v.v));
}

#elif defined(__AVX2__)

// By bits: their places, lowest first.
struct Places {
    alignas(32) int of[256][8];
};
inline constexpr Places places = [] {
    Places p{};
    for (int bits = 0; bits < 256; ++bits) {
        int n = 0;
        for (int bit = 0; bit < 8; ++bit)
            if (bits >> bit & 1) p.of[bits][n++] = bit;
    }
    return p;
}();

inline unsigned below(Pack<8> a, Pack<8> b, int left) {
    const int in = _mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ));
    return static_cast<unsigned>(in & (left < 8 ? (1 << left) - 1 : 0xff));
}
inline void squeeze(float* to, Pack<8> v, unsigned bits) {
    const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(places.of[bits]));
    _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(v.v, order));
}

#endif

// Particles side by side, and a number that goes with each. Readable a pack behind the last.
template <class Real>
struct Points {
    const Real *x, *y, *z;  // m
    const Real* number;
};
template <class Real, int n>
struct Bag {
    alignas(64) Real x[n], y[n], z[n], number[n];
    Points<Real> points() const { return {x, y, z, number}; }
    template <class T>
    void add(int count, const Vec<T>& p, const T& carried, unsigned bits) {
        squeeze(x + count, p.x, bits);
        squeeze(y + count, p.y, bits);
        squeeze(z + count, p.z, bits);
        squeeze(number + count, carried, bits);
    }
};

inline constexpr int nearWidth = 16;  // evaluated at a time
inline constexpr int mostInCrowd = 1024;

// From each to us (m), of those found and not yet evaluated: fewer than nearWidth, but for what the
// last look added.
template <class Real>
using Near = Bag<Real, 2 * nearWidth>;
// Where they are.
template <class Real>
using Crowd = Bag<Real, mostInCrowd + nearWidth>;

// Looks at a pack of those from `begin` to `end`, appends those that are near to the `count` found
// before, and returns how many there are then.
template <class Real>
int look(const Vec<Real>& at, Real radiusSquared, const Points<Real>& from, int begin, int end,
         Near<Real>& near, int count) {
    using T = typename LookOf<Real>::T;
    const Vec<T> to{T(at.x) - load<T>(from.x + begin), T(at.y) - load<T>(from.y + begin),
                    T(at.z) - load<T>(from.z + begin)};
    const unsigned bits = below(dot(to, to), T(radiusSquared), end - begin);
    near.add(count, to, load<T>(from.number + begin), bits);
    return count + __builtin_popcount(bits);
}

template <class Real>
struct Box {
    Vec<Real> low, high;  // m
};

// The same of those near to a box: rounded as look() rounds, it leaves out none that are near to
// what is in it.
template <class Real>
int lookFrom(const Box<Real>& box, Real radiusSquared, const Points<Real>& from, int begin, int end,
             Crowd<Real>& crowd, int count) {
    using T = typename LookOf<Real>::T;
    const auto beyond = [](Real low, Real high, T x) {
        const T under = T(low) - x, over = x - T(high), zero(0);
        return select(under > zero, under, select(over > zero, over, zero));
    };
    const Vec<T> p{load<T>(from.x + begin), load<T>(from.y + begin), load<T>(from.z + begin)};
    const Vec<T> off{beyond(box.low.x, box.high.x, p.x), beyond(box.low.y, box.high.y, p.y),
                     beyond(box.low.z, box.high.z, p.z)};
    const unsigned bits = below(dot(off, off), T(radiusSquared), end - begin);
    crowd.add(count, p, load<T>(from.number + begin), bits);
    return count + __builtin_popcount(bits);
}

}  // namespace PLAIT_ISA
}  // namespace plait
