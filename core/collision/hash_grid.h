// A hash grid for primitives without lasting neighbours, such as particles: built anew each
// substep, for no more than a counting sort (S 7).
#pragma once

#include "candidates.h"
#include "kdop.h"

#include <cstdint>
#include <vector>

namespace plait {

class HashGrid {
public:
    // Puts each of the primitives 0 .. count - 1 into every cell that bound(i), a KDop<6>, meets;
    // bound is called from all threads. Cells are twice as wide as the mean bounds, wider where the
    // primitives would meet more than `cellsEach` cells each. Nothing is allocated but what it
    // takes to hold more than ever before.
    template <class Bound>
    void build(int count, const Bound& bound, Workers& workers) {
        bounds_.resize(count);
        workers.forBlocks(count, 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) bounds_[i] = bound(i);
        });
        chooseCells(workers);
        fillCells(workers);
    }

    int count() const { return static_cast<int>(bounds_.size()); }

    // The pairs a < b whose bounds overlap and that accept(a, b), each once; by bucket, then by
    // primitive, whatever the threads.
    template <class Accept = AnyPair>
    void selfPairs(Candidates& found, Workers& workers, const Accept& accept = {}) const {
        found.collect(parts, workers, [&](int part, Candidates::List& list) {
            const int buckets = 1 << (bits_ - partBits);
            for (int b = part * buckets; b < (part + 1) * buckets; ++b)
                for (int i = start_[b]; i < start_[b + 1]; ++i)
                    for (int j = i + 1; j < start_[b + 1]; ++j)
                        if (meet(entries_[i], entries_[j]) &&
                            accept(entries_[i].item, entries_[j].item))
                            list.push_back({entries_[i].item, entries_[j].item});
        });
    }

private:
    // Parts of the table, and blocks of primitives, that are worked on in parallel: as many for any
    // number of threads. Cells of an axis are 0 .. 2^20, so that three fit into one integer.
    static constexpr int partBits = 8, parts = 1 << partBits, blocks = 64, axisBits = 20;
    static constexpr int cellsEach = 8;

    using Cell = std::uint64_t;

    struct Key {
        Cell cell;
        int item;
    };
    // With its bounds, so that a bucket lies in one piece.
    struct Entry {
        KDop<6> bounds;
        Cell cell;
        int item;
    };
    struct Cells {
        int low[3], high[3];
        double count() const {
            double n = 1;
            for (int a = 0; a < 3; ++a) n *= high[a] - low[a] + 1;
            return n;
        }
    };

    // Rises with x: bounds that overlap share a cell, however this rounds.
    int coordinate(float x, int axis) const {
        const float c = (x - origin_[axis]) * perCell_;
        return static_cast<int>(std::clamp(c, 0.0F, last_[axis]));
    }
    Cells cellsOf(const KDop<6>& b) const {
        Cells cells;
        for (int a = 0; a < 3; ++a) {
            cells.low[a] = coordinate(b.low[a], a);
            cells.high[a] = coordinate(b.high[a], a);
        }
        return cells;
    }
    static Cell join(int x, int y, int z) {
        return Cell(x) | Cell(y) << (axisBits + 1) | Cell(z) << 2 * (axisBits + 1);
    }
    // Steele, Lea, Flood 2014: one round mixes well enough.
    int bucketOf(Cell cell) const {
        cell = (cell ^ cell >> 30) * 0xbf58476d1ce4e5b9;
        return static_cast<int>((cell ^ cell >> 27) * 0x94d049bb133111eb >> (64 - bits_));
    }

    // Overlap, and first do so in this cell: that of the low corner of what they share.
    bool meet(const Entry& p, const Entry& q) const {
        const auto corner = [&](int axis) {
            return coordinate(std::max(p.bounds.low[axis], q.bounds.low[axis]), axis);
        };
        return p.cell == q.cell && p.bounds.overlaps(q.bounds) &&
               p.cell == join(corner(0), corner(1), corner(2));
    }

    template <class Visit>
    void eachBlock(Workers& workers, const Visit& visit) const;
    void chooseCells(Workers& workers);
    void setCells(float size, const KDop<6>& all);
    double countCells(Workers& workers);
    void fillCells(Workers& workers);
    void sortPart(int part);

    float origin_[3]{}, last_[3]{}, perCell_ = 0;  // perCell_: 1/m
    int bits_ = partBits;                          // of the number of buckets
    std::vector<KDop<6>> bounds_;
    std::vector<Key> keys_;                                 // by part
    std::vector<int> first_;                                // in keys_, of each part and block
    std::vector<Entry> entries_;                            // by bucket
    std::vector<int> start_ = std::vector<int>(parts + 1);  // in entries_, of each bucket
};

}  // namespace plait
