#include "cells.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr int extentBlock = 4096;  // particles, the same for any number of threads
// Wider than what is seen by more than rounding takes from a coordinate of a thousand cells.
constexpr double slack = 1.001;

// With the empty ones around.
double mostCells(int particles) { return 8.0 * particles + 4096; }

template <class Real>
Vec<Real> lesser(const Vec<Real>& a, const Vec<Real>& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

template <class Real>
Vec<Real> greater(const Vec<Real>& a, const Vec<Real>& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace

template <class Real>
auto Cells<Real>::extentOfAll(Workers& workers) -> Extent {
    const int n = count();
    extents_.resize((n + extentBlock - 1) / extentBlock);
    workers.forBlocks(static_cast<int>(extents_.size()), 1, [&](int begin, int end) {
        for (int b = begin; b < end; ++b) {
            Extent of{points_[b * extentBlock], points_[b * extentBlock], {0, 0, 0}};
            for (int i = b * extentBlock; i < std::min(n, (b + 1) * extentBlock); ++i) {
                const Vec<Real>& p = points_[i];
                of.low = lesser(of.low, p);
                of.high = greater(of.high, p);
                of.sum += Vec<double>{double(p.x), double(p.y), double(p.z)};
            }
            extents_[b] = of;
        }
    });
    Extent all = n > 0 ? extents_[0] : Extent{};
    for (std::size_t b = 1; b < extents_.size(); ++b) {
        all.low = lesser(all.low, extents_[b].low);
        all.high = greater(all.high, extents_[b].high);
        all.sum += extents_[b].sum;
    }
    return all;
}

// The box of all; where it has too many cells its longest side shrinks towards the mean.
template <class Real>
void Cells<Real>::choose(Real reach, Workers& workers) {
    const int n = count();
    const Extent all = extentOfAll(workers);
    width_ = static_cast<Real>(slack) * reach;
    perWidth_ = 1 / width_;
    const double mean[3] = {all.sum.x / n, all.sum.y / n, all.sum.z / n};
    double low[3] = {double(all.low.x), double(all.low.y), double(all.low.z)};
    double high[3] = {double(all.high.x), double(all.high.y), double(all.high.z)};
    const auto cells = [&](int a) { return std::floor((high[a] - low[a]) / double(width_)) + 3; };
    while (cells(0) * cells(1) * cells(2) > mostCells(n)) {
        int a = cells(1) > cells(0) ? 1 : 0;
        if (cells(2) > cells(a)) a = 2;
        low[a] += 0.5 * std::max(mean[a] - low[a], 0.0);
        high[a] -= 0.5 * std::max(high[a] - mean[a], 0.0);
    }
    for (int a = 0; a < 3; ++a) {
        const bool sound = high[a] - low[a] < 1e9 * double(width_);
        low_[a] = sound ? static_cast<Real>(low[a]) : Real(0);
        size_[a] = sound ? static_cast<int>(cells(a)) : 3;
    }
}

template <class Real>
void Cells<Real>::place(Workers& workers) {
    const int n = count();
    const std::size_t cells = static_cast<std::size_t>(layer()) * size_[2];
    keys_.resize(n);
    order_.resize(n);
    for (std::vector<Real>* array : {&x_, &y_, &z_}) array->resize(n + slotPadding);
    workers.forBlocks(n, 1024, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) keys_[i] = cellOf(points_[i]);
    });
    // Two places ahead, so that when all are placed each has become where its cell begins.
    start_.reserve(static_cast<std::size_t>(mostCells(n)) + 2);
    start_.assign(cells + 2, 0);
    occupied_.reserve(n);
    occupied_.clear();
    for (int i = 0; i < n; ++i) ++start_[keys_[i] + 2];
    for (std::size_t c = 2; c < start_.size(); ++c) {
        if (start_[c] > 0) occupied_.push_back(static_cast<int>(c) - 2);
        start_[c] += start_[c - 1];
    }
    for (int i = 0; i < n; ++i) order_[start_[keys_[i] + 1]++] = i;
    workers.forBlocks(n, 1024, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            const Vec<Real>& p = points_[order_[s]];
            x_[s] = p.x;
            y_[s] = p.y;
            z_[s] = p.z;
        }
    });
}

template <class Real>
Vec<Real> Cells<Real>::middle(int cell) const {
    const int z = cell / layer(), y = (cell - z * layer()) / row();
    const int x = cell - z * layer() - y * row();
    const auto at = [&](int c, int axis) {
        return low_[axis] + (static_cast<Real>(c) - Real(0.5)) * width_;
    };
    return {at(x, 0), at(y, 1), at(z, 2)};
}

template <class Real>
bool Cells<Real>::isAtEdge(int cell) const {
    const int z = cell / layer(), y = (cell - z * layer()) / row();
    const int at[3] = {cell - z * layer() - y * row(), y, z};
    for (int a = 0; a < 3; ++a)
        if (at[a] == 1 || at[a] == size_[a] - 2) return true;
    return false;
}

template class Cells<float>;
template class Cells<double>;

}  // namespace plait
