// Directions, rotations and smooth steps of the ballerina: +, -, *, / and square roots only, so
// that she is the same to the bit wherever she is compiled.
#pragma once

#include <plait/numbers/math.h>

#include <algorithm>

namespace plait::dancer {

using Point = Vec<double>;

inline Point unit(const Point& a) { return (1 / length(a)) * a; }

inline Point mix(const Point& a, const Point& b, double w) { return a + w * (b - a); }

inline Point mirrored(const Point& a) { return {-a.x, a.y, a.z}; }

// From 0 to 1 as x goes from `from` to `to`, with two continuous derivatives.
inline double step(double x, double from, double to) {
    const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return s * s * s * (10 + s * (6 * s - 15));
}

// The lesser of two, rounded where they differ by less than `width`; two continuous derivatives.
inline double smoothMin(double a, double b, double width) {
    const double h = std::max(width - (a > b ? a - b : b - a), 0.0) / width;
    return std::min(a, b) - h * h * h * width / 6;
}

inline double smoothMax(double a, double b, double width) { return -smoothMin(-a, -b, width); }

// A rotation as the images of the axes.
struct Axes {
    Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    friend Point operator*(const Axes& a, const Point& p) {
        return p.x * a.x + p.y * a.y + p.z * a.z;
    }
    friend Axes operator*(const Axes& a, const Axes& b) { return {a * b.x, a * b.y, a * b.z}; }
};

inline Axes transposed(const Axes& a) {
    return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}};
}

// y opposite to `down`, z as near to `front` as can be. `front` is not along `down`.
inline Axes axesOf(const Point& down, const Point& front) {
    const Point y = -unit(down), x = unit(cross(y, front));
    return {x, y, cross(x, y)};
}

// The least rotation that takes unit vector a to b; they are not opposite.
inline Axes swing(const Point& a, const Point& b) {
    const Point v = cross(a, b);
    const double c = dot(a, b), k = 1 / (1 + c);
    return {{k * v.x * v.x + c, k * v.x * v.y + v.z, k * v.x * v.z - v.y},
            {k * v.y * v.x - v.z, k * v.y * v.y + c, k * v.y * v.z + v.x},
            {k * v.z * v.x + v.y, k * v.z * v.y - v.x, k * v.z * v.z + c}};
}

inline Axes mirrored(const Axes& a) { return {-mirrored(a.x), mirrored(a.y), mirrored(a.z)}; }

// Unit quaternions: rotations that can be mixed.
struct Quaternion {
    double w = 1;
    Point v{0, 0, 0};
};

Quaternion quaternion(const Axes& axes);
Axes axesOf(const Quaternion& q);

// Between two rotations less than half a turn apart.
inline Quaternion mix(const Quaternion& a, const Quaternion& b, double w) {
    const double side = a.w * b.w + dot(a.v, b.v) < 0 ? -w : w;
    const Quaternion sum{(1 - w) * a.w + side * b.w, (1 - w) * a.v + side * b.v};
    const double scale = 1 / squareRoot(sum.w * sum.w + dot(sum.v, sum.v));
    return {scale * sum.w, scale * sum.v};
}

// Turned about x, y and z, in this order applied z first. Angles in radians.
Axes turned(double aboutX, double aboutY, double aboutZ);

}  // namespace plait::dancer
