#include "hash_grid.h"

#include <array>
#include <cmath>
#include <utility>

namespace plait {

// visit(block, begin, end) for blocks of primitives.
template <class Visit>
void HashGrid::eachBlock(Workers& workers, const Visit& visit) const {
    workers.forBlocks(blocks, 1, [&](int begin, int end) {
        for (int b = begin; b < end; ++b)
            visit(b, static_cast<int>(long(count()) * b / blocks),
                  static_cast<int>(long(count()) * (b + 1) / blocks));
    });
}

void HashGrid::chooseCells(Workers& workers) {
    struct Summary {
        KDop<6> all = KDop<6>::nothing();
        double width = 0;  // of all bounds together, m
        int finite = 0;
    };
    std::array<Summary, blocks> summaries;
    eachBlock(workers, [&](int block, int begin, int end) {
        Summary s;
        for (int i = begin; i < end; ++i) {
            const KDop<6>& b = bounds_[i];
            float width = 0;
            for (int a = 0; a < 3; ++a) width = std::max(width, b.high[a] - b.low[a]);
            if (!std::isfinite(width)) continue;
            s.all.include(b);
            s.width += width;
            ++s.finite;
        }
        summaries[block] = s;
    });
    Summary sum;
    for (const Summary& s : summaries) {
        sum.all.include(s.all);
        sum.width += s.width;
        sum.finite += s.finite;
    }
    if (sum.finite == 0) sum.all = {{0, 0, 0}, {0, 0, 0}};
    float size = sum.finite ? static_cast<float>(2 * sum.width / sum.finite) : 0;
    for (int a = 0; a < 3; ++a)
        size = std::max(size, std::ldexp(sum.all.high[a] - sum.all.low[a], -axisBits));
    size = std::max(size, 1e-30F);
    do {
        setCells(size, sum.all);
        size *= 2;
    } while (countCells(workers) > double(cellsEach) * count());
}

void HashGrid::setCells(float size, const KDop<6>& all) {
    perCell_ = 1 / size;
    for (int a = 0; a < 3; ++a) {
        origin_[a] = all.low[a];
        last_[a] = std::floor((all.high[a] - all.low[a]) * perCell_);
    }
}

double HashGrid::countCells(Workers& workers) {
    std::array<double, blocks> cells{};
    eachBlock(workers, [&](int block, int begin, int end) {
        for (int i = begin; i < end; ++i) cells[block] += cellsOf(bounds_[i]).count();
    });
    double sum = 0;
    for (const double c : cells) sum += c;
    return sum;
}

// In two steps, so that each has a short table: into the parts, by block; within each, by bucket.
void HashGrid::fillCells(Workers& workers) {
    const auto eachCell = [&](int begin, int end, const auto& visit) {
        for (int i = begin; i < end; ++i) {
            const Cells c = cellsOf(bounds_[i]);
            for (int z = c.low[2]; z <= c.high[2]; ++z)
                for (int y = c.low[1]; y <= c.high[1]; ++y)
                    for (int x = c.low[0]; x <= c.high[0]; ++x) visit(Key{join(x, y, z), i});
        }
    };
    const auto partOf = [&](Cell cell) { return bucketOf(cell) >> (bits_ - partBits); };
    bits_ = partBits;
    while (1 << bits_ < 2 * count()) ++bits_;
    first_.assign(parts * blocks, 0);
    eachBlock(workers, [&](int block, int begin, int end) {
        eachCell(begin, end, [&](const Key& key) { ++first_[partOf(key.cell) * blocks + block]; });
    });
    int entries = 0;
    for (int& f : first_) entries += std::exchange(f, entries);
    keys_.resize(entries);
    entries_.resize(entries);
    eachBlock(workers, [&](int block, int begin, int end) {
        eachCell(begin, end,
                 [&](const Key& key) { keys_[first_[partOf(key.cell) * blocks + block]++] = key; });
    });
    start_.assign((1 << bits_) + 1, 0);
    start_.back() = entries;
    workers.forBlocks(parts, 1, [&](int begin, int end) {
        for (int part = begin; part < end; ++part) sortPart(part);
    });
}

// Backward, so that each bucket keeps the order of the primitives.
void HashGrid::sortPart(int part) {
    const int buckets = 1 << (bits_ - partBits), firstBucket = part * buckets;
    // Each place in first_ has been moved on to the next one's.
    const int begin = part ? first_[part * blocks - 1] : 0, end = first_[(part + 1) * blocks - 1];
    for (int i = begin; i < end; ++i) ++start_[bucketOf(keys_[i].cell)];
    for (int b = 0, sum = begin; b < buckets; ++b) sum = start_[firstBucket + b] += sum;
    for (int i = end; i-- > begin;) {
        const auto& [cell, item] = keys_[i];
        entries_[--start_[bucketOf(cell)]] = {bounds_[item], cell, item};
    }
}

}  // namespace plait
