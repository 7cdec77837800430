// Symmetric positive semidefinite systems whose rows couple with their neighbours, and a few last
// ones, the border, with any: what rows along a curve make, and along one that closes.
#pragma once

#include "../numbers/math.h"

#include <span>
#include <vector>

namespace plait {

// A x = b by L D L^T, in place, in O(n (halfWidth + border)^2). Rows from 0 to n - border - 1 are
// the band, the rest is the border.
class Banded {
public:
    Banded() = default;
    Banded(int rows, int halfWidth, int border);

    int rows() const { return rows_; }

    // A(i, j) and A(j, i), i <= j: both in the band and at most halfWidth apart, or j in the
    // border.
    double& at(int i, int j) { return entries_[place(i, j)]; }
    // The place of A(i, j) in entries(), for those who write it over and over.
    int place(int i, int j) const {
        const bool beside = i < band() && j >= band();
        return rowAt(i) * width_ + (beside ? halfWidth_ + 1 + j - band() : j - i);
    }
    std::span<double> entries() { return entries_; }
    void clear();

    // Turns `b` into x. An unknown whose pivot is at most `least` of its row says nothing that
    // those before it do not say: it is 0. Leaves A factored, which is of no further use.
    void solve(std::vector<double>& b, std::span<const double> least);
    // Of a definite system, three right-hand sides at once.
    void solve(std::vector<Vec<double>>& b);

private:
    // Behind the band there are as many empty rows as it is wide, so that no loop ends early.
    int band() const { return rows_ - border_; }
    int rowAt(int i) const { return i < band() ? i : i + halfWidth_; }

    // W: halfWidth if it is known beforehand, for faster loops; else 0.
    template <int W, class B>
    void solveWide(std::vector<B>& b, std::span<const double> least);
    template <class B>
    void solveAny(std::vector<B>& b, std::vector<B>& padded, std::span<const double> least);

    int rows_ = 0, halfWidth_ = 0, border_ = 0, width_ = 1;
    std::vector<double> entries_;  // by row i: A(i, i) ... A(i, i + halfWidth), then the border
    std::vector<double> one_;      // right-hand sides, with the empty rows
    std::vector<Vec<double>> three_;
};

}  // namespace plait
