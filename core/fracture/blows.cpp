#include "blows.h"

#include "../numbers/elementary.h"

#include <algorithm>
#include <cmath>

namespace plait {

double Blow::energy() const { return length(impulse) * approach / 2; }

Blows::Blows(const World& world, const WeldMatter& matter)
    : matter_(matter), gravity_(world.gravity) {
    constexpr double poisson = 0.22;
    const double t = matter.plate;
    // 8 sqrt(D rho t), D = E t^3 / 12 (1 - nu^2).
    impedance_ =
        8 * t * t * std::sqrt(matter.stiffness * matter.density / (12 * (1 - poisson * poisson)));
    for (const Range& piece : world.pieces) {
        double mass = 0, radius = 0;
        Vec<double> centre{};
        for (int v = piece.first; v < piece.last; ++v) {
            mass += world.mass[v];
            centre += world.mass[v] * world.start[v];
        }
        for (int v = piece.first; v < piece.last; ++v)
            radius = std::max(radius, length(world.start[v] - (1 / mass) * centre));
        radius_.push_back(radius);
    }
}

std::vector<Blow> Blows::among(std::span<const Load> loads, double h) const {
    std::vector<Blow> blows;
    for (const Load& load : loads) {
        auto blow = std::ranges::find(blows, load.other, &Blow::other);
        if (blow == blows.end()) blow = blows.insert(blow, {.other = load.other});
        blow->impulse += (1 / h) * load.whole;
        blow->approach = std::max(blow->approach, load.approach);
    }
    std::erase_if(blows, [&](const Blow& b) { return b.approach <= 2 * gravity_ * h; });
    return blows;
}

// t = 2.87 (m^2 / (R E^2 v))^(1/5) (Hertz 1882; Goldsmith, Impact, 1960), with the mass that stops:
// impulse over approach. A plate bears no more than its impedance times v.
double Blows::timeOf(const Blow& blow) const {
    const double mass = length(blow.impulse) / blow.approach;
    const double e = matter_.contactStiffness;
    const double hertz =
        2.87 * power(mass * mass / (radius_[blow.other] * e * e * blow.approach), 0.2);
    return impedance_ > 0 ? std::max(hertz, mass / impedance_) : hertz;
}

}  // namespace plait
