// FLIP written out from the paper's formulas, without a thought for time: the oracle of the quick
// one. Colours by sRGB's definition (primaries and white point), convolutions in two dimensions,
// weights normalised by their sums.
#pragma once

#include "render/pictures/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace plait::test {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

inline Triple operator*(const Matrix& m, const Triple& v) {
    Triple r{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r[i] += m[i][j] * v[j];
    return r;
}

inline Matrix inverse(const Matrix& m) {
    Matrix r;
    double determinant = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            r[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    for (int j = 0; j < 3; ++j) determinant += m[0][j] * r[j][0];
    for (Triple& row : r)
        for (double& v : row) v /= determinant;
    return r;
}

// IEC 61966-2-1: red (0.64, 0.33), green (0.30, 0.60), blue (0.15, 0.06); white D65, to five digits
// (0.31271, 0.32902).
inline Matrix rgbToXyz() {
    const Matrix primaries{{{0.64, 0.30, 0.15}, {0.33, 0.60, 0.06}, {0.03, 0.10, 0.79}}};
    const Triple scale = inverse(primaries) * Triple{0.31271 / 0.32902, 1, 0.35827 / 0.32902};
    Matrix m = primaries;
    for (Triple& row : m)
        for (int j = 0; j < 3; ++j) row[j] *= scale[j];
    return m;
}

inline double slowDecode(double s) {
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

inline Triple relativeXyz(const Triple& linear) {
    const Matrix m = rgbToXyz();
    const Triple c = m * linear, white = m * Triple{1, 1, 1};
    return {c[0] / white[0], c[1] / white[1], c[2] / white[2]};
}

inline Triple huntLab(const Triple& linear) {
    Triple f = relativeXyz(linear);
    for (double& t : f) t = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    const double L = 116 * f[1] - 16;
    return {L, L / 100 * (500 * (f[0] - f[1])), L / 100 * (200 * (f[1] - f[2]))};
}

inline double hyabDistance(const Triple& a, const Triple& b) {
    return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

inline double slowColorError(double distance) {
    const double cmax = std::pow(hyabDistance(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7);
    const double e = std::pow(distance, 0.7);
    if (e < 0.4 * cmax) return 0.95 / (0.4 * cmax) * e;
    return 0.95 + (e - 0.4 * cmax) / (cmax - 0.4 * cmax) * (1 - 0.95);
}

class SlowFlip {
public:
    explicit SlowFlip(double pixelsPerDegree) : ppd_(pixelsPerDegree) {}

    std::vector<double> operator()(const Picture& a, const Picture& b) {
        width_ = a.width, height_ = a.height;
        const auto opponentA = opponent(a), opponentB = opponent(b);
        const auto labA = filtered(opponentA), labB = filtered(opponentB);
        std::vector<double> errors;
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const int i = y * width_ + x;
                double feature = 0;
                for (const bool point : {false, true})
                    feature = std::max(feature, std::abs(strength(opponentA, point, x, y) -
                                                         strength(opponentB, point, x, y)));
                errors.push_back(std::pow(slowColorError(hyabDistance(labA[i], labB[i])),
                                          1 - std::sqrt(feature / std::sqrt(2.0))));
            }
        return errors;
    }

private:
    std::vector<Triple> opponent(const Picture& picture) const {
        std::vector<Triple> result;
        for (int i = 0; i < width_ * height_; ++i) {
            Triple c;
            for (int k = 0; k < 3; ++k) c[k] = slowDecode(picture.rgb[3 * i + k] / 255.0);
            const Triple r = relativeXyz(c);
            result.push_back({116 * r[1] - 16, 500 * (r[0] - r[1]), 200 * (r[1] - r[2])});
        }
        return result;
    }

    const Triple& at(const std::vector<Triple>& plane, int x, int y) const {
        return plane[std::clamp(y, 0, height_ - 1) * width_ + std::clamp(x, 0, width_ - 1)];
    }

    // What the eye resolves: the channel's contrast sensitivity, in space.
    double sensitivity(int channel, int x, int y) const {
        const double pi2 = std::numbers::pi * std::numbers::pi;
        const double d2 = (x * x + y * y) / (ppd_ * ppd_);
        const auto gaussian = [&](double a, double b) {
            return a * std::sqrt(std::numbers::pi / b) * std::exp(-pi2 * d2 / b);
        };
        if (channel == 0) return gaussian(1, 0.0047);
        if (channel == 1) return gaussian(1, 0.0053);
        return gaussian(34.1, 0.04) + gaussian(13.5, 0.025);
    }

    std::vector<Triple> filtered(const std::vector<Triple>& plane) const {
        const double sigma = std::sqrt(0.04 / 2) / std::numbers::pi;  // degrees, the widest
        const int r = static_cast<int>(std::ceil(3 * sigma * ppd_));
        std::vector<Triple> weights;
        Triple total{};
        for (int y = -r; y <= r; ++y)
            for (int x = -r; x <= r; ++x) {
                weights.push_back(
                    {sensitivity(0, x, y), sensitivity(1, x, y), sensitivity(2, x, y)});
                for (int k = 0; k < 3; ++k) total[k] += weights.back()[k];
            }
        const Matrix toRgb = inverse(rgbToXyz());
        const Triple white = rgbToXyz() * Triple{1, 1, 1};
        std::vector<Triple> result;
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                Triple sum{};
                for (int i = 0, dy = -r; dy <= r; ++dy)
                    for (int dx = -r; dx <= r; ++dx, ++i)
                        for (int k = 0; k < 3; ++k)
                            sum[k] += weights[i][k] / total[k] * at(plane, x + dx, y + dy)[k];
                const double Y = (sum[0] + 16) / 116;
                const Triple xyz{(Y + sum[1] / 500) * white[0], Y * white[1],
                                 (Y - sum[2] / 200) * white[2]};
                Triple rgb = toRgb * xyz;
                for (double& c : rgb) c = std::min(1.0, std::max(0.0, c));
                result.push_back(huntLab(rgb));
            }
        return result;
    }

    // Of edges or points at a pixel: the length of the derivative filters' two answers.
    double strength(const std::vector<Triple>& plane, bool point, int x, int y) const {
        const double s = 0.082 / 2 * ppd_;
        const int r = static_cast<int>(std::ceil(3 * s));
        double positive = 0, negative = 0;
        Triple sums[2]{};  // across, down: of positive and of negative weights
        for (int dy = -r; dy <= r; ++dy)
            for (int dx = -r; dx <= r; ++dx) {
                const double g = std::exp(-(dx * dx + dy * dy) / (2 * s * s));
                const double w = point ? (dx * dx / (s * s) - 1) * g : -dx * g;
                (w > 0 ? positive : negative) += std::abs(w);
                sums[0][w > 0 ? 0 : 1] += w * (at(plane, x + dx, y + dy)[0] + 16) / 116;
                sums[1][w > 0 ? 0 : 1] += w * (at(plane, x + dy, y + dx)[0] + 16) / 116;
            }
        return std::hypot(sums[0][0] / positive + sums[0][1] / negative,
                          sums[1][0] / positive + sums[1][1] / negative);
    }

    double ppd_;
    int width_ = 0, height_ = 0;
};

}  // namespace plait::test
