// The two halves of a solve, front by front.
#pragma once

#include "strips.h"

namespace plait {
inline namespace PLAIT_ISA {

// Groups of 2 * part lanes of a and b in turn, each folded in half.
template <int part, int n, int... i>
Pack<n> folded(Pack<n> a, Pack<n> b, std::integer_sequence<int, i...>) {
    constexpr auto lane = [](int at) {
        const int group = at / part;
        return (group % 2 ? n : 0) + group / 2 * 2 * part + at % part;
    };
    return Pack<n>(typename Pack<n>::V(__builtin_shufflevector(a.v, b.v, lane(i)...))) +
           Pack<n>(typename Pack<n>::V(__builtin_shufflevector(a.v, b.v, (lane(i) + part)...)));
}

// Lane i of the result is the sum of all lanes of x[i], which is lost.
template <int part, int n>
Pack<n> sumsOf(Pack<n>* x) {
    for (int i = 0; i < part; ++i)
        x[i] = folded<part>(x[i], x[i + part], std::make_integer_sequence<int, n>{});
    if constexpr (part == 1)
        return x[0];
    else
        return sumsOf<part / 2>(x);
}

// As many sums over a strip as T has lanes.
template <class T>
struct StripSums {
    static constexpr int count = Lanes<T>::count;
    T sum[count][packs<T>];

    // The first of the columns times x, lane by lane.
    void add(const float* columns, const float* x) {
        for (int p = 0; p < packs<T>; ++p) {
            const T factor = load<T>(x + p * count);
            for (int c = 0; c < count; ++c)
                sum[c][p] = fused(load<T>(columns + c * stripRows + p * count), factor, sum[c][p]);
        }
    }
    T total() {
        T whole[count];
        for (int c = 0; c < count; ++c) {
            for (int half = packs<T> / 2; half > 0; half /= 2)
                for (int p = 0; p < half; ++p) sum[c][p] = sum[c][p] + sum[c][p + half];
            whole[c] = sum[c][0];
        }
        return sumsOf<count / 2>(whole);
    }
};

// x of `strips` strips from `first` on, minus their first `depth` columns times x.
template <class T, int strips>
void lessColumns(const FrontView& f, int first, int depth, float* x) {
    constexpr int lanes = Lanes<T>::count, chains = 4;  // of sums that need not wait for each other
    const float* columns[strips];
    T sum[chains][strips][packs<T>] = {};
    for (int s = 0; s < strips; ++s) columns[s] = panelStrip(f, first + s);
    for (int k = 0; k < depth; k += chains)
        for (int i = 0; i < chains; ++i) {
            const T factor(x[k + i]);
            for (int s = 0; s < strips; ++s)
                for (int p = 0; p < packs<T>; ++p)
                    sum[i][s][p] = fused(load<T>(columns[s] + (k + i) * stripRows + p * lanes),
                                         factor, sum[i][s][p]);
        }
    for (int s = 0; s < strips; ++s)
        for (int p = 0; p < packs<T>; ++p) {
            float* const at = x + (first + s) * stripRows + p * lanes;
            const T all = (sum[0][s][p] + sum[1][s][p]) + (sum[2][s][p] + sum[3][s][p]);
            store(at, load<T>(at) - all);
        }
}

template <class T>
void forward(const FrontView& f, float* x) {
    constexpr int lanes = Lanes<T>::count;
    for (int block = 0; block < f.pivotStrips; ++block) {
        if (block) lessColumns<T, 1>(f, block, block * stripRows, x);
        const float* const inverse = panelStrip(f, block) + block * stripRows * stripRows;
        float* const own = x + block * stripRows;
        T solved[packs<T>];
        for (int p = 0; p < packs<T>; ++p) {
            StripSums<T> sums{};
            sums.add(inverse + p * lanes * stripRows, own);
            solved[p] = sums.total();
        }
        for (int p = 0; p < packs<T>; ++p) store(own + p * lanes, solved[p]);
    }
    constexpr int together = Lanes<T>::count == 16 ? 4 : 1;
    const int strips = f.pivotStrips + f.boundaryStrips, depth = f.pivotStrips * stripRows;
    int s = f.pivotStrips;
    for (; s + together <= strips; s += together) lessColumns<T, together>(f, s, depth, x);
    for (; s < strips; ++s) lessColumns<T, 1>(f, s, depth, x);
}

template <class T>
void backward(const FrontView& f, float* x) {
    constexpr int lanes = Lanes<T>::count;
    const int strips = f.pivotStrips + f.boundaryStrips;
    for (int block = f.pivotStrips - 1; block >= 0; --block) {
        float* const own = x + block * stripRows;
        for (int p = 0; p < packs<T>; ++p) {
            StripSums<T> sums{};
            const int column = (block * stripRows + p * lanes) * stripRows;
            for (int s = block + 1; s < strips; ++s)
                sums.add(panelStrip(f, s) + column, x + s * stripRows);
            store(own + p * lanes, load<T>(own + p * lanes) - sums.total());
        }
        const float* const inverse = panelStrip(f, block) + block * stripRows * stripRows;
        T solved[packs<T>] = {};
        for (int c = 0; c < stripRows; ++c)
            for (int p = 0; p < packs<T>; ++p)
                solved[p] =
                    fused(load<T>(inverse + c * stripRows + p * lanes), T(own[c]), solved[p]);
        for (int p = 0; p < packs<T>; ++p) store(own + p * lanes, solved[p]);
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
