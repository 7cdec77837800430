// Symmetric positive semidefinite systems whose rows couple with their neighbours, and a few last
// ones, the border, with any: what rows along a curve make, and along one that closes. A x = b by
// L D L^T, in place, in O(rows (halfWidth + border)^2).
#pragma once

#include "chain_kernels.h"

#include "../numbers/lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

inline int bandOf(const BandShape& shape) { return shape.rows - shape.border; }

// Numbers in memory, one or one a lane.
template <class T>
struct Strip {
    Scalar<T>* at;

    T operator[](int i) const { return load<T>(at + i * Lanes<T>::count); }
    void put(int i, const T& number) const { store(at + i * Lanes<T>::count, number); }
    Strip operator+(int i) const { return {at + i * Lanes<T>::count}; }
    void clear(int count) const {
        for (int i = 0; i < count; ++i) put(i, T(0));
    }
};

// A system in place; `near` is its half width if that is known beforehand, for faster loops, else
// -1; with `sides` right-hand sides.
template <class T, int near, int sides>
class Band {
public:
    // `memory`: room() of the shape numbers.
    Band(const BandShape& shape, Strip<T> memory)
        : shape_(shape), entries_(memory), b_(memory + entryCount(shape)) {}

    static int room(const BandShape& shape) {
        return entryCount(shape) + (shape.rows + 2 * shape.halfWidth) * sides;
    }
    void clear() const { entries_.clear(room(shape_)); }

    // A(i, i) ... A(i, i + halfWidth).
    Strip<T> row(int i) const { return entries_ + (i + halfWidth()) * width(); }
    // A(i, j) by j, i <= j: both in the band or in the border; and where only j is in the border.
    Strip<T> within(int i) const { return row(i) + -i; }
    Strip<T> across(int i) const { return row(i) + (stretch() - bandOf(shape_)); }
    Strip<T> side(int i) const { return b_ + (i + halfWidth()) * sides; }

    // Row i of the band, in order. An unknown whose pivot is at most `least` says nothing that
    // those before it do not say: it is 0.
    void eliminate(int i, const T& least) const {
        const Strip<T> own = row(i), b = side(i);
        if constexpr (Lanes<T>::count == 1)
            takeInPacks(own, least);
        else
            take(own, least);
        T right[sides];
        for (int r = 0; r < sides; ++r) right[r] = b[r];
#pragma GCC unroll 16
        for (int k = halfWidth(); k > 0; --k) {
            const T factor = factorOf(own, k);
            for (int r = 0; r < sides; ++r) right[r] = right[r] - factor * (b + -k * sides)[r];
        }
        for (int r = 0; r < sides; ++r) b.put(r, right[r]);
        if (shape_.border == 0) return;
        for (int k = halfWidth(); k > 0; --k) {
            const T factor = factorOf(own, k);
            for (int c = stretch(); c < width(); ++c) subtract(own + c, factor * above(own, k)[c]);
        }
        for (int k = 0; k < shape_.border; ++k) {
            const T factor = own[stretch() + k] * own[0];
            const Strip<T> last = row(bandOf(shape_) + k);
            for (int c = k; c < shape_.border; ++c)
                subtract(last + (c - k), factor * own[stretch() + c]);
            for (int r = 0; r < sides; ++r) subtract(side(bandOf(shape_) + k) + r, factor * b[r]);
        }
    }

    // The rows of the border, likewise, and then x in the place of b. least(i) of row i.
    template <class Least>
    void finish(const Least& least) const {
        const int border = shape_.border, band = bandOf(shape_);
        for (int i = 0; i < border; ++i) {
            const Strip<T> own = row(band + i), b = side(band + i);
            own.put(0, inverse(own[0], least(band + i)));
            for (int k = 1; k < border - i; ++k) {
                const T factor = own[k] * own[0];
                for (int c = k; c < border - i; ++c)
                    subtract(row(band + i + k) + (c - k), factor * own[c]);
                for (int r = 0; r < sides; ++r) subtract(b + (k * sides + r), factor * b[r]);
            }
        }
        for (int i = border - 1; i >= 0; --i)
            for (int r = 0; r < sides; ++r) {
                const Strip<T> own = row(band + i), b = side(band + i) + r;
                T sum = b[0];
                for (int k = border - i - 1; k > 0; --k) sum = sum - own[k] * b[k * sides];
                b.put(0, own[0] * sum);
            }
        // The nearest last: it is the one that all have to wait for.
        for (int i = band - 1; i >= 0; --i)
            for (int r = 0; r < sides; ++r) {
                const Strip<T> own = row(i), b = side(i) + r, last = side(band) + r;
                T sum = b[0];
                for (int k = 0; k < border; ++k) sum = sum - own[stretch() + k] * last[k * sides];
#pragma GCC unroll 16
                for (int k = halfWidth(); k > 0; --k) sum = sum - own[k] * b[k * sides];
                b.put(0, own[0] * sum);
            }
    }

private:
    using Four = Pack<4, double>;

    // Before the band there are as many empty rows as it is wide, so that no loop begins late, and
    // behind the right-hand sides as many. A single number has its row in packs of four, and zeros
    // to the next.
    static int stretchOf(int halfWidth) {
        return Lanes<T>::count == 1 ? (halfWidth + 7) / 4 * 4 : halfWidth + 1;
    }
    static int entryCount(const BandShape& shape) {
        return (shape.rows + shape.halfWidth) * (stretchOf(shape.halfWidth) + shape.border);
    }
    int halfWidth() const { return near >= 0 ? near : shape_.halfWidth; }
    int stretch() const { return stretchOf(halfWidth()); }
    int width() const { return stretch() + shape_.border; }

    static void subtract(const Strip<T>& from, const T& number) { from.put(0, from[0] - number); }
    static T inverse(const T& pivot, const T& least) {
        const auto says = pivot > least;
        return select(says, T(1), T(0)) / select(says, pivot, T(1));
    }
    Strip<T> above(const Strip<T>& own, int k) const { return own + -k * width(); }
    // Of L. The inverse of each pivot stands in its place.
    T factorOf(const Strip<T>& own, int k) const { return above(own, k)[k] * above(own, k)[0]; }

    // Takes from row i what those before it have of it, the furthest first; the inverse of the
    // pivot stands in its place from here on.
    void take(const Strip<T>& own, const T& least) const {
        if constexpr (near >= 0) {
            T u[near + 1];
            for (int c = 0; c <= near; ++c) u[c] = own[c];
            for (int k = near; k > 0; --k) {
                const T factor = factorOf(own, k);
                for (int c = 0; c <= near - k; ++c) u[c] = u[c] - factor * above(own, k)[k + c];
            }
            own.put(0, inverse(u[0], least));
            for (int c = 1; c <= near; ++c) own.put(c, u[c]);
        } else {
            for (int k = halfWidth(); k > 0; --k) {
                const T factor = factorOf(own, k);
                for (int c = 0; c <= halfWidth() - k; ++c)
                    subtract(own + c, factor * above(own, k)[k + c]);
            }
            own.put(0, inverse(own[0], least));
        }
    }

    // The same, four entries at once. What is read is stored in the same packs, or long ago: else
    // each would wait until it is in the cache.
    void takeInPacks(const Strip<T>& own, const T& least) const {
        const int packs = halfWidth() / 4 + 1;
        const auto takeTo = [&](int part, Four& u, int k) {
            u = u - Four(factorOf(own, k)) * load<Four>(above(own, k).at + k + 4 * part);
        };
        if constexpr (near >= 0) {
            Four u[near / 4 + 1];
            for (int p = 0; p < packs; ++p) u[p] = load<Four>(own.at + 4 * p);
#pragma GCC unroll 16
            for (int k = near; k > 1; --k)
#pragma GCC unroll 4
                for (int p = 0; 4 * p <= near - k; ++p) takeTo(p, u[p], k);
            if constexpr (near > 0) {
                const Four factor(factorOf(own, 1));
                Four here = load<Four>(above(own, 1).at);
#pragma GCC unroll 4
                for (int p = 0; 4 * p <= near - 1; ++p) {
                    const Four next = load<Four>(above(own, 1).at + 4 * (p + 1));
                    u[p] =
                        u[p] - factor * Four(__builtin_shufflevector(here.v, next.v, 1, 2, 3, 4));
                    here = next;
                }
            }
            u[0].v[0] = inverse(T(u[0].v[0]), least);
            for (int p = 0; p < packs; ++p) store(own.at + 4 * p, u[p]);
        } else {
            for (int p = 0; p < packs; ++p) {
                Four u = load<Four>(own.at + 4 * p);
                for (int k = halfWidth() - 4 * p; k > 0; --k) takeTo(p, u, k);
                if (p == 0) u.v[0] = inverse(T(u.v[0]), least);
                store(own.at + 4 * p, u);
            }
        }
    }

    BandShape shape_;
    Strip<T> entries_, b_;
};

}  // namespace PLAIT_ISA
}  // namespace plait
