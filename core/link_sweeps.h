// Sweeps over links: over all of them, or only where they are off. Wide and threaded, with the same
// bits for any number of threads and lanes.
#pragma once

#include "csr.h"
#include "link_blocks.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace plait {

// Which links are off, and what is done about it. Many rounds of few sweeps take a third of the
// work of few rounds of many: what is off soon lies elsewhere.
struct Mending {
    double tolerance = 0.008;  // part of its length by which a link may be off
    int rings = 3;             // of neighbours that are swept with those that are off by more
    int sweeps = 4;            // in a round, forward and backward in turns
    int rounds = 60;           // at most; after each, the links that are off are looked for again
};

template <class Real>
class LinkSweeps {
public:
    using Row = typename LinkBlocks<Real>::Row;

    // `ids`: two vertices a link. `padding`: a vertex without mass, above all others.
    LinkSweeps(std::span<const int> ids, int padding, KernelChoice kernels)
        : kernels_(kernelTable<Stretch, Real>(kernels)), all_(padding), active_(padding) {
        const std::vector<int> colors = greedyColors(ids, 2, padding + 1);
        const int count = colors.empty() ? 0 : *std::max_element(colors.begin(), colors.end()) + 1;
        near_.resize(static_cast<std::size_t>(padding) + 1);
        marked_.reserve(near_.size());
        byColor_.resize(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < colors.size(); ++i)
            byColor_[colors[i]].push_back(static_cast<int>(i));
        slots_.resize(colors.size());
        for (const std::vector<int>& color : byColor_) {
            for (const int i : color) slots_[i] = all_.add(ids[2 * i], ids[2 * i + 1], {});
            all_.endColor();
        }
        rows_.resize(static_cast<std::size_t>(all_.size()));
        blocks_.resize(rows_.size() / blockSize);
        off_.reserve(rows_.size());
        for (std::size_t c = 0; c < byColor_.size(); ++c)
            color_.resize(static_cast<std::size_t>(all_.end(static_cast<int>(c))),
                          static_cast<int>(c));
        joinSlots(ids);
        active_ = all_;  // its memory
    }

    const LinkBlocks<Real>& links() const { return all_; }
    int slot(int link) const { return slots_[static_cast<std::size_t>(link)]; }
    const Row& row(int slot) const { return rows_[static_cast<std::size_t>(slot)]; }
    void setRow(int slot, const Row& row) {
        rows_[static_cast<std::size_t>(slot)] = row;
        all_.setRow(slot, row);
    }

    // Before sweeps: a link that gives has, at rest, the length that its tension (N, by slot) gives
    // it, and multipliers start from 0.
    void aim(std::span<const Real> tension) {
        for (int n = 0; n < all_.size(); ++n) {
            Row row = rows_[n];
            const Real compliance = tension[n] > Real(0) ? row.compliance : row.compression;
            if (compliance < Real(slack)) row.rest += compliance * tension[n];
            all_.setRow(n, row);
        }
        all_.forgetMultipliers();
    }

    // Both return the counted work.
    long sweep(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
        return all_.project(sweep, direction, kernel(sweep), workers);
    }
    long mend(const Sweep<Real>& sweep, const Mending& mending, Workers& workers) {
        long work = 0;
        for (int round = 0; round < mending.rounds; ++round) {
            if (round == 0)
                findOff(sweep, mending.tolerance, workers);
            else
                findStillOff(sweep, mending.tolerance);
            if (!markNear(mending.rings)) break;
            activateNear();
            for (int i = 0; i < mending.sweeps; ++i)
                work += active_.project(sweep, i % 2 ? Direction::backward : Direction::forward,
                                        kernel(sweep), workers);
        }
        return work;
    }

private:
    // As wide as every level of x86-64 is: what a pass only compares has the same bits anyway.
    using Wide = std::conditional_t<std::is_same_v<Real, float>, Pack<4>, Real>;

    Kernel<Real> kernel(const Sweep<Real>& sweep) const {
        return kernels_.project[sweep.air ? 1 : 0];
    }

    void joinSlots(std::span<const int> ids) {
        std::vector<int>& start = slotsAt_.start;
        start.assign(near_.size() + 1, 0);
        for (const int v : ids) ++start[v + 1];
        for (std::size_t v = 0; v < near_.size(); ++v) start[v + 1] += start[v];
        slotsAt_.item.resize(ids.size());
        std::vector<int> end(start.begin(), start.end() - 1);
        for (std::size_t i = 0; i < ids.size(); ++i) slotsAt_.item[end[ids[i]]++] = slots_[i / 2];
    }

    // 1 where a link is off to a side that it acts on.
    template <class T>
    T isOff(const Sweep<Real>& sweep, int slot, double tolerance) const {
        const int* ids = all_.ids(slot);
        const auto row = loadRow<Stretch, T>(all_.rows(slot));
        const T c = length(gatherRelative<T>(sweep.particles, ids, ids + blockSize).xyz) - row.rest;
        const T much = T(tolerance) * row.rest;
        return select(c > much, select(row.compliance < T(slack), T(1), T(0)),
                      select(-c > much, select(row.compression < T(slack), T(1), T(0)), T(0)));
    }

    // Fills off_: the few blocks that have one are gone through once more.
    [[gnu::flatten]] void findOff(const Sweep<Real>& sweep, double tolerance, Workers& workers) {
        constexpr int lanes = Lanes<Wide>::count;
        constexpr int grain = 64;
        workers.forBlocks(static_cast<int>(blocks_.size()), grain, [&](int begin, int end) {
            for (int block = begin; block < end; ++block) {
                Wide sum(0);
                for (int n = 0; n < blockSize; n += lanes)
                    sum = sum + isOff<Wide>(sweep, block * blockSize + n, tolerance);
                Real sums[lanes];
                store(sums, sum);
                blocks_[block] =
                    std::any_of(sums, sums + lanes, [](Real s) { return s > Real(0); });
            }
        });
        off_.clear();
        for (int block = 0; block < static_cast<int>(blocks_.size()); ++block)
            for (int n = block * blockSize; blocks_[block] && n < (block + 1) * blockSize; ++n)
                if (isOff<Real>(sweep, n, tolerance) > Real(0)) off_.push_back(n);
    }

    // The same where only marked vertices have moved since.
    void findStillOff(const Sweep<Real>& sweep, double tolerance) {
        off_.clear();
        for (const int v : marked_)
            for (const int n : slotsAt_[v])
                if ((all_.vertex(n, 0) == v || !near_[all_.vertex(n, 0)]) &&
                    isOff<Real>(sweep, n, tolerance) > Real(0))
                    off_.push_back(n);
    }

    void mark(int v) {
        if (near_[v]) return;
        near_[v] = 1;
        marked_.push_back(v);
    }

    // Marks the vertices of links that are off and, ring by ring, their neighbours. False: none is.
    bool markNear(int rings) {
        for (const int v : marked_) near_[v] = 0;
        marked_.clear();
        for (const int n : off_) mark(all_.vertex(n, 0)), mark(all_.vertex(n, 1));
        std::size_t begin = 0;
        for (int ring = 0; ring < rings; ++ring)
            for (const std::size_t end = marked_.size(); begin < end; ++begin)
                for (const int n : slotsAt_[marked_[begin]])
                    mark(all_.vertex(n, 0)), mark(all_.vertex(n, 1));
        return !marked_.empty();
    }

    void activateNear() {
        for (std::vector<int>& color : byColor_) color.clear();
        for (const int v : marked_)
            for (const int n : slotsAt_[v])
                if (all_.vertex(n, 0) == v && near_[all_.vertex(n, 1)])
                    byColor_[color_[n]].push_back(n);
        active_.clear();
        for (const std::vector<int>& color : byColor_) {
            for (const int n : color)
                active_.add(all_.vertex(n, 0), all_.vertex(n, 1), all_.row(n));
            active_.endColor();
        }
        active_.forgetMultipliers();
    }

    const KernelTable<Real>& kernels_;
    LinkBlocks<Real> all_, active_;
    std::vector<Row> rows_;             // by slot
    std::vector<int> slots_;            // by link
    std::vector<int> color_;            // by slot
    Csr slotsAt_;                       // by vertex
    std::vector<std::uint8_t> blocks_;  // by block: a link is off
    std::vector<int> off_;              // slots
    std::vector<std::uint8_t> near_;    // by vertex: marked
    std::vector<int> marked_;
    std::vector<std::vector<int>> byColor_;  // slots that are to be swept
};

}  // namespace plait
