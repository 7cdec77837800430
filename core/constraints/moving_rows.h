// Rows that move, such as targets and rest lengths: known at both ends of a frame, and between them
// every number changes linearly [IN27, DC11].
#pragma once

#include "rows.h"

namespace plait {

template <class Kind>
class MovingRows {
public:
    using Row = typename Kind::template Row<double>;

    explicit MovingRows(const Rows<Kind>& set) : animate_(set.animate) {
        if (animate_) from_ = to_ = set.rows;
    }

    explicit operator bool() const { return static_cast<bool>(animate_); }

    // A frame from time t0 to t1 (s) begins.
    void beginFrame(double t0, double t1) {
        if (!animate_) return;
        animate_(t0, from_);
        animate_(t1, to_);
    }

    // Row i when the part f of the frame is over, 0 to 1.
    Row at(int i, double f) const {
        constexpr int members = sizeof(Row) / sizeof(double);
        Stencil<double, members> a, b;
        __builtin_memcpy(&a, &from_[i], sizeof(Row));
        __builtin_memcpy(&b, &to_[i], sizeof(Row));
        for (int m = 0; m < members; ++m) a[m] += f * (b[m] - a[m]);
        Row row;
        __builtin_memcpy(&row, &a, sizeof row);
        return row;
    }

private:
    std::function<void(double, std::span<Row>)> animate_;
    std::vector<Row> from_, to_;
};

}  // namespace plait
