#include "nearest.h"

#include <algorithm>

namespace plait {
namespace {

using Points = std::array<Vec<double>, 4>;

Nearest between(const std::array<double, 4>& weight, const Points& x) {
    Vec<double> apart{};
    for (std::size_t i = 0; i < 4; ++i) apart += weight[i] * x[i];
    return {weight, apart};
}

// Part of the way from a to b where it is nearest to p.
double along(const Vec<double>& p, const Vec<double>& a, const Vec<double>& b) {
    const Vec<double> e = b - a;
    return std::clamp(divide(dot(p - a, e), dot(e, e)), 0.0, 1.0);
}

Nearest pointEdge(const Points& x) {
    const double t = along(x[0], x[1], x[2]);
    return between({1, t - 1, -t, 0}, x);
}

// Lumelsky's cases, as in Ericson, Real-Time Collision Detection, 5.1.9.
Nearest edgeEdge(const Points& x) {
    const Vec<double> u = x[1] - x[0], v = x[3] - x[2], r = x[0] - x[2];
    const double a = dot(u, u), e = dot(v, v), b = dot(u, v), c = dot(u, r), f = dot(v, r);
    const double s = std::clamp(divide(b * f - c * e, a * e - b * b), 0.0, 1.0);
    const double t = std::clamp(divide(b * s + f, e), 0.0, 1.0);
    const double back = along(x[2] + t * v, x[0], x[1]);
    return between({1 - back, back, t - 1, -t}, x);
}

Nearest pointTriangle(const Points& x) {
    const Vec<double> u = x[2] - x[1], v = x[3] - x[1], n = cross(u, v);
    std::array<double, 4> weight{1, 0, 0, 0};
    // Below, the plane is made of rounding, and sides are as near as makes no difference.
    bool inside = dot(n, n) > 1e-16 * dot(u, u) * dot(v, v) && dot(n, n) > 1e-30;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<double>&a = x[1 + (i + 1) % 3], &b = x[1 + (i + 2) % 3];
        const double area = dot(cross(b - a, x[0] - a), n);
        inside = inside && area >= 0;
        weight[1 + i] = -divide(area, dot(n, n));
    }
    if (inside) return between(weight, x);
    Nearest best;
    double least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = 1 + i, b = 1 + (i + 1) % 3;
        const double t = along(x[0], x[a], x[b]);
        std::array<double, 4> edge{1, 0, 0, 0};
        edge[a] = t - 1;
        edge[b] = -t;
        const Nearest found = between(edge, x);
        const double square = dot(found.apart, found.apart);
        if (i > 0 && !(square < least)) continue;
        least = square;
        best = found;
    }
    return best;
}

}  // namespace

Nearest nearest(const Pairing& pair, const Points& x) {
    if (pair.first == 2) return edgeEdge(x);
    if (pair.second == 3) return pointTriangle(x);
    if (pair.second == 2) return pointEdge(x);
    return between({1, -1, 0, 0}, x);
}

}  // namespace plait
