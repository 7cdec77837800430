#include "math.h"

#include <plait/numbers/elementary.h>

namespace plait::dancer {

Quaternion quaternion(const Axes& a) {
    const double xx = a.x.x, yy = a.y.y, zz = a.z.z;
    // The largest of the four components first, so that no division is by little.
    if (xx + yy + zz > 0) {
        const double s = 2 * squareRoot(1 + xx + yy + zz);
        return {s / 4, (1 / s) * Point{a.y.z - a.z.y, a.z.x - a.x.z, a.x.y - a.y.x}};
    }
    if (xx > yy && xx > zz) {
        const double s = 2 * squareRoot(1 + xx - yy - zz);
        return {(a.y.z - a.z.y) / s, {s / 4, (a.y.x + a.x.y) / s, (a.z.x + a.x.z) / s}};
    }
    if (yy > zz) {
        const double s = 2 * squareRoot(1 + yy - xx - zz);
        return {(a.z.x - a.x.z) / s, {(a.y.x + a.x.y) / s, s / 4, (a.z.y + a.y.z) / s}};
    }
    const double s = 2 * squareRoot(1 + zz - xx - yy);
    return {(a.x.y - a.y.x) / s, {(a.z.x + a.x.z) / s, (a.z.y + a.y.z) / s, s / 4}};
}

Axes axesOf(const Quaternion& q) {
    const auto turn = [&](const Point& p) {
        const Point t = 2 * cross(q.v, p);
        return p + q.w * t + cross(q.v, t);
    };
    return {turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1})};
}

Axes turned(double aboutX, double aboutY, double aboutZ) {
    const double cx = cosine(aboutX), sx = sine(aboutX);
    const double cy = cosine(aboutY), sy = sine(aboutY);
    const double cz = cosine(aboutZ), sz = sine(aboutZ);
    const Axes x{{1, 0, 0}, {0, cx, sx}, {0, -sx, cx}};
    const Axes y{{cy, 0, -sy}, {0, 1, 0}, {sy, 0, cy}};
    const Axes z{{cz, sz, 0}, {-sz, cz, 0}, {0, 0, 1}};
    return x * (y * z);
}

}  // namespace plait::dancer
