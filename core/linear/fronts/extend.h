// Extend-add: the Schur complement of a child goes into the front of its parent, of whose rows it
// has some, in the same order. Strip by strip they are moved by permutations known beforehand.
#pragma once

#include "strips.h"

namespace plait {
inline namespace PLAIT_ISA {

// Adds one column of the child's strip to one of the parent's.
template <class T>
class Move {
public:
    explicit Move(const Overlap& overlap) : overlap_(overlap) {}

    void operator()(float* to, const float* from) const {
        for (int i = 0; i < stripRows; ++i)
            if (overlap_.mask >> i & 1) to[i] += from[overlap_.lane[i]];
    }

private:
    const Overlap& overlap_;
};

#ifdef __AVX2__
// Each half of the lanes from either half, chosen by sign bits.
template <>
class Move<Pack<8>> {
public:
    explicit Move(const Overlap& overlap) {
        const __m256i shift = _mm256_setr_epi32(31, 30, 29, 28, 27, 26, 25, 24);
        for (int half = 0; half < 2; ++half) {
            lanes_[half] = _mm256_cvtepu8_epi32(
                _mm_loadl_epi64(reinterpret_cast<const __m128i*>(overlap.lane + 8 * half)));
            fromHigh_[half] = _mm256_castsi256_ps(_mm256_slli_epi32(lanes_[half], 28));
            const __m256i mask = _mm256_set1_epi32(overlap.mask >> 8 * half);
            mask_[half] = _mm256_castsi256_ps(_mm256_sllv_epi32(mask, shift));
        }
    }

    void operator()(float* to, const float* from) const {
        const __m256 low = _mm256_loadu_ps(from), high = _mm256_loadu_ps(from + 8);
        for (int half = 0; half < 2; ++half) {
            const __m256 moved =
                _mm256_blendv_ps(_mm256_permutevar8x32_ps(low, lanes_[half]),
                                 _mm256_permutevar8x32_ps(high, lanes_[half]), fromHigh_[half]);
            const __m256 before = _mm256_loadu_ps(to + 8 * half);
            _mm256_storeu_ps(to + 8 * half,
                             _mm256_blendv_ps(before, _mm256_add_ps(before, moved), mask_[half]));
        }
    }

private:
    __m256i lanes_[2];
    __m256 fromHigh_[2], mask_[2];
};
#endif

#ifdef __AVX512F__
template <>
class Move<Pack<16>> {
public:
    explicit Move(const Overlap& overlap)
        : mask_(overlap.mask),
          lanes_(_mm512_maskz_cvtepu8_epi32(
              0xffff, _mm_loadu_si128(reinterpret_cast<const __m128i*>(overlap.lane)))) {}

    void operator()(float* to, const float* from) const {
        const __m512 before = _mm512_loadu_ps(to);
        const __m512 moved = _mm512_maskz_permutexvar_ps(0xffff, lanes_, _mm512_loadu_ps(from));
        _mm512_storeu_ps(to, _mm512_mask_add_ps(before, mask_, before, moved));
    }

private:
    __mmask16 mask_;
    __m512i lanes_;
};
#endif

template <class T>
void extend(const Extension& e, int begin, int end, int firstStrip, int firstColumn) {
    for (int s = begin / stripRows; s < e.strips; ++s) {
        const float* const from = e.schur + stripRows * columnsBefore(s);
        for (int o = e.firstOverlap[s]; o < e.firstOverlap[s + 1]; ++o) {
            const Overlap& overlap = e.overlaps[o];
            const int last = overlap.end < end ? overlap.end : end;
            if (begin >= last) continue;
            float* const to = firstStrip ? schurStrip(e.parent, overlap.strip - firstStrip)
                                         : panelStrip(e.parent, overlap.strip);
            const Move<T> move(overlap);
            for (int c = begin; c < last; ++c)
                move(to + stripRows * (e.inParent[c] - firstColumn), from + stripRows * c);
        }
    }
}

template <class T>
void extendPanel(const Extension& e, int begin, int end) {
    extend<T>(e, begin, end, 0, 0);
}

template <class T>
void extendComplement(const Extension& e, int begin, int end) {
    extend<T>(e, begin, end, e.parent.pivotStrips, e.parent.pivotStrips * stripRows);
}

}  // namespace PLAIT_ISA
}  // namespace plait
