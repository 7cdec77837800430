#include "heavy_rod.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plait {

// Of length and weight 1. The angles below the horizontal of all links but the first that leave no
// moment at a hinge, by Newton's method, from a stiff rod to this one.
RodTip heavyRodTip(double gamma, int links) {
    const int n = links - 1;
    const double l = 1 / (links - 0.5), b = 1 / (gamma * l);
    std::vector<double> angle(n, 0), load(n), diagonal(n), residual(n);
    double weight = 0;
    for (int k = n - 1; k >= 0; --k) load[k] = weight += k == n - 1 ? l / 2 : l;
    for (double part = 1e-3 / gamma; part < 1.999; part *= 2) {
        const double scale = std::min(part, 1.0);
        for (int round = 0; round < 200; ++round) {
            for (int k = 0; k < n; ++k) {
                const double before = k > 0 ? angle[k - 1] : 0, moment = scale * load[k] * l;
                const bool last = k == n - 1;
                residual[k] = moment * std::cos(angle[k]) - b * (angle[k] - before) +
                              (last ? 0 : b * (angle[k + 1] - angle[k]));
                diagonal[k] = b * (last ? 1 : 2) + std::fabs(moment * std::sin(angle[k]));
            }
            for (int k = 1; k < n; ++k) {
                const double factor = b / diagonal[k - 1];
                diagonal[k] -= factor * b;
                residual[k] += factor * residual[k - 1];
            }
            double change = 0;
            for (int k = n - 1; k >= 0; --k) {
                residual[k] = (residual[k] + (k < n - 1 ? b * residual[k + 1] : 0)) / diagonal[k];
                angle[k] += residual[k];
                change = std::max(change, std::fabs(residual[k]));
            }
            if (change < 1e-13) break;
        }
    }
    RodTip tip{l / 2, 0};
    for (const double a : angle) {
        tip.reach += l * std::cos(a);
        tip.drop += l * std::sin(a);
    }
    return tip;
}

}  // namespace plait
