#include "leak.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

template <class Real>
Vec<Real> narrow(const Vec<double>& v) {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

}  // namespace

Leak::Leak(LeakOptions options, const Gas& gas, std::vector<std::array<int, 3>> triangles,
           std::vector<double> riding, const std::vector<double>& mass)
    : options_(std::move(options)),
      gas_(gas),
      triangles_(std::move(triangles)),
      riding_(std::move(riding)) {
    for (std::size_t v = 0; v < riding_.size(); ++v) {
        skin_.push_back(mass[v] - riding_[v]);
        all_ += riding_[v] * joulesAKilogram();
        if (riding_[v] > 0) carriers_.push_back(static_cast<int>(v));
    }
    for (const auto& t : options_.hole) rim_.insert(rim_.end(), t.begin(), t.end());
    std::ranges::sort(rim_);
    rim_.erase(std::unique(rim_.begin(), rim_.end()), rim_.end());
}

template <class Real>
void Leak::settle(State<Real>& state, Real* kept, double amount, double t, double h) const {
    if (t < options_.opens)
        keep(kept, amount);
    else
        flow(state, kept, h);
    const double part = t < options_.opens ? 1 : left(kept) / all_;
    const Vec<double> fall = h * options_.gravity;
    for (const int v : carriers_) {
        Real& w = state.particles[v].w;
        if (w == 0) continue;
        const double riding = part * riding_[v], mass = skin_[v] + riding;
        w = static_cast<Real>(1 / mass);
        state.velocity[v].v -= narrow<Real>((riding / mass) * fall);
    }
}

template <class Real>
void Leak::flow(State<Real>& state, Real* kept, double h) const {
    const auto at = [&](int v) { return state.position(v); };
    const Vec<double> origin = at(triangles_[0][0]);
    double volume = 0;
    for (const auto& [a, b, c] : triangles_)
        volume += dot(at(a) - origin, cross(at(b) - origin, at(c) - origin)) / 6;
    Vec<double> hole{0, 0, 0};
    for (const auto& [a, b, c] : options_.hole) hole += 0.5 * cross(at(b) - at(a), at(c) - at(a));

    Gas gas = gas_;
    gas.amount = left(kept);
    const double p = std::max(0.0, gas.gauge(volume)), area = length(hole);
    const double density = options_.density * gas.absolute(volume) / gas.outside;
    const double speed = std::sqrt(2 * p / density);
    const double gone =
        std::min(options_.discharge * density * area * speed * h, gas.amount / joulesAKilogram());
    keep(kept, gas.amount - gone * joulesAKilogram());
    if (area == 0) return;
    const Vec<double> impulse = (-gone * speed / area) * hole;
    const double part = 1.0 / static_cast<double>(rim_.size());
    for (const int v : rim_)
        state.velocity[v].v += narrow<Real>(part * double(state.particles[v].w) * impulse);
}

template void Leak::settle(State<float>&, float*, double, double, double) const;
template void Leak::settle(State<double>&, double*, double, double, double) const;

}  // namespace plait
