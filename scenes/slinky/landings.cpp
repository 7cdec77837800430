#include "landings.h"

#include <cmath>

namespace plait {

Landings::Landings(const Slinky& slinky, double rise, double tread)
    : slinky_(slinky), rise_(rise), tread_(tread) {}

bool Landings::see(std::span<const Vec<double>> positions, double time) {
    constexpr double near = 4e-3;
    const std::size_t before = all_.size(), links = static_cast<std::size_t>(slinky_.links);
    const auto points = positions.first(links * static_cast<std::size_t>(slinky_.turns) + 1);
    for (const bool upper : {false, true}) {
        Vec<double> middle{0, 0, 0};
        for (const Vec<double>& x : upper ? points.last(links) : points.first(links))
            middle += (1.0 / slinky_.links) * x;
        const int on = static_cast<int>(std::floor(middle.x / tread_));
        if (on <= on_[upper] || middle.y + on * rise_ > near) continue;
        on_[upper] = on;
        all_.push_back({upper, on, time});
    }
    return all_.size() > before;
}

}  // namespace plait
