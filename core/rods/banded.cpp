#include "banded.h"

#include <algorithm>

namespace plait {

Banded::Banded(int rows, int halfWidth, int border)
    : rows_(rows), halfWidth_(halfWidth), border_(border), width_(halfWidth + 1 + border) {
    entries_.resize((rows + halfWidth) * width_);
}

void Banded::clear() { std::fill(entries_.begin(), entries_.end(), 0.0); }

template <int W, class B>
void Banded::solveWide(std::vector<B>& b, std::span<const double> least) {
    const int near = W > 0 ? W : halfWidth_, width = W > 0 ? W + 1 + border_ : width_;
    const int last = band() + near;  // where the border is
    // The inverse of each pivot stands in its place from here on.
    const auto invert = [&](int i, double* row) {
        return *row = *row > (least.empty() ? 0 : least[i]) ? 1 / *row : 0;
    };
    for (int i = 0; i < band(); ++i) {
        double* const row = &entries_[i * width];
        const double* const edge = row + near + 1;
        const double pivot = invert(i, row);
        for (int k = 1; k <= near; ++k) {
            const double factor = row[k] * pivot;
            double* const other = row + k * width;
            for (int c = k; c <= near; ++c) other[c - k] -= factor * row[c];
            for (int c = 0; c < border_; ++c) other[near + 1 + c] -= factor * edge[c];
            b[i + k] = b[i + k] - factor * b[i];
        }
        for (int k = 0; k < border_; ++k) {
            const double factor = edge[k] * pivot;
            double* const other = &entries_[(last + k) * width];
            for (int c = k; c < border_; ++c) other[c - k] -= factor * edge[c];
            b[last + k] = b[last + k] - factor * b[i];
        }
    }
    for (int i = 0; i < border_; ++i) {
        double* const row = &entries_[(last + i) * width];
        const double pivot = invert(band() + i, row);
        for (int k = 1; k < border_ - i; ++k) {
            const double factor = row[k] * pivot;
            double* const other = row + k * width;
            for (int c = k; c < border_ - i; ++c) other[c - k] -= factor * row[c];
            b[last + i + k] = b[last + i + k] - factor * b[last + i];
        }
    }
    for (int i = border_ - 1; i >= 0; --i) {
        const double* const row = &entries_[(last + i) * width];
        B sum = b[last + i];
        for (int k = 1; k < border_ - i; ++k) sum = sum - row[k] * b[last + i + k];
        b[last + i] = row[0] * sum;
    }
    for (int i = band() - 1; i >= 0; --i) {
        const double* const row = &entries_[i * width];
        B sum = b[i];
        for (int k = 1; k <= near; ++k) sum = sum - row[k] * b[i + k];
        for (int k = 0; k < border_; ++k) sum = sum - row[near + 1 + k] * b[last + k];
        b[i] = row[0] * sum;
    }
}

template <class B>
void Banded::solveAny(std::vector<B>& b, std::vector<B>& padded, std::span<const double> least) {
    padded.assign(rows_ + halfWidth_, B{});
    for (int i = 0; i < rows_; ++i) padded[rowAt(i)] = b[i];
    switch (halfWidth_) {
        case 1:
            solveWide<1>(padded, least);
            break;
        case 2:
            solveWide<2>(padded, least);
            break;
        case 7:
            solveWide<7>(padded, least);
            break;  // straight rods
        case 14:
            solveWide<14>(padded, least);
            break;  // those with frames
        default:
            solveWide<0>(padded, least);
    }
    for (int i = 0; i < rows_; ++i) b[i] = padded[rowAt(i)];
}

void Banded::solve(std::vector<double>& b, std::span<const double> least) {
    solveAny(b, one_, least);
}
void Banded::solve(std::vector<Vec<double>>& b) { solveAny(b, three_, {}); }

}  // namespace plait
