#include "profile_grid.h"

#include "../../numbers/math.h"

#include <algorithm>

namespace plait {
namespace {

std::span<const int> part(const std::vector<int>& all, const std::vector<int>& start,
                          std::size_t i) {
    return std::span(all).subspan(static_cast<std::size_t>(start[i]),
                                  static_cast<std::size_t>(start[i + 1] - start[i]));
}

}  // namespace

ProfileGrid::ProfileGrid(const std::vector<std::array<double, 2>>& corners,
                         const std::function<double(std::size_t, double, double)>& squaredTo,
                         const std::function<bool(double, double)>& inside) {
    double wide = 0, low = infinity, high = -infinity;
    for (const auto& [r, y] : corners) {
        wide = std::max(wide, r);
        low = std::min(low, y);
        high = std::max(high, y);
    }
    const double size = std::max(wide, high - low);
    step_ = 3 * size / cells;
    low_ = low - 0.5 * (3 * size - (high - low));
    columns_ = std::min(cells, static_cast<int>((wide + size) / step_) + 1);
    rows_ = cells;
    // What is nearest to a point of a cell is no farther from its middle than the nearest to that
    // and twice the way there.
    const double reach = 2 * 0.7072 * step_;
    const std::size_t n = corners.size();
    std::vector<double> away(n);
    nearestStart_ = crossingStart_ = {0};
    for (int j = 0; j < rows_; ++j) {
        const double bottom = low_ + j * step_, y = bottom + 0.5 * step_;
        for (std::size_t e = 0; e < n; ++e) {
            const double a = corners[e][1], b = corners[(e + 1) % n][1];
            if (std::min(a, b) <= bottom + 1.001 * step_ && std::max(a, b) >= bottom - 1e-3 * step_)
                crossing_.push_back(static_cast<int>(e));
        }
        crossingStart_.push_back(static_cast<int>(crossing_.size()));
        for (int i = 0; i < columns_; ++i) {
            const double r = (i + 0.5) * step_;
            double least = infinity;
            for (std::size_t e = 0; e < n; ++e) {
                away[e] = squareRoot(squaredTo(e, r, y));
                least = std::min(least, away[e]);
            }
            for (std::size_t e = 0; e < n; ++e)
                if (away[e] <= least + 1.001 * reach) nearest_.push_back(static_cast<int>(e));
            nearestStart_.push_back(static_cast<int>(nearest_.size()));
            within_.push_back(least <= 0.51 * reach ? Within::mixed
                              : inside(r, y)        ? Within::yes
                                                    : Within::no);
        }
    }
}

ProfileGrid::Cell ProfileGrid::at(double radius, double height) const {
    const double x = radius / step_, y = (height - low_) / step_;
    if (!(x < columns_ && y >= 0 && y < rows_)) return {{}, {}, Within::mixed};
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const std::size_t cell = j * static_cast<std::size_t>(columns_) + i;
    return {part(nearest_, nearestStart_, cell), part(crossing_, crossingStart_, j), within_[cell]};
}

}  // namespace plait
