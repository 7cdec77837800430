#include "turned_shade.h"

#include "../numbers/elementary.h"
#include "spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace plait {
namespace {

constexpr int stepsInReach = 8;
constexpr int rays = 384;

// Evenly over half a sphere, of which the other half is the mirror image (Gonzalez, Measurement of
// areas on a sphere using Fibonacci and latitude-longitude lattices, 2010).
std::vector<Vec<double>> fan() {
    constexpr double golden = 2.399963229728653;  // rad
    std::vector<Vec<double>> directions;
    for (int i = 0; i < rays; ++i) {
        const double z = (i + 0.5) / rays, r = squareRoot(1 - z * z);
        directions.push_back({r * cosine(golden * i), r * sine(golden * i), z});
    }
    return directions;
}

// Of one ray. From inside a wall what is hidden is what lies in it, and what lies beyond where the
// ray meets it again.
double hiddenOn(const Profile& profile, const Vec<double>& from, const Vec<double>& direction,
                std::span<const std::size_t> edges, double reach, bool inside) {
    const double first = profile.met(from, direction, edges, reach);
    const double beyond = CubicSpline::beyondInCone(first / reach);
    if (!inside) return beyond;
    const double past = first + 1e-9 * reach;
    const double again =
        past + profile.met(from + past * direction, direction, edges, reach - past);
    return 1 - beyond + CubicSpline::beyondInCone(again / reach);
}

double partAt(const Profile& profile, double radius, double height, double reach,
              const std::vector<Vec<double>>& directions) {
    const bool inside = profile.contains(radius, height);
    const auto edges = profile.edgesNear(radius, height, reach);
    if (edges.empty()) return inside ? 1 : 0;
    double sum = 0;
    for (const Vec<double>& d : directions)
        sum += hiddenOn(profile, {radius, height, 0}, d, edges, reach, inside);
    return sum / static_cast<double>(directions.size());
}

// Catmull and Rom's cubic through four numbers in a row: the weight of each, a part f of the way
// from the second to the third, and its derivative.
struct Cubic {
    std::array<double, 4> weight, slope;
    explicit Cubic(double f) {
        const double g = f * f, h = g * f;
        weight = {0.5 * (-f + 2 * g - h), 1 - 2.5 * g + 1.5 * h, 0.5 * (f + 4 * g - 3 * h),
                  0.5 * (h - g)};
        slope = {0.5 * (-1 + 4 * f - 3 * g), -5 * f + 4.5 * g, 0.5 * (1 + 8 * f - 9 * g),
                 0.5 * (3 * g - 2 * f)};
    }
};

}  // namespace

TurnedShade::TurnedShade(const Profile& profile, double reach) : step_(reach / stepsInReach) {
    double widest = 0, low = infinity, high = -infinity;
    for (const auto& [r, y] : profile.corners()) {
        widest = std::max(widest, r);
        low = std::min(low, y);
        high = std::max(high, y);
    }
    bottom_ = low - reach - 2 * step_;
    columns_ = static_cast<int>((widest + reach) / step_) + 5;
    rows_ = static_cast<int>((high + reach - bottom_) / step_) + 5;
    const std::vector<Vec<double>> directions = fan();
    // Off the grid by next to nothing: on a wall's surface itself every ray meets it at once.
    const double right = 1.3e-5 * reach, up = 1.7e-5 * reach;
    parts_.resize(static_cast<std::size_t>(columns_) * rows_);
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i)
            parts_[static_cast<std::size_t>(j) * columns_ + i] =
                static_cast<float>(partAt(profile, std::abs(i - 1) * step_ + right,
                                          bottom_ + j * step_ + up, reach, directions));
}

TurnedShade::At TurnedShade::at(double radius, double height) const {
    const double x = radius / step_ + 1, y = (height - bottom_) / step_;
    if (!(x >= 1 && x < columns_ - 2 && y >= 1 && y < rows_ - 2)) return {0, 0, 0};
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const Cubic across(x - i), up(y - j);
    At sum{0, 0, 0};
    for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a) {
            const double part =
                double(parts_[static_cast<std::size_t>(j + b - 1) * columns_ + i + a - 1]);
            sum.part += across.weight[a] * up.weight[b] * part;
            sum.byRadius += across.slope[a] * up.weight[b] * part / step_;
            sum.byHeight += across.weight[a] * up.slope[b] * part / step_;
        }
    sum.part = std::clamp(sum.part, 0.0, 1.0);
    return sum;
}

}  // namespace plait
