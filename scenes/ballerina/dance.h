// The dance: what every moment asks of the skeleton, with two continuous derivatives.
#pragma once

#include "skeleton.h"

#include <array>
#include <limits>
#include <vector>

namespace plait::dancer {

// Values by time: between keys polynomials of degree 5. Before the first and after the last key
// they stay.
template <std::size_t n>
class Track {
public:
    using Values = std::array<double, n>;

    struct Key {
        double t;  // s
        Values x;
        // Where not told: none where the values turn, else such that they do not overshoot.
        double velocity = std::numeric_limits<double>::infinity();
        double acceleration = 0;
    };

    Track(std::initializer_list<Key> keys) : keys_(keys), velocities_(keys.size()) {
        for (std::size_t i = 0; i < keys_.size(); ++i)
            for (std::size_t k = 0; k < n; ++k) velocities_[i][k] = velocity(i, k);
    }

    Values operator()(double t) const {
        if (t <= keys_.front().t) return keys_.front().x;
        if (t >= keys_.back().t) return keys_.back().x;
        std::size_t i = 0;
        while (t > keys_[i + 1].t) ++i;
        const Key &a = keys_[i], &b = keys_[i + 1];
        const double h = b.t - a.t, s = (t - a.t) / h;
        Values x{};
        for (std::size_t k = 0; k < n; ++k) {
            const double v0 = h * velocities_[i][k], v1 = h * velocities_[i + 1][k];
            const double a0 = h * h * a.acceleration, a1 = h * h * b.acceleration;
            const double d = b.x[k] - a.x[k] - v0 - a0 / 2, dv = v1 - v0 - a0, da = a1 - a0;
            const double c3 = 10 * d - 4 * dv + da / 2, c4 = -15 * d + 7 * dv - da,
                         c5 = 6 * d - 3 * dv + da / 2;
            x[k] = a.x[k] + s * (v0 + s * (a0 / 2 + s * (c3 + s * (c4 + s * c5))));
        }
        return x;
    }

private:
    // Fritsch & Butland 1984.
    double velocity(std::size_t i, std::size_t k) const {
        if (keys_[i].velocity < std::numeric_limits<double>::infinity()) return keys_[i].velocity;
        if (i == 0 || i + 1 == keys_.size()) return 0;
        const double h0 = keys_[i].t - keys_[i - 1].t, h1 = keys_[i + 1].t - keys_[i].t;
        const double d0 = (keys_[i].x[k] - keys_[i - 1].x[k]) / h0;
        const double d1 = (keys_[i + 1].x[k] - keys_[i].x[k]) / h1;
        if (d0 * d1 <= 0) return 0;
        return 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    }

    std::vector<Key> keys_;
    std::vector<Values> velocities_;
};

inline constexpr double danceLength = 14;                  // s
inline constexpr double takeOff = 10.15, landing = 10.65;  // s, of the leap

Controls controls(double t);

}  // namespace plait::dancer
