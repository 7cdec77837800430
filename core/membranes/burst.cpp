#include "burst.h"

#include "../gas/enclosure.h"
#include "leak.h"

#include <algorithm>
#include <cmath>

namespace plait {

Burst::Burst(const Gas& gas, const std::vector<std::array<int, 3>>& skin)
    : gas_(gas), skin_(skin), fans_(fansOver(skin)) {}

template <class Real>
void Burst::settle(const State<Real>& state, Real* kept, double amount, double h) const {
    if (!open()) return Leak::keep(kept, amount);
    const auto at = [&](int v) { return state.position(v); };
    const Vec<double> origin = at(skin_[0][0]);
    double volume = 0, area = 0;
    const auto add = [&](const std::array<int, 3>& t) {
        volume += dot(at(t[0]) - origin, cross(at(t[1]) - origin, at(t[2]) - origin)) / 6;
    };
    std::ranges::for_each(skin_, add);
    for (const auto& fan : fans_) {
        Vec<double> normal{0, 0, 0};
        std::ranges::for_each(fan, add);
        for (const auto& [a, b, c] : fan) normal += 0.5 * cross(at(b) - at(a), at(c) - at(a));
        area += length(normal);
    }
    Gas gas = gas_;
    gas.amount = Leak::left(kept);
    const double pressure = volume > 0 ? std::max(0.0, gas.gauge(volume)) : 0,
                 inside = density * (pressure + gas.outside) / gas.outside,
                 gone = discharge * area * std::sqrt(2 * pressure * inside) * h;
    Leak::keep(kept, std::max(0.0, gas.amount - gone * gas.outside / density));
}

template void Burst::settle(const State<float>&, float*, double, double) const;
template void Burst::settle(const State<double>&, double*, double, double) const;

}  // namespace plait
