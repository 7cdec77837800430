// A tree of bounds round the primitives of a mesh: built once, refitted each substep (S 7, M 2.4).
#pragma once

#include "candidates.h"
#include "kdop.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plait {

// Primitives are numbered 0 .. count - 1; bound(i) gives the Bounds of one (KDop, or MovingKDop)
// and is called from all threads. Nothing is allocated after construction but what the list of
// candidates grows by.
template <class Bounds>
class BoundsTree {
public:
    // Halves the primitives at the median of their centres, along the axis on which these lie
    // furthest apart, down to a few. A sort's time.
    template <class Bound>
    BoundsTree(int count, const Bound& bound, Workers& workers)
        : items_(count), place_(count), bounds_(count) {
        while ((count >> depth_) > leafSize) ++depth_;
        nodes_.resize(std::size_t(2) << depth_);
        std::vector<Centre> centres(count);
        workers.forBlocks(count, 1024, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) centres[i] = {bound(i).centre(), i};
        });
        for (int level = 0; level < depth_; ++level)
            workers.forBlocks(1 << level, 1, [&](int begin, int end) {
                for (int node = begin; node < end; ++node) halve(centres, level, node);
            });
        for (int i = 0; i < count; ++i) place_[items_[i] = centres[i].item] = i;
        refit(bound, workers);
    }

    int count() const { return static_cast<int>(items_.size()); }

    // New bounds, the same tree.
    template <class Bound>
    void refit(const Bound& bound, Workers& workers) {
        // In the order of the primitives, near that of the vertices.
        workers.forBlocks(count(), 256, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) bounds_[place_[i]] = bound(i);
        });
        isStale_.assign(std::size_t(parts()), 1);
        fitStale(workers);
    }

    // The same where only these have new ones.
    template <class Bound>
    void refit(std::span<const int> primitives, const Bound& bound, Workers& workers) {
        isStale_.assign(std::size_t(parts()), 0);
        for (const int i : primitives) {
            bounds_[place_[i]] = bound(i);
            isStale_[((place_[i] + 1L) * parts() - 1) / count()] = 1;
        }
        fitStale(workers);
    }

    // Calls visit(i) for every primitive whose bounds overlap these.
    template <class Visit>
    void overlapping(const Bounds& bounds, const Visit& visit) const {
        descend(1, bounds, visit);
    }

    // The pairs a < b of primitives whose bounds overlap and that accept(a, b); in the order of the
    // tree, whatever the threads.
    template <class Accept = AnyPair>
    void selfPairs(Candidates& found, Workers& workers, const Accept& accept = {}) const {
        found.collect(parts(), workers, [&](int part, Candidates::List& list) {
            const auto add = [&](int a, int b) {
                const Candidate pair{std::min(a, b), std::max(a, b)};
                if (accept(pair.a, pair.b)) list.push_back(pair);
            };
            const int node = parts() + part;
            within(node, add);
            // With all that lies to the right of it.
            for (int n = node; n > 1; n /= 2)
                if (n % 2 == 0) across(node, *this, n + 1, add);
        });
    }

    // The same for a of this tree and b of another.
    template <class Accept = AnyPair>
    void pairs(const BoundsTree& other, Candidates& found, Workers& workers,
               const Accept& accept = {}) const {
        found.collect(parts(), workers, [&](int part, Candidates::List& list) {
            across(parts() + part, other, 1, [&](int a, int b) {
                if (accept(a, b)) list.push_back({a, b});
            });
        });
    }

private:
    static constexpr int leafSize = 4, partsDepth = 8;

    struct Centre {
        Vec<float> x;
        int item;
    };

    // Node n has the children 2 n and 2 n + 1, and the root is 1. The leaves are the last level.
    bool isLeaf(int n) const { return n >> depth_; }

    // Where the primitives of node `index` of a level begin.
    int first(int level, int index) const {
        return static_cast<int>(static_cast<long>(items_.size()) * index >> level);
    }
    std::pair<int, int> rangeOf(int leaf) const {
        const int index = leaf - (1 << depth_);
        return {first(depth_, index), first(depth_, index + 1)};
    }

    // Subtrees that are worked on in parallel: as many for any number of threads.
    int parts() const { return 1 << std::min(depth_, partsDepth); }

    void halve(std::vector<Centre>& centres, int level, int node) const {
        const auto at = centres.begin();
        const int begin = first(level, node), end = first(level, node + 1);
        Vec<float> low = at[begin].x, high = low;
        for (int i = begin; i < end; ++i) {
            const Vec<float>& x = at[i].x;
            low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
            high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
        }
        const Vec<float> size = high - low;
        const auto axis = size.x >= size.y && size.x >= size.z ? &Vec<float>::x
                          : size.y >= size.z                   ? &Vec<float>::y
                                                               : &Vec<float>::z;
        const int middle = first(level + 1, 2 * node + 1);
        std::nth_element(at + begin, at + middle, at + end, [&](const Centre& a, const Centre& b) {
            return a.x.*axis < b.x.*axis || (a.x.*axis == b.x.*axis && a.item < b.item);
        });
    }

    void join(int n) {
        nodes_[n] = nodes_[2 * n];
        nodes_[n].include(nodes_[2 * n + 1]);
    }

    void fitStale(Workers& workers) {
        workers.forBlocks(parts(), 1, [&](int begin, int end) {
            for (int part = begin; part < end; ++part)
                if (isStale_[part]) fit(parts() + part);
        });
        for (int n = parts() - 1; n > 0; --n) join(n);
    }

    void fit(int n) {
        if (!isLeaf(n)) {
            fit(2 * n);
            fit(2 * n + 1);
            return join(n);
        }
        nodes_[n] = Bounds::nothing();
        for (auto [i, end] = rangeOf(n); i < end; ++i) nodes_[n].include(bounds_[i]);
    }

    template <class Visit>
    void descend(int n, const Bounds& bounds, const Visit& visit) const {
        if (!nodes_[n].overlaps(bounds)) return;
        if (!isLeaf(n)) {
            descend(2 * n, bounds, visit);
            return descend(2 * n + 1, bounds, visit);
        }
        for (auto [i, end] = rangeOf(n); i < end; ++i)
            if (bounds_[i].overlaps(bounds)) visit(items_[i]);
    }

    template <class Add>
    void within(int n, const Add& add) const {
        if (!isLeaf(n)) {
            within(2 * n, add);
            within(2 * n + 1, add);
            return across(2 * n, *this, 2 * n + 1, add);
        }
        const auto [begin, end] = rangeOf(n);
        for (int i = begin; i < end; ++i)
            for (int j = i + 1; j < end; ++j)
                if (bounds_[i].overlaps(bounds_[j])) add(items_[i], items_[j]);
    }

    // Node n with node m of the other tree; the shallower one is opened first.
    template <class Add>
    void across(int n, const BoundsTree& other, int m, const Add& add) const {
        if (!nodes_[n].overlaps(other.nodes_[m])) return;
        if (!isLeaf(n) && (n < m || other.isLeaf(m))) {
            across(2 * n, other, m, add);
            across(2 * n + 1, other, m, add);
        } else if (!other.isLeaf(m)) {
            across(n, other, 2 * m, add);
            across(n, other, 2 * m + 1, add);
        } else {
            const auto [begin, end] = rangeOf(n);
            const auto [otherBegin, otherEnd] = other.rangeOf(m);
            for (int i = begin; i < end; ++i) {
                if (!bounds_[i].overlaps(other.nodes_[m])) continue;
                for (int j = otherBegin; j < otherEnd; ++j)
                    if (bounds_[i].overlaps(other.bounds_[j])) add(items_[i], other.items_[j]);
            }
        }
    }

    int depth_ = 0;
    std::vector<int> items_, place_;     // from leaf to leaf, and where each is among them
    std::vector<Bounds> bounds_;         // of items_
    std::vector<Bounds> nodes_;          // nodes_[0] is unused
    std::vector<std::uint8_t> isStale_;  // by part: bounds in it are new
};

template <int k>
using KDopTree = BoundsTree<KDop<k>>;

}  // namespace plait
