// Sparse symmetric matrices of 3 x 3 or 6 x 6 blocks, row by row, and their Gauss-Seidel sweeps.
#pragma once

#include "../../complex/csr.h"
#include "../../kernels/workers.h"
#include "../../numbers/lanes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plait {

// Numbers four at a time: packs of eight are slow where registers hold four.
template <int packs>
struct Numbers {
    Pack<4> pack[packs];

    Numbers() = default;
    explicit Numbers(float s) { std::fill(pack, pack + packs, Pack<4>(s)); }

    float operator[](int i) const { return load<float>(reinterpret_cast<const float*>(pack) + i); }
    void set(int i, float s) { store<float>(reinterpret_cast<float*>(pack) + i, s); }

    friend Numbers operator+(Numbers a, const Numbers& b) {
        for (int n = 0; n < packs; ++n) a.pack[n] = a.pack[n] + b.pack[n];
        return a;
    }
    friend Numbers operator-(Numbers a, const Numbers& b) {
        for (int n = 0; n < packs; ++n) a.pack[n] = a.pack[n] - b.pack[n];
        return a;
    }
    friend Numbers operator*(float s, Numbers a) {
        for (int n = 0; n < packs; ++n) a.pack[n] = Pack<4>(s) * a.pack[n];
        return a;
    }
    friend Numbers operator*(Numbers a, const Numbers& b) {
        for (int n = 0; n < packs; ++n) a.pack[n] = a.pack[n] * b.pack[n];
        return a;
    }
};

// The numbers of a node; those from `size` on are 0.
template <int size>
using Record = Numbers<size == 3 ? 1 : 2>;

template <int size>
struct Block {
    Record<size> column[size];
};

template <int size>
[[gnu::always_inline]] inline Record<size> operator*(const Block<size>& a, const Record<size>& x) {
    Record<size> sum = x[0] * a.column[0];
    for (int c = 1; c < size; ++c) sum = sum + x[c] * a.column[c];
    return sum;
}

// By Cholesky, in double. A direction in which rounding leaves no more than 1e-6 of what stands on
// the diagonal has none: an aggregate on a line does not turn about it.
template <int size>
Block<size> inverse(const Block<size>& a) {
    double l[size][size] = {};
    for (int j = 0; j < size; ++j) {
        const double own = double(a.column[j][j]);
        double pivot = own;
        for (int k = 0; k < j; ++k) pivot -= l[j][k] * l[j][k];
        if (!(pivot > 1e-6 * own)) continue;
        l[j][j] = std::sqrt(pivot);
        for (int i = j + 1; i < size; ++i) {
            double sum = double(a.column[j][i]);
            for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
            l[i][j] = sum / l[j][j];
        }
    }
    Block<size> b{};
    for (int c = 0; c < size; ++c) {
        double y[size] = {};
        for (int i = 0; i < size; ++i) {
            double sum = i == c ? 1 : 0;
            for (int k = 0; k < i; ++k) sum -= l[i][k] * y[k];
            y[i] = l[i][i] > 0 ? sum / l[i][i] : 0;
        }
        for (int i = size; i-- > 0;) {
            double sum = y[i];
            for (int k = i + 1; k < size; ++k) sum -= l[k][i] * y[k];
            y[i] = l[i][i] > 0 ? sum / l[i][i] : 0;
            b.column[c].set(i, static_cast<float>(y[i]));
        }
    }
    return b;
}

// Sweeps are Gauss-Seidel within a run of rows and Jacobi between runs, which are the same for any
// number of threads. What couples two runs is added to the diagonal, row by row, so that a sweep
// there and back stays a contraction (Baker, Falgout, Kolev, Yang, "Multigrid smoothers for
// ultraparallel computing", 2011, 6.2); blocks of edges need no such thing.
template <int size>
class BlockRows {
public:
    using R = Record<size>;

    Csr columns;                   // ascending, without the diagonal
    std::vector<Block<size>> off;  // by entry
    std::vector<Block<size>> diagonal, inverses;
    std::vector<Block<size>> own;  // without edges, where the matrix is one of edges

    int count() const { return columns.size(); }
    // Of a product with a vector.
    double multiplications() const {
        return double(size) * size * static_cast<double>(off.size() + diagonal.size());
    }

    void layOut() {
        off.resize(columns.item.size());
        diagonal.resize(static_cast<std::size_t>(count()));
        inverses.resize(diagonal.size());
        added_.resize(diagonal.size());
        old_.resize(diagonal.size());
        const int runs = count() < 4096 ? 1 : 16;
        for (int run = 0; run < runs; ++run) {
            const int first = static_cast<int>(long{count()} * run / runs);
            const int last = static_cast<int>(long{count()} * (run + 1) / runs);
            for (int i = first; i < last; ++i) {
                const auto from = columns.item.begin() + columns.start[i];
                const auto to = columns.item.begin() + columns.start[i + 1];
                const auto at = [&](int column) {
                    return static_cast<int>(std::lower_bound(from, to, column) -
                                            columns.item.begin());
                };
                bounds_.push_back({at(first), at(i), at(last)});
            }
            ends_.push_back(last);
        }
    }

    // When the blocks are new.
    void invert(Workers& workers) {
        workers.forBlocks(count(), 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                Block<size> d = diagonal[i];
                added_[i] = own.empty() ? coupled(i) : R(0);
                for (int c = 0; c < size; ++c) d.column[c].set(c, d.column[c][c] + added_[i][c]);
                inverses[i] = inverse(d);
            }
        });
    }

    // A x. Where A is of edges, by differences: k (x - y) is exact where k x - k y is not.
    R row(int i, const std::vector<R>& x) const {
        const bool edges = !own.empty();
        R sum = (edges ? own : diagonal)[i] * x[i];
        for (int k = columns.start[i]; k < columns.start[i + 1]; ++k)
            sum = sum + off[k] * (edges ? x[columns.item[k]] - x[i] : x[columns.item[k]]);
        return sum;
    }

    // x = (D + L)^-1 b, r = b - A x.
    void forward(const std::vector<R>& b, std::vector<R>& x, std::vector<R>& r, Workers& workers) {
        overRuns(workers, [&](int first, int last) {
            for (int i = first; i < last; ++i)
                x[i] = inverses[i] * less(b[i], bounds_[i].first, bounds_[i].middle, x);
        });
        workers.forBlocks(count(), 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const R before = less(added_[i] * x[i], columns.start[i], bounds_[i].first, x);
                r[i] = less(before, bounds_[i].middle, columns.start[i + 1], x);
            }
        });
    }

    // x += (D + U)^-1 (b - A x).
    void backward(const std::vector<R>& b, std::vector<R>& x, Workers& workers) {
        std::copy(x.begin(), x.end(), old_.begin());
        overRuns(workers, [&](int first, int last) {
            for (int i = last; i-- > first;) {
                const Bounds& at = bounds_[i];
                R sum = less(b[i] + added_[i] * x[i], columns.start[i], at.first, old_);
                sum = less(sum, at.first, at.last, x);
                x[i] = inverses[i] * less(sum, at.last, columns.start[i + 1], old_);
            }
        });
    }

private:
    struct Bounds {
        int first, middle, last;  // entries: of its run, above the diagonal, past its run
    };

    R less(R sum, int begin, int end, const std::vector<R>& x) const {
        for (int k = begin; k < end; ++k) sum = sum - off[k] * x[columns.item[k]];
        return sum;
    }
    R coupled(int i) const {
        R sum(0);
        const auto add = [&](int begin, int end) {
            for (int k = begin; k < end; ++k)
                for (const R& column : off[k].column)
                    for (int r = 0; r < size; ++r) sum.set(r, sum[r] + std::abs(column[r]));
        };
        add(columns.start[i], bounds_[i].first);
        add(bounds_[i].last, columns.start[i + 1]);
        return sum;
    }
    template <class Body>
    void overRuns(Workers& workers, const Body& body) const {
        workers.forBlocks(static_cast<int>(ends_.size()), 1, [&](int begin, int end) {
            for (int run = begin; run < end; ++run) body(run ? ends_[run - 1] : 0, ends_[run]);
        });
    }

    std::vector<Bounds> bounds_;  // by row
    std::vector<int> ends_;       // of runs
    std::vector<R> added_, old_;
};

}  // namespace plait
