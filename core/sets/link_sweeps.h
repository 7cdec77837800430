// Sweeps over links: over all of them, or only where they are off. Wide and threaded, with the same
// bits for any number of threads and lanes.
#pragma once

#include "link_blocks.h"

#include <algorithm>
#include <array>
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
            byColor_[colors[i]].push_back({ids[2 * i], ids[2 * i + 1], static_cast<int>(i)});
        slots_.resize(colors.size());
        for (const std::vector<std::array<int, 3>>& color : byColor_) {
            for (const auto& [a, b, link] : color) slots_[link] = all_.add(a, b, {});
            all_.endColor();
        }
        rows_.resize(static_cast<std::size_t>(all_.size()));
        blocks_.resize(rows_.size() / blockSize);
        off_.reserve(ids.size());
        joinLinks(ids, colors);
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
        return all_.project(sweep, direction, kernels_.project, workers);
    }
    long mend(const Sweep<Real>& sweep, const Mending& mending, Workers& workers) {
        long work = 0;
        for (int round = 0; round < mending.rounds; ++round) {
            off_.clear();
            findOff(sweep, round ? active_ : all_, mending.tolerance, workers);
            if (round) findOffAround(sweep, mending.tolerance);
            if (!markNear(mending.rings)) break;
            activateNear();
            for (int i = 0; i < mending.sweeps; ++i)
                work += active_.project(sweep, i % 2 ? Direction::backward : Direction::forward,
                                        kernels_.project, workers);
        }
        return work;
    }

private:
    // As wide as every level of x86-64 is: what a pass only compares has the same bits anyway.
    using Wide = std::conditional_t<std::is_same_v<Real, float>, Pack<4>, Real>;

    // A link as its vertex at hand sees it.
    struct Joined {
        int slot, other, color;
        bool first;  // the vertex at hand is the link's first
    };

    void joinLinks(std::span<const int> ids, std::span<const int> colors) {
        start_.assign(near_.size() + 1, 0);
        for (const int v : ids) ++start_[v + 1];
        for (std::size_t v = 0; v < near_.size(); ++v) start_[v + 1] += start_[v];
        joined_.resize(ids.size());
        std::vector<int> end(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < ids.size(); ++i)
            joined_[end[ids[i]]++] = {slots_[i / 2], ids[i ^ 1], colors[i / 2], i % 2 == 0};
    }

    std::span<const Joined> at(int v) const {
        return std::span(joined_).subspan(start_[v], start_[v + 1] - start_[v]);
    }

    // 1 where a link is off to a side that it acts on.
    template <class T>
    static T isOff(const Sweep<Real>& sweep, const LinkBlocks<Real>& links, int slot,
                   double tolerance) {
        const int* ids = links.ids(slot);
        const auto row = loadRow<Stretch, T>(links.rows(slot));
        const T c = length(gatherRelative<T>(sweep.particles, ids, ids + blockSize).xyz) - row.rest;
        const T much = T(tolerance) * row.rest;
        return select(c > much, select(row.compliance < T(slack), T(1), T(0)),
                      select(-c > much, select(row.compression < T(slack), T(1), T(0)), T(0)));
    }

    // Adds to off_: the few blocks that have one are gone through once more.
    [[gnu::flatten]] void findOff(const Sweep<Real>& sweep, const LinkBlocks<Real>& links,
                                  double tolerance, Workers& workers) {
        constexpr int lanes = Lanes<Wide>::count;
        constexpr int grain = 64;
        const int blocks = links.size() / blockSize;
        workers.forBlocks(blocks, grain, [&](int begin, int end) {
            for (int block = begin; block < end; ++block) {
                Wide sum(0);
                for (int n = 0; n < blockSize; n += lanes)
                    sum = sum + isOff<Wide>(sweep, links, block * blockSize + n, tolerance);
                Real sums[lanes];
                store(sums, sum);
                blocks_[block] =
                    std::any_of(sums, sums + lanes, [](Real s) { return s > Real(0); });
            }
        });
        for (int block = 0; block < blocks; ++block)
            for (int n = block * blockSize; blocks_[block] && n < (block + 1) * blockSize; ++n)
                if (isOff<Real>(sweep, links, n, tolerance) > Real(0))
                    off_.insert(off_.end(), {links.vertex(n, 0), links.vertex(n, 1)});
    }

    // Adds those with one end marked, and so in the last ring: only marked vertices have moved
    // since these were last looked at, and the links between them are the active ones.
    void findOffAround(const Sweep<Real>& sweep, double tolerance) {
        for (std::size_t i = lastRing_; i < marked_.size(); ++i)
            for (const Joined& link : at(marked_[i]))
                if (!near_[link.other] && isOff<Real>(sweep, all_, link.slot, tolerance) > Real(0))
                    off_.insert(off_.end(), {marked_[i], link.other});
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
        for (const int v : off_) mark(v);
        lastRing_ = 0;
        for (int ring = 0; ring < rings; ++ring) {
            const std::size_t end = marked_.size();
            for (std::size_t i = lastRing_; i < end; ++i)
                for (const Joined& link : at(marked_[i])) mark(link.other);
            lastRing_ = end;
        }
        return !marked_.empty();
    }

    void activateNear() {
        for (std::vector<std::array<int, 3>>& color : byColor_) color.clear();
        for (const int v : marked_)
            for (const Joined& link : at(v))
                if (link.first && near_[link.other])
                    byColor_[link.color].push_back({v, link.other, link.slot});
        active_.clear();
        for (const std::vector<std::array<int, 3>>& color : byColor_) {
            for (const auto& [a, b, slot] : color) active_.add(a, b, all_.row(slot));
            active_.endColor();
        }
        active_.forgetMultipliers();
    }

    const KernelTable<Real>& kernels_;
    LinkBlocks<Real> all_, active_;
    std::vector<Row> rows_;   // by slot
    std::vector<int> slots_;  // by link
    std::vector<int> start_;  // by vertex, one more: of its links in joined_
    std::vector<Joined> joined_;
    std::vector<std::uint8_t> blocks_;  // by block: a link is off
    std::vector<int> off_;              // vertices of links that are off
    std::vector<std::uint8_t> near_;    // by vertex: marked
    std::vector<int> marked_;           // from lastRing_ on of the last ring
    std::size_t lastRing_ = 0;
    std::vector<std::vector<std::array<int, 3>>> byColor_;  // to be swept: two vertices, a slot
};

}  // namespace plait
