#include "spring_sheet.h"

#include "watch.h"

#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double density = 0.02, speedBelow = 1, seed = 1e-6;
constexpr int powerIterations = 1000;

}  // namespace

SpringSheet::SpringSheet(int side, double stiffness) : stiffness_(stiffness) {
    const Range all =
        world_.add(grid({.columns = side, .rows = side}, {.origin = {0, 1, 0}, .up = {0, -1, 0}}),
                   {.density = density});
    world_.pin(pointStencils({0, side}));
    world_.act<Gravity>(GravityOptions{.acceleration = gravity});
    const Rows<Stretch> springs =
        restRows<Stretch>(edgeStencils(world_.complex, all), world_.rest, 1 / stiffness);
    for (std::size_t i = 0; i < springs.rows.size(); ++i) {
        edges_.push_back({springs.ids[2 * i], springs.ids[2 * i + 1]});
        rest_.push_back(springs.rows[i].rest);
    }
    world_.constrain(springs, {.name = "springs"});
    const Vectors mode = fastestMode();
    double modeEnergy = 0;
    for (std::size_t i = 0; i < mode.size(); ++i) {
        world_.velocity[i] = {0, 0, speedBelow * (1 - world_.rest[i].y)};
        modeEnergy += world_.mass[i] * dot(mode[i], mode[i]) / 2;
    }
    const double speed = std::sqrt(seed * energy(world_.rest, world_.velocity) / modeEnergy);
    for (std::size_t i = 0; i < mode.size(); ++i) world_.velocity[i] += speed * mode[i];
}

SpringSheet::Vectors SpringSheet::accelerations(const Vectors& u) const {
    Vectors a(u.size(), {0, 0, 0});
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto [i, j] = edges_[e];
        const Vec<double> along = divide(1.0, rest_[e]) * (world_.rest[j] - world_.rest[i]);
        const Vec<double> force = (stiffness_ * dot(along, u[j] - u[i])) * along;
        a[j] += force;
        a[i] -= force;
    }
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = world_.pinned[i] ? Vec<double>{0, 0, 0} : divide(1.0, world_.mass[i]) * a[i];
    return a;
}

SpringSheet::Vectors SpringSheet::fastestMode() {
    Vectors u(world_.rest.size(), {0, 0, 0});
    // Rough, so that it holds some of every mode.
    for (std::size_t i = 0; i < u.size(); ++i)
        if (!world_.pinned[i]) u[i] = {i % 2 ? 1.0 : -0.7, i % 3 ? 0.9 : -1.1, 0};
    double eigenvalue = 0;
    for (int iteration = 0; iteration < powerIterations; ++iteration) {
        Vectors a = accelerations(u);
        double square = 0;
        for (const Vec<double>& v : a) square += dot(v, v);
        eigenvalue = std::sqrt(square);  // u is of length 1
        for (Vec<double>& v : a) v = (1 / eigenvalue) * v;
        u = a;
    }
    omegaMax_ = std::sqrt(eigenvalue);
    return u;
}

double SpringSheet::staticStrain() const {
    double weight = 0;
    for (std::size_t i = 0; i < world_.mass.size(); ++i)
        if (!world_.pinned[i]) weight -= world_.mass[i] * gravity.y;
    const double columns =
        static_cast<double>(std::count(world_.pinned.begin(), world_.pinned.end(), 1));
    return weight / columns / stiffness_ / rest_[0];
}

double SpringSheet::mechanicalEnergy(const Vectors& x, const Vectors& v) const {
    return kineticEnergy(world_.mass, v) + gravitationalEnergy(world_.mass, x, gravity);
}

double SpringSheet::energy(const Vectors& x, const Vectors& v) const {
    const std::vector<double> compliances(rest_.size(), 1 / stiffness_);
    return mechanicalEnergy(x, v) + stretchEnergy(x, edges_, rest_, compliances);
}

double SpringSheet::modifiedEnergy(const Vectors& x, const Vectors& v, double h) const {
    double power = 0;
    for (std::size_t i = 0; i < x.size(); ++i) power += world_.mass[i] * dot(gravity, v[i]);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto [i, j] = edges_[e];
        const Vec<double> d = x[j] - x[i];
        const double l = length(d);
        power -= divide(stiffness_ * (l - rest_[e]), l) * dot(d, v[j] - v[i]);
    }
    return energy(x, v) + h / 2 * power;
}

double SpringSheet::strain(const Vectors& x) const {
    double most = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e)
        most = std::max(most, std::fabs(length(x[edges_[e][1]] - x[edges_[e][0]]) / rest_[e] - 1));
    return most;
}

}  // namespace plait
