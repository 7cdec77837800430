#include "landings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plait {

Landings::Landings(const Slinky& slinky, double rise, double tread)
    : slinky_(slinky), rise_(rise), tread_(tread) {}

bool Landings::see(std::span<const Vec<double>> positions, double time) {
    constexpr double near = 1.5e-3;
    const std::size_t before = all_.size(), links = static_cast<std::size_t>(slinky_.links);
    const auto points = positions.first(links * static_cast<std::size_t>(slinky_.turns) + 1);
    for (const bool upper : {false, true}) {
        double along = 0, lowest = std::numeric_limits<double>::max();
        for (const Vec<double>& x : upper ? points.last(links) : points.first(links)) {
            along += x.x / slinky_.links;
            lowest = std::min(lowest, x.y);
        }
        const int on = static_cast<int>(std::floor(along / tread_));
        if (on <= on_[upper] || lowest + on * rise_ > near) continue;
        on_[upper] = on;
        all_.push_back({upper, on, time});
    }
    return all_.size() > before;
}

}  // namespace plait
