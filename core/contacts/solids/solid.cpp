#include "solid.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

double towards(double a, double sign) { return sign < 0 ? -a : a; }

}  // namespace

Side sideOf(const Solid& solid, const Vec<double>& p) {
    if (solid.halfSpace) return {p.y, {0, 1, 0}};
    const Vec<double> over{std::fabs(p.x) - solid.half.x, std::fabs(p.y) - solid.half.y,
                           std::fabs(p.z) - solid.half.z};
    const Vec<double> out{std::max(over.x, 0.0), std::max(over.y, 0.0), std::max(over.z, 0.0)};
    const double l = length(out);
    if (l > 0) {
        const Vec<double> n = (1 / l) * out;
        return {l - solid.radius, {towards(n.x, p.x), towards(n.y, p.y), towards(n.z, p.z)}};
    }
    const double most = std::max({over.x, over.y, over.z});
    const Vec<double> n = over.x == most   ? Vec<double>{towards(1, p.x), 0, 0}
                          : over.y == most ? Vec<double>{0, towards(1, p.y), 0}
                                           : Vec<double>{0, 0, towards(1, p.z)};
    return {most - solid.radius, n};
}

// The distance from what is convex is convex along a line: Newton's steps, from where it is still
// too large, never go too far. Where the path only grazes they halve what is left.
std::optional<double> reaches(const Solid& solid, const Vec<double>& start, const Vec<double>& end,
                              double gap) {
    constexpr int steps = 64;
    const Vec<double> way = end - start;
    const double rounding = 1e-14 * (length(start) + length(way));
    double t = 0;
    for (int i = 0; i < steps; ++i) {
        const Side at = sideOf(solid, start + t * way);
        const double left = at.distance - gap, nearing = -dot(at.normal, way);
        if (left <= rounding) return t;
        if (!(left <= nearing * (1 - t))) return {};
        t += left / nearing;
    }
    return t;
}

}  // namespace plait
