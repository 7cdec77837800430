// Those of a row of particles that are within a kernel's radius, packed side by side: of 27 cells
// three particles in twenty are, and only these cost a square root and a division.
#pragma once

#include "../numbers/lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

inline constexpr int nearWidth = 16;  // evaluated at a time

// Found and not yet evaluated: fewer than nearWidth, but for what the last look added.
template <class Real>
struct Near {
    alignas(64) Real x[2 * nearWidth], y[2 * nearWidth], z[2 * nearWidth];  // m, from it to us
    alignas(64) Real number[2 * nearWidth];                                 // that goes with it
};

// Where we are, and what of others is looked at.
template <class Real>
struct Looker {
    Real x, y, z;              // m
    Real squared;              // m^2, of the radius
    const Real *xs, *ys, *zs;  // m, by slot
    const Real* numbers;       // by slot
};

// look() looks at `lookWidth` slots of a row from `begin` on, appends what is near to the `count`
// found before, and returns how many there are then.
#if defined(__AVX512F__)

template <class Real>
inline constexpr int lookWidth = sizeof(Real) == sizeof(float) ? 16 : 1;

inline int look(const Looker<float>& at, int begin, int end, Near<float>& near, int count) {
    const int left = end - begin;
    const auto inRow = static_cast<__mmask16>(left < 16 ? (1 << left) - 1 : 0xffff);
    const __m512 x = _mm512_sub_ps(_mm512_set1_ps(at.x), _mm512_loadu_ps(at.xs + begin));
    const __m512 y = _mm512_sub_ps(_mm512_set1_ps(at.y), _mm512_loadu_ps(at.ys + begin));
    const __m512 z = _mm512_sub_ps(_mm512_set1_ps(at.z), _mm512_loadu_ps(at.zs + begin));
    const __m512 squared =
        _mm512_add_ps(_mm512_add_ps(_mm512_mul_ps(x, x), _mm512_mul_ps(y, y)), _mm512_mul_ps(z, z));
    const __mmask16 in =
        _mm512_mask_cmp_ps_mask(inRow, squared, _mm512_set1_ps(at.squared), _CMP_LT_OQ);
    // Packed in a register first: packing into memory takes some processors a hundred times longer.
    const auto keep = [&](float* to, __m512 v) {
        _mm512_storeu_ps(to + count, _mm512_maskz_compress_ps(in, v));
    };
    keep(near.x, x);
    keep(near.y, y);
    keep(near.z, z);
    keep(near.number, _mm512_loadu_ps(at.numbers + begin));
    return count + __builtin_popcount(static_cast<unsigned>(in));
}

#elif defined(__AVX2__)

template <class Real>
inline constexpr int lookWidth = sizeof(Real) == sizeof(float) ? 8 : 1;

// By mask: the places of its bits, lowest first.
struct Places {
    alignas(32) int of[256][8];
};
inline constexpr Places places = [] {
    Places p{};
    for (int mask = 0; mask < 256; ++mask) {
        int n = 0;
        for (int bit = 0; bit < 8; ++bit)
            if (mask >> bit & 1) p.of[mask][n++] = bit;
    }
    return p;
}();

inline int look(const Looker<float>& at, int begin, int end, Near<float>& near, int count) {
    const int left = end - begin;
    const __m256 x = _mm256_sub_ps(_mm256_set1_ps(at.x), _mm256_loadu_ps(at.xs + begin));
    const __m256 y = _mm256_sub_ps(_mm256_set1_ps(at.y), _mm256_loadu_ps(at.ys + begin));
    const __m256 z = _mm256_sub_ps(_mm256_set1_ps(at.z), _mm256_loadu_ps(at.zs + begin));
    const __m256 squared =
        _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y)), _mm256_mul_ps(z, z));
    const int close =
        _mm256_movemask_ps(_mm256_cmp_ps(squared, _mm256_set1_ps(at.squared), _CMP_LT_OQ));
    const int in = close & (left < 8 ? (1 << left) - 1 : 0xff);
    const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(places.of[in]));
    const auto keep = [&](float* to, __m256 v) {
        _mm256_storeu_ps(to + count, _mm256_permutevar8x32_ps(v, order));
    };
    keep(near.x, x);
    keep(near.y, y);
    keep(near.z, z);
    keep(near.number, _mm256_loadu_ps(at.numbers + begin));
    return count + __builtin_popcount(static_cast<unsigned>(in));
}

#else

template <class Real>
inline constexpr int lookWidth = 1;

#endif

template <class Real>
int look(const Looker<Real>& at, int begin, int, Near<Real>& near, int count) {
    const Real x = at.x - at.xs[begin], y = at.y - at.ys[begin], z = at.z - at.zs[begin];
    near.x[count] = x;
    near.y[count] = y;
    near.z[count] = z;
    near.number[count] = at.numbers[begin];
    return count + ((x * x + y * y) + z * z < at.squared);
}

}  // namespace PLAIT_ISA
}  // namespace plait
