// What takes a coarse vector of six numbers a node to a fine one, and a fine matrix to a coarse.
#pragma once

#include "aggregation.h"
#include "block_rows.h"

namespace plait {

// size x 6.
template <int size>
struct Passage {
    Record<6> row[size];
};

// P = (I - 2/3 D^-1 A) T, where T is what moves an aggregate as a rigid body. No eigenvalue of
// D^-1 A is above 2 where A is made of edges: 2/3 is 4/3 over that.
template <int size>
class Prolongator {
public:
    Prolongator(const BlockRows<size>& a, const Aggregates& aggregates, BlockRows<6>& coarse)
        : of_(aggregates.of), bodies(of_.size()) {
        std::vector<std::vector<int>> entries(static_cast<std::size_t>(aggregates.count));
        std::vector<int> list;
        for (int i = 0; i < a.count(); ++i) {
            list = {of_[i]};
            for (const int j : a.columns[i]) list.push_back(of_[j]);
            appendSorted(columns_, list);
        }
        for (int i = 0; i < a.count(); ++i) {
            for (int q = columns_.start[i]; q < columns_.start[i + 1]; ++q) {
                entries[columns_.item[q]].push_back(q);
                fine_.push_back(i);
            }
            list.assign(columns_[i].begin(), columns_[i].end());
            for (const int j : a.columns[i])
                list.insert(list.end(), columns_[j].begin(), columns_[j].end());
            appendSorted(products_, list);
        }
        for (int n = 0; n < aggregates.count; ++n) {
            entries_.item.insert(entries_.item.end(), entries[n].begin(), entries[n].end());
            entries_.start.push_back(static_cast<int>(entries_.item.size()));
            list.clear();
            for (const int q : entries[n])
                list.insert(list.end(), products_[fine_[q]].begin(), products_[fine_[q]].end());
            std::erase(list, n);
            appendSorted(coarse.columns, list);
        }
        coarse.layOut();
        p_.resize(columns_.item.size());
        ap_.resize(products_.item.size());
        findMirrors(coarse);
    }

    std::span<const int> aggregates() const { return of_; }

    // From `bodies`, which is T, a passage a node.
    void smooth(const BlockRows<size>& a, Workers& workers) {
        workers.forBlocks(a.count(), 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) smoothRow(a, i);
        });
    }

    // coarse = P^T A P.
    void project(const BlockRows<size>& a, BlockRows<6>& coarse, Workers& workers) {
        workers.forBlocks(a.count(), 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) multiplyRow(a, i);
        });
        workers.forBlocks(coarse.count(), 64, [&](int begin, int end) {
            for (int n = begin; n < end; ++n) projectRow(coarse, n);
        });
    }

    // b = P^T r
    void restrict(const std::vector<Record<size>>& r, std::vector<Record<6>>& b,
                  Workers& workers) const {
        workers.forBlocks(entries_.size(), 256, [&](int begin, int end) {
            for (int n = begin; n < end; ++n) {
                Record<6> sum(0);
                for (const int q : entries_[n])
                    for (int k = 0; k < size; ++k) sum = sum + r[fine_[q]][k] * p_[q].row[k];
                b[n] = sum;
            }
        });
    }

    // x += P e
    void prolong(const std::vector<Record<6>>& e, std::vector<Record<size>>& x,
                 Workers& workers) const {
        workers.forBlocks(columns_.size(), 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                Passage<size> sum{};
                for (int q = columns_.start[i]; q < columns_.start[i + 1]; ++q)
                    for (int k = 0; k < size; ++k)
                        sum.row[k] = sum.row[k] + e[columns_.item[q]] * p_[q].row[k];
                for (int k = 0; k < size; ++k) {
                    const Pack<4> pairs = sum.row[k].pack[0] + sum.row[k].pack[1];
                    x[i].set(k, x[i][k] + ((pairs.v[0] + pairs.v[2]) + (pairs.v[1] + pairs.v[3])));
                }
            }
        });
    }

    // Of `restrict` and `prolong`; of `smooth` and `project`.
    double multiplications() const { return 12.0 * size * static_cast<double>(p_.size()); }
    double setUpMultiplications(const BlockRows<size>& a) const {
        double blocks = static_cast<double>(p_.size()) + a.multiplications() / (size * size);
        double products = 0;
        for (int i = 0; i < a.count(); ++i) {
            for (const int j : a.columns[i]) blocks += static_cast<double>(columns_[j].size());
            products += 0.5 * static_cast<double>(columns_[i].size() * products_[i].size());
        }
        return 6.0 * size * size * blocks + 36.0 * size * products;
    }

private:
    // sum += a t
    static void add(Passage<size>& to, const Block<size>& a, const Passage<size>& t) {
        Passage<size> sum = to;
        for (int c = 0; c < size; ++c)
            for (int r = 0; r < size; ++r) sum.row[r] = sum.row[r] + a.column[c][r] * t.row[c];
        to = sum;
    }
    static Passage<size> difference(const Passage<size>& s, const Passage<size>& t) {
        Passage<size> d;
        for (int k = 0; k < size; ++k) d.row[k] = s.row[k] - t.row[k];
        return d;
    }
    Passage<size>& at(std::vector<Passage<size>>& passages, const Csr& where, int i, int column) {
        int q = where.start[i];
        while (where.item[q] != column) ++q;
        return passages[q];
    }

    void smoothRow(const BlockRows<size>& a, int i) {
        const bool edges = !a.own.empty();
        for (int q = columns_.start[i]; q < columns_.start[i + 1]; ++q) p_[q] = {};
        Passage<size>& here = at(p_, columns_, i, of_[i]);
        add(here, (edges ? a.own : a.diagonal)[i], bodies[i]);
        for (int k = a.columns.start[i]; k < a.columns.start[i + 1]; ++k) {
            const int j = a.columns.item[k];
            const bool within = of_[j] == of_[i];
            if (edges && within) {
                add(here, a.off[k], difference(bodies[j], bodies[i]));
                continue;
            }
            add(at(p_, columns_, i, of_[j]), a.off[k], bodies[j]);
            if (edges) add(here, a.off[k], difference({}, bodies[i]));
        }
        for (int q = columns_.start[i]; q < columns_.start[i + 1]; ++q) {
            Passage<size> step{};
            add(step, a.inverses[i], p_[q]);
            for (int k = 0; k < size; ++k) p_[q].row[k] = (-2.0F / 3) * step.row[k];
        }
        for (int k = 0; k < size; ++k) here.row[k] = here.row[k] + bodies[i].row[k];
    }

    // A P, by differences where A is of edges: of the six hundred thousand times larger stiffness
    // the coarse matrix must lose all but the mass.
    void multiplyRow(const BlockRows<size>& a, int i) {
        const bool edges = !a.own.empty();
        for (int t = products_.start[i]; t < products_.start[i + 1]; ++t) ap_[t] = {};
        addRow((edges ? a.own : a.diagonal)[i], i, i, -1);
        for (int k = a.columns.start[i]; k < a.columns.start[i + 1]; ++k)
            addRow(a.off[k], i, a.columns.item[k], edges ? i : -1);
    }
    // Row i += a (P_j - P_minus)
    void addRow(const Block<size>& a, int i, int j, int minus) {
        int t = products_.start[i], q = columns_.start[j],
            m = minus < 0 ? 0 : columns_.start[minus];
        const int lastQ = columns_.start[j + 1], lastM = minus < 0 ? 0 : columns_.start[minus + 1];
        while (q < lastQ || m < lastM) {
            const int plus = q < lastQ ? columns_.item[q] : coarseEnd();
            const int less = m < lastM ? columns_.item[m] : coarseEnd();
            const int column = std::min(plus, less);
            while (products_.item[t] != column) ++t;
            const Passage<size> none{};
            const Passage<size>& first = plus == column ? p_[q++] : none;
            add(ap_[t], a, less == column ? difference(first, p_[m++]) : first);
        }
    }
    int coarseEnd() const { return entries_.size(); }

    // The upper half of row n of P^T A P, and the lower as its transpose: a few blocks at a time.
    void projectRow(BlockRows<6>& coarse, int n) {
        const int last = coarse.columns.start[n + 1];
        int upper = coarse.columns.start[n];
        while (upper < last && coarse.columns.item[upper] < n) ++upper;
        Block<6> sums[most];
        sum(n, &n, &n + 1, sums);
        coarse.diagonal[n] = symmetric(sums[0]);
        for (int begin = upper; begin < last; begin += most) {
            const int end = std::min(begin + most, last);
            sum(n, &coarse.columns.item[begin], coarse.columns.item.data() + end, sums);
            for (int k = begin; k < end; ++k) {
                coarse.off[mirrors_[k]] = sums[k - begin];
                coarse.off[k] = transposed(sums[k - begin]);
            }
        }
    }
    // The transposes of blocks (n, column), of which there are at most `most`.
    void sum(int n, const int* columns, const int* end, Block<6>* sums) const {
        std::fill(sums, sums + (end - columns), Block<6>{});
        for (const int q : entries_[n]) {
            const int* column = columns;
            for (int t = products_.start[fine_[q]]; t < products_.start[fine_[q] + 1]; ++t) {
                while (column != end && *column < products_.item[t]) ++column;
                if (column == end) break;
                if (*column != products_.item[t]) continue;
                for (int c = 0; c < 6; ++c) {
                    Record<6> to = sums[column - columns].column[c];
                    for (int r = 0; r < size; ++r) to = to + p_[q].row[r][c] * ap_[t].row[r];
                    sums[column - columns].column[c] = to;
                }
            }
        }
    }
    static Block<6> transposed(const Block<6>& a) {
        Block<6> b{};
        for (int r = 0; r < 6; ++r)
            for (int c = 0; c < 6; ++c) b.column[r].set(c, a.column[c][r]);
        return b;
    }
    static Block<6> symmetric(const Block<6>& a) {
        Block<6> b = transposed(a);
        for (int c = 0; c < 6; ++c) b.column[c] = 0.5F * (b.column[c] + a.column[c]);
        return b;
    }
    void findMirrors(const BlockRows<6>& coarse) {
        const Csr& columns = coarse.columns;
        for (int n = 0; n < coarse.count(); ++n)
            for (const int m : columns[n]) {
                const auto from = columns.item.begin() + columns.start[m];
                mirrors_.push_back(static_cast<int>(
                    std::lower_bound(from, columns.item.begin() + columns.start[m + 1], n) -
                    columns.item.begin()));
            }
    }

    static constexpr int most = 32;

    std::vector<int> of_;       // aggregates, by fine node
    Csr columns_;               // of P, by fine node
    Csr entries_;               // of P, by coarse node
    std::vector<int> fine_;     // node, by entry of P
    Csr products_;              // columns of A P, by fine node
    std::vector<int> mirrors_;  // the entry (J, I), by entry (I, J) of the coarse matrix
    std::vector<Passage<size>> p_, ap_;

public:
    std::vector<Passage<size>> bodies;  // T
};

}  // namespace plait
