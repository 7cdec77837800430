#include "solid.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

double towards(double a, double sign) { return sign < 0 ? -a : a; }

Side sideOfTurned(const Profile& profile, const Vec<double>& p) {
    const double r = squareRoot(p.x * p.x + p.z * p.z);
    const Profile::Nearest at = profile.nearest(r, p.y);
    const double x = r > 0 ? p.x / r : 1, z = r > 0 ? p.z / r : 0;
    return {at.distance, {at.normal[0] * x, at.normal[1], at.normal[0] * z}};
}

// Nothing is nearer than the distance, however a solid bends.
std::optional<double> reachesTurned(const Profile& profile, const Vec<double>& start,
                                    const Vec<double>& end, double gap) {
    constexpr int steps = 256;
    const double way = length(end - start), rounding = 1e-9 * way + 1e-14 * length(start);
    double t = 0;
    for (int i = 0; i < steps; ++i) {
        const double left = sideOfTurned(profile, start + t * (end - start)).distance - gap;
        if (left <= rounding) return t;
        t += divide(left, way);
        if (t > 1 || way == 0) return {};
    }
    return t;
}

}  // namespace

Side sideOf(const Solid& solid, const Vec<double>& p) {
    if (solid.halfSpace) return {p.y, {0, 1, 0}};
    if (solid.profile) return sideOfTurned(*solid.profile, p);
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
    if (solid.profile) return reachesTurned(*solid.profile, start, end, gap);
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
