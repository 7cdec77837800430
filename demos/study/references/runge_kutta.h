// The classical Runge-Kutta method of order 4, for motions of points.
#pragma once

#include <plait/numbers/math.h>

#include <vector>

namespace plait {

// Positions (m) and velocities (m/s), or the rates of both.
struct Motions {
    std::vector<Vec<double>> x, v;
};

// `at` + h `k`.
inline Motions ahead(const Motions& at, const Motions& k, double h) {
    Motions next = at;
    for (std::size_t i = 0; i < at.x.size(); ++i) {
        next.x[i] += h * k.x[i];
        next.v[i] += h * k.v[i];
    }
    return next;
}

// Takes `at` on by h seconds; rate(at) are its rates.
template <class Rate>
void rungeKuttaStep(Motions& at, double h, const Rate& rate) {
    const Motions k1 = rate(at), k2 = rate(ahead(at, k1, h / 2)), k3 = rate(ahead(at, k2, h / 2)),
                  k4 = rate(ahead(at, k3, h));
    for (std::size_t i = 0; i < at.x.size(); ++i) {
        at.x[i] += (h / 6) * (k1.x[i] + 2.0 * k2.x[i] + 2.0 * k3.x[i] + k4.x[i]);
        at.v[i] += (h / 6) * (k1.v[i] + 2.0 * k2.v[i] + 2.0 * k3.v[i] + k4.v[i]);
    }
}

}  // namespace plait
