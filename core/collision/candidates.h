// Pairs of primitives whose bounds overlap: what the queries are asked about.
#pragma once

#include "../kernels/workers.h"

#include <algorithm>
#include <atomic>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace plait {

// Of one set a < b; of two, a of the first and b of the second.
struct Candidate {
    int a, b;
    auto operator<=>(const Candidate&) const = default;
};

// Accepts every pair.
struct AnyPair {
    bool operator()(int, int) const { return true; }
};

// Accepts pairs that share no vertex. Tables of `arityA` and `arityB` vertices a primitive.
struct NoSharedVertex {
    std::span<const int> a;
    int arityA;
    std::span<const int> b;
    int arityB;

    bool operator()(int i, int j) const {
        for (const int v : a.subspan(std::size_t(i) * arityA, arityA))
            for (const int u : b.subspan(std::size_t(j) * arityB, arityB))
                if (u == v) return false;
        return true;
    }
};

// A list found in parts, in the order of the parts: the same for any number of threads. Memory is
// kept from one time to the next.
class Candidates {
public:
    using List = std::vector<Candidate>;

    std::span<const Candidate> pairs() const { return pairs_; }

    // Replaces the list by what find(part, list) appends for each part in [0, parts).
    template <class Find>
    void collect(int parts, Workers& workers, const Find& find) {
        if (parts_.size() < std::size_t(parts)) parts_.resize(parts);
        // Parts are taken one by one, since they differ in length as much as a scene does.
        std::atomic<int> next{0};
        workers.forBlocks(workers.threads(), 1, [&](int, int) {
            for (int part = next++; part < parts; part = next++) {
                List list = std::move(parts_[part]);  // threads would share its cache line
                list.clear();
                find(part, list);
                parts_[part] = std::move(list);
            }
        });
        first_.assign(1, 0);
        for (int part = 0; part < parts; ++part)
            first_.push_back(first_.back() + parts_[part].size());
        pairs_.resize(first_.back());
        workers.forBlocks(parts, 1, [&](int begin, int end) {
            for (int part = begin; part < end; ++part)
                std::ranges::copy(parts_[part], pairs_.begin() + std::ptrdiff_t(first_[part]));
        });
    }

private:
    std::vector<List> parts_;
    std::vector<std::size_t> first_;  // of each part in pairs_
    List pairs_;
};

}  // namespace plait
