#include "heavy_rod.h"

#include <algorithm>
#include <cmath>

namespace plait {

// By Newton's method, from a stiff rod to this one.
std::vector<double> hangingAngles(const std::vector<double>& lengths, double stiffness,
                                  const std::vector<double>& loads) {
    const std::size_t n = lengths.size() - 1;
    std::vector<double> angle(n, 0), diagonal(n), residual(n), hinge(n + 1, 0);
    for (std::size_t k = 0; k < n; ++k) hinge[k] = 2 * stiffness / (lengths[k] + lengths[k + 1]);
    double whole = 0;
    for (const double l : lengths) whole += l;
    for (double part = 1e-3 * stiffness / (loads[0] * whole * whole); part < 1.999; part *= 2) {
        const double scale = std::min(part, 1.0);
        for (int round = 0; round < 200; ++round) {
            for (std::size_t k = 0; k < n; ++k) {
                const double before = k > 0 ? angle[k - 1] : 0,
                             behind = k + 1 < n ? angle[k + 1] : angle[k],
                             moment = scale * loads[k] * lengths[k + 1];
                residual[k] = moment * std::cos(angle[k]) - hinge[k] * (angle[k] - before) +
                              hinge[k + 1] * (behind - angle[k]);
                diagonal[k] = hinge[k] + hinge[k + 1] + std::fabs(moment * std::sin(angle[k]));
            }
            for (std::size_t k = 1; k < n; ++k) {
                const double factor = hinge[k] / diagonal[k - 1];
                diagonal[k] -= factor * hinge[k];
                residual[k] += factor * residual[k - 1];
            }
            double change = 0;
            for (std::size_t k = n; k-- > 0;) {
                if (k + 1 < n) residual[k] += hinge[k + 1] * residual[k + 1];
                residual[k] /= diagonal[k];
                angle[k] += residual[k];
                change = std::max(change, std::fabs(residual[k]));
            }
            if (change < 1e-13) break;
        }
    }
    return angle;
}

// Of length and weight 1.
RodTip heavyRodTip(double gamma, int links, double held) {
    const double l = 1 / (links - held);
    std::vector<double> loads(static_cast<std::size_t>(links) - 1);
    double load = -l / 2;
    for (std::size_t k = loads.size(); k-- > 0;) loads[k] = load += l;
    RodTip tip{(1 - held) * l, 0};
    for (const double a : hangingAngles(std::vector(loads.size() + 1, l), 1 / gamma, loads)) {
        tip.reach += l * std::cos(a);
        tip.drop += l * std::sin(a);
    }
    return tip;
}

}  // namespace plait
