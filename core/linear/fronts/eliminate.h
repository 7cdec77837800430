// Elimination of the pivots of one front, in blocks as wide as a strip is high: element (r, c) is
// at strip[r / 16][16 c + r % 16], so that columns load as they are, and what multiplies them is
// broadcast from consecutive numbers; nothing is packed.
#pragma once

#include "strips.h"

namespace plait {
inline namespace PLAIT_ISA {

// What of a product stays in registers: strips by columns.
template <class T>
inline constexpr int tileStrips = Lanes<T>::count == 16 ? 3 : 1;
template <class T, int strips>
inline constexpr int tileColumns = Lanes<T>::count < 16 ? 4
                                   : strips == 1        ? 16
                                                        : 8;

enum class Onto { zero, itself };

// c[strip] minus the product of a[strip] and b, over `depth` columns of both.
template <class T, Onto onto, int strips>
void tile(float* const* c, const float* const* a, const float* b, int depth) {
    constexpr int columns = tileColumns<T, strips>, lanes = Lanes<T>::count;
    T sum[strips][packs<T>][columns];
    for (int s = 0; s < strips; ++s)
        for (int p = 0; p < packs<T>; ++p)
            for (int j = 0; j < columns; ++j)
                sum[s][p][j] =
                    onto == Onto::zero ? T(0) : load<T>(c[s] + j * stripRows + p * lanes);
    for (int k = 0; k < depth * stripRows; k += stripRows) {
        T left[strips][packs<T>];
        for (int s = 0; s < strips; ++s)
            for (int p = 0; p < packs<T>; ++p) left[s][p] = load<T>(a[s] + k + p * lanes);
        for (int j = 0; j < columns; ++j) {
            const T right(b[k + j]);
            for (int s = 0; s < strips; ++s)
                for (int p = 0; p < packs<T>; ++p)
                    sum[s][p][j] = fusedLess(left[s][p], right, sum[s][p][j]);
        }
    }
    for (int s = 0; s < strips; ++s)
        for (int p = 0; p < packs<T>; ++p)
            for (int j = 0; j < columns; ++j) store(c[s] + j * stripRows + p * lanes, sum[s][p][j]);
}

// The same for 16 columns of c.
template <class T, Onto onto, int strips>
void tiles(float* const* c, const float* const* a, const float* b, int depth) {
    for (int j = 0; j < stripRows; j += tileColumns<T, strips>) {
        float* at[strips];
        for (int s = 0; s < strips; ++s) at[s] = c[s] + j * stripRows;
        tile<T, onto, strips>(at, a, b + j, depth);
    }
}

// The same for `count` strips.
template <class T, Onto onto>
void product(float* const* c, const float* const* a, int count, const float* b, int depth) {
    if constexpr (tileStrips<T> == 3) {
        if (count == 3) return tiles<T, onto, 3>(c, a, b, depth);
        if (count == 2) return tiles<T, onto, 2>(c, a, b, depth);
    }
    tiles<T, onto, 1>(c, a, b, depth);
}

// L D L^T of a 16 x 16 block: below its diagonal the block becomes L, and `inverse` 1 / sqrt(D). A
// pivot that rounding has eaten (or that the matrix has not) is as good as infinite: its component
// stays 0 in every solution. Returns how many.
template <class T>
int factorBlock(float* block, const float* least, float* inverse) {
    T column[stripRows][packs<T>];
    for (int k = 0; k < stripRows; ++k)
        for (int p = 0; p < packs<T>; ++p)
            column[k][p] = load<T>(block + k * stripRows + p * Lanes<T>::count);
    int frozen = 0;
#pragma GCC unroll 16
    for (int c = 0; c < stripRows; ++c) {
        alignas(64) float raw[stripRows];  // read back one by one, faster than lanes are moved
        for (int p = 0; p < packs<T>; ++p) store(raw + p * Lanes<T>::count, column[c][p]);
        const float pivot = raw[c];
        const bool stands = pivot > least[c];
        inverse[c] = stands ? 1 / squareRoot(pivot) : 0;
        frozen += !stands;
        const T scale(stands ? 1 / pivot : 0);
        T scaled[packs<T>];
        for (int p = 0; p < packs<T>; ++p) {
            scaled[p] = stands ? column[c][p] * scale : T(0);
            store(block + c * stripRows + p * Lanes<T>::count, scaled[p]);
        }
#pragma GCC unroll 16
        for (int k = c + 1; k < stripRows; ++k)
            for (int p = 0; p < packs<T>; ++p)
                column[k][p] = fusedLess(scaled[p], T(raw[k]), column[k][p]);
    }
    return frozen;
}

// L becomes L^-T D^-1/2, so that what remains of the elimination and every solve is products.
template <class T>
void invertBlock(float* block, const float* inverse) {
    alignas(64) float identity[stripRows * stripRows] = {};
    for (int c = 0; c < stripRows; ++c) identity[c * (stripRows + 1)] = 1;
    for (int p = 0; p < stripRows; p += Lanes<T>::count) {
        T x[stripRows];
        for (int c = 0; c < stripRows; ++c) x[c] = load<T>(identity + c * stripRows + p);
#pragma GCC unroll 16
        for (int c = 0; c < stripRows; ++c)
#pragma GCC unroll 16
            for (int k = c + 1; k < stripRows; ++k)
                x[k] = fusedLess(x[c], T(block[c * stripRows + k]), x[k]);
        for (int c = 0; c < stripRows; ++c)
            store(identity + c * stripRows + p, x[c] * T(inverse[c]));
    }
    __builtin_memcpy(block, identity, sizeof identity);
}

template <class T>
int eliminate(const FrontView& f, int block) {
    float* const strip = panelStrip(f, block);
    float* const own = strip + block * stripRows * stripRows;
    const float* const a = strip;
    product<T, Onto::itself>(&own, &a, 1, strip, block * stripRows);
    float inverse[stripRows];
    const int frozen = factorBlock<T>(own, f.least + block * stripRows, inverse);
    invertBlock<T>(own, inverse);
    return frozen;
}

// Times the inverted block from the right.
template <class T>
void timesInverse(float* c, const float* inverse) {
    for (int p = 0; p < stripRows; p += Lanes<T>::count) {
        T x[stripRows];
        for (int k = 0; k < stripRows; ++k) x[k] = load<T>(c + k * stripRows + p);
#pragma GCC unroll 16
        for (int j = stripRows - 1; j >= 0; --j) {
            T sum = x[0] * T(inverse[j * stripRows]);
#pragma GCC unroll 16
            for (int k = 1; k <= j; ++k) sum = fused(x[k], T(inverse[j * stripRows + k]), sum);
            store(c + j * stripRows + p, sum);
        }
    }
}

template <class T>
void eliminateBelow(const FrontView& f, int block, int begin, int end) {
    const float* const b = panelStrip(f, block);
    const int first = block * stripRows * stripRows;  // of its columns in each strip
    for (int s = begin; s < end; s += tileStrips<T>) {
        const int count = end - s < tileStrips<T> ? end - s : tileStrips<T>;
        float* c[tileStrips<T>] = {};
        const float* a[tileStrips<T>] = {};
        for (int i = 0; i < count; ++i) {
            a[i] = panelStrip(f, s + i);
            c[i] = panelStrip(f, s + i) + first;
        }
        product<T, Onto::itself>(c, a, count, b, block * stripRows);
        for (int i = 0; i < count; ++i) timesInverse<T>(c[i], b + first);
    }
}

template <class T>
void complement(const FrontView& f, int begin, int end) {
    const int depth = f.pivotStrips * stripRows;
    for (int s = begin; s < end; s += tileStrips<T>) {
        const int last = end < s + tileStrips<T> ? end : s + tileStrips<T>;
        for (int j = 0; j < last; ++j) {
            float* c[tileStrips<T>] = {};
            const float* a[tileStrips<T>] = {};
            const int from = j > s ? j : s;  // above them the column is in the upper half
            for (int i = from; i < last; ++i) {
                a[i - from] = panelStrip(f, f.pivotStrips + i);
                c[i - from] = schurStrip(f, i) + j * stripRows * stripRows;
            }
            product<T, Onto::zero>(c, a, last - from, panelStrip(f, f.pivotStrips + j), depth);
        }
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
