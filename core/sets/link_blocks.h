// Links of any sets, coloured and laid out in blocks as the kernels of Stretch take them, for
// sweeps over a choice of them.
#pragma once

#include "constraint_set.h"

#include <vector>

namespace plait {

template <class Real>
class LinkBlocks {
public:
    using Row = Stretch::Row<Real>;

    // `padding`: a vertex without mass. The links of one colour come one after another.
    explicit LinkBlocks(int padding) : padding_(padding) {}

    void clear() {
        ids_.clear(), rows_.clear(), lambda_.clear(), ends_.clear();
        slots_ = 0;
        count_ = 0;
    }
    // Returns its slot.
    int add(int a, int b, const Row& row) {
        if (slots_ % blockSize == 0) {
            ids_.resize(ids_.size() + 2 * blockSize, padding_);
            rows_.resize(rows_.size() + 3 * blockSize, Real(0));
            lambda_.resize(lambda_.size() + blockSize);
        }
        ids_[at<2>(slots_, 0)] = a;
        ids_[at<2>(slots_, 1)] = b;
        setRow(slots_, row);
        ++count_;
        return slots_++;
    }
    void endColor() {
        slots_ = (slots_ + blockSize - 1) / blockSize * blockSize;
        if (slots_ > (ends_.empty() ? 0 : ends_.back())) ends_.push_back(slots_);
    }

    // Slots, those included that only fill up a block: their ends are `padding`.
    int size() const { return slots_; }
    long count() const { return count_; }                                        // links
    int end(int color) const { return ends_[static_cast<std::size_t>(color)]; }  // slots
    // Those of a slot, as lanes load them.
    const int* ids(int slot) const { return &ids_[at<2>(slot, 0)]; }
    const Real* rows(int slot) const { return &rows_[at<3>(slot, 0)]; }
    int vertex(int slot, int end) const { return ids_[at<2>(slot, end)]; }
    Row row(int slot) const {
        return {rows_[at<3>(slot, 0)], rows_[at<3>(slot, 1)], rows_[at<3>(slot, 2)]};
    }
    void setRow(int slot, const Row& row) {
        rows_[at<3>(slot, 0)] = row.rest;
        rows_[at<3>(slot, 1)] = row.compliance;
        rows_[at<3>(slot, 2)] = row.compression;
    }

    // body(begin, end) of slots, none of which share a vertex.
    template <class Body>
    void forColors(bool back, Workers& workers, const Body& body) const {
        constexpr int grain = 16;  // blocks a thread takes at least: below, a barrier costs more
        for (std::size_t c = 0; c < ends_.size(); ++c) {
            const std::size_t color = back ? ends_.size() - 1 - c : c;
            const int first = color ? ends_[color - 1] : 0;
            workers.forBlocks((ends_[color] - first) / blockSize, grain, [&](int begin, int end) {
                body(first + begin * blockSize, first + end * blockSize);
            });
        }
    }

    void forgetMultipliers() { std::fill(lambda_.begin(), lambda_.end(), Real(0)); }
    // Every link once. Returns the counted work.
    long project(const Sweep<Real>& sweep, Direction direction, Kernel<Real> kernel,
                 Workers& workers) {
        const Batch<Real> batch{ids_.data(), rows_.data(), lambda_.data(), nullptr};
        forColors(direction == Direction::backward, workers,
                  [&](int begin, int end) { kernel(sweep, batch, begin, end); });
        return count_;
    }

private:
    template <int members>
    static std::size_t at(int slot, int member) {
        const int lane = slot % blockSize;
        return static_cast<std::size_t>(slot - lane) * members + member * blockSize + lane;
    }

    int padding_, slots_ = 0;
    long count_ = 0;
    std::vector<int> ids_, ends_;  // ends of colours
    std::vector<Real> rows_, lambda_;
};

}  // namespace plait
