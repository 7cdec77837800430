// Sweeps over links for a method that solves for their tensions: over all of them, or only where
// they are off. Wide and threaded, with the same bits for any number of threads and lanes.
#pragma once

#include "../csr.h"
#include "link_blocks.h"
#include "xpbd.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace plait {

// Which links are off, and what is done about it.
struct Mending {
    double tolerance;  // part of its length by which a link may be off
    int rings = 5;     // of neighbours that are swept with those that are off by more
    int sweeps = 30;   // in a round
    int rounds = 2;    // after each, the links that are off are looked for again
};

template <class Real>
class LinkSweeps {
public:
    using Row = typename LinkBlocks<Real>::Row;

    // `ids`: two vertices a link. `padding`: a vertex without mass, above all others.
    LinkSweeps(std::span<const int> ids, int padding, KernelChoice kernels)
        : kernel_(kernelTable<Stretch, Real>(kernels).project[0]), all_(padding), active_(padding) {
        const std::vector<int> colors = greedyColors(ids, 2, padding + 1);
        const int count = colors.empty() ? 0 : *std::max_element(colors.begin(), colors.end()) + 1;
        std::vector<std::vector<int>> members(static_cast<std::size_t>(count));
        for (int i = 0; i < static_cast<int>(colors.size()); ++i) members[colors[i]].push_back(i);
        slots_.resize(colors.size());
        for (const std::vector<int>& color : members) {
            for (const int i : color) slots_[i] = all_.add(ids[2 * i], ids[2 * i + 1], {});
            all_.endColor();
        }
        rows_.resize(static_cast<std::size_t>(all_.size()));
        near_.resize(static_cast<std::size_t>(padding) + 1);
        marked_.reserve(near_.size());
        joinNeighbours(ids);
        active_ = all_;  // its memory
    }

    const LinkBlocks<Real>& links() const { return all_; }
    int slot(int link) const { return slots_[static_cast<std::size_t>(link)]; }
    const Row& row(int slot) const { return rows_[static_cast<std::size_t>(slot)]; }
    void setRow(int slot, const Row& row) { rows_[static_cast<std::size_t>(slot)] = row; }

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

    // Both return the counted work. `h`: the step that compliance sees, s.
    long sweep(State<Real>& state, double h, Direction direction, Workers& workers) {
        return all_.project(sweepOf(state, h), direction, kernel_, workers);
    }
    long mend(State<Real>& state, double h, const Mending& mending, Workers& workers) {
        long work = 0;
        for (int round = 0; round < mending.rounds; ++round) {
            if (!findNear(state, mending)) break;
            active_.clear();
            const auto addIfNear = [&](int n) {
                const int a = all_.vertex(n, 0), b = all_.vertex(n, 1);
                if (near_[a] && near_[b]) active_.add(a, b, all_.row(n));
            };
            all_.forEachColor(addIfNear, [&] { active_.endColor(); });
            active_.forgetMultipliers();
            for (int sweep = 0; sweep < mending.sweeps; ++sweep)
                work += active_.project(sweepOf(state, h),
                                        sweep % 2 ? Direction::backward : Direction::forward,
                                        kernel_, workers);
        }
        return work;
    }

private:
    static Sweep<Real> sweepOf(State<Real>& state, double h) {
        Sweep<Real> sweep = xpbdSweep<Real>(h);
        sweep.particles = &state.particles[0].x.x;
        return sweep;
    }

    void joinNeighbours(std::span<const int> ids) {
        std::vector<int>& start = neighbours_.start;
        start.assign(near_.size() + 1, 0);
        for (const int v : ids) ++start[v + 1];
        for (std::size_t v = 0; v < near_.size(); ++v) start[v + 1] += start[v];
        neighbours_.item.resize(ids.size());
        std::vector<int> end(start.begin(), start.end() - 1);
        for (std::size_t i = 0; i < ids.size(); ++i) neighbours_.item[end[ids[i]]++] = ids[i ^ 1];
    }

    void mark(int v) {
        if (near_[v]) return;
        near_[v] = 1;
        marked_.push_back(v);
    }

    // Marks the vertices of links that are off and, ring by ring, their neighbours. False: none is.
    bool findNear(const State<Real>& state, const Mending& mending) {
        for (const int v : marked_) near_[v] = 0;
        marked_.clear();
        for (int n = 0; n < all_.size(); ++n) {
            const int a = all_.vertex(n, 0), b = all_.vertex(n, 1);
            const Particle<Real>&p = state.particles[a], &q = state.particles[b];
            const Row row = all_.row(n);
            const Real c = length((q.x - p.x) + (q.d - p.d)) - row.rest;
            const Real compliance = c > Real(0) ? row.compliance : row.compression;
            if (std::fabs(c) <= static_cast<Real>(mending.tolerance) * row.rest ||
                !(compliance < Real(slack)))
                continue;
            mark(a);
            mark(b);
        }
        std::size_t begin = 0;
        for (int ring = 0; ring < mending.rings; ++ring) {
            const std::size_t end = marked_.size();
            for (; begin < end; ++begin)
                for (const int v : neighbours_[marked_[begin]]) mark(v);
        }
        return !marked_.empty();
    }

    Kernel<Real> kernel_;
    LinkBlocks<Real> all_, active_;
    std::vector<Row> rows_;   // by slot
    std::vector<int> slots_;  // by link
    Csr neighbours_;
    std::vector<std::uint8_t> near_;  // by vertex: marked
    std::vector<int> marked_;
};

}  // namespace plait
