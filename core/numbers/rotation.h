// Proper rotations, kept orthogonal to rounding.
#pragma once

#include "math.h"

namespace plait {

// By its columns: where it sends the axes. x to z are perpendicular, of unit length, right-handed.
struct Rotation {
    Vec<double> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    Vec<double> operator*(const Vec<double>& a) const { return a.x * x + a.y * y + a.z * z; }
    // Of the inverse.
    Vec<double> back(const Vec<double>& a) const { return {dot(x, a), dot(y, a), dot(z, a)}; }
    friend Rotation operator*(const Rotation& a, const Rotation& b) {
        return {a * b.x, a * b.y, a * b.z};
    }
    friend bool operator==(const Rotation&, const Rotation&) = default;
    Rotation inverse() const { return {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}; }
};

// About w, by twice the angle whose tangent is |w| / 2: by |w| to third order, and without a sine
// (Cayley's map).
inline Rotation turnBy(const Vec<double>& w) {
    const Vec<double> u = 0.5 * w;
    const double s = 2 / (1 + dot(u, u));
    const auto turned = [&](const Vec<double>& a) {
        const Vec<double> across = cross(u, a);
        return a + s * (across + cross(u, across));
    };
    return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

// With x along a, and z across a and b; the axes where these do not span a plane.
inline Rotation frameOf(const Vec<double>& a, const Vec<double>& b) {
    const Vec<double> normal = cross(a, b);
    const double l = length(a), n = length(normal);
    if (!(l > 1e-30 && n > 1e-30)) return {};
    const Vec<double> x = (1 / l) * a, z = (1 / n) * normal;
    return {x, cross(z, x), z};
}

// The same rotation after many products, whose rounding has taken it off by little.
inline Rotation straightened(const Rotation& a) { return frameOf(a.x, a.y); }

}  // namespace plait
