// Symmetric 3 x 3 matrices.
#pragma once

#include "math.h"

namespace plait {

template <class T>
struct Symmetric {
    T xx, xy, xz, yy, yz, zz;

    static Symmetric diagonal(T s) { return {s, T(0), T(0), s, T(0), s}; }

    Vec<T> operator*(const Vec<T>& a) const {
        return {xx * a.x + xy * a.y + xz * a.z, xy * a.x + yy * a.y + yz * a.z,
                xz * a.x + yz * a.y + zz * a.z};
    }
    Symmetric& operator+=(const Symmetric& b) {
        xx += b.xx, xy += b.xy, xz += b.xz, yy += b.yy, yz += b.yz, zz += b.zz;
        return *this;
    }
    // += s b
    void add(T s, const Symmetric& b) {
        xx += s * b.xx, xy += s * b.xy, xz += s * b.xz;
        yy += s * b.yy, yz += s * b.yz, zz += s * b.zz;
    }
    // += s u u^T
    void addOuter(T s, const Vec<T>& u) {
        xx = xx + s * u.x * u.x, xy = xy + s * u.x * u.y, xz = xz + s * u.x * u.z;
        yy = yy + s * u.y * u.y, yz = yz + s * u.y * u.z, zz = zz + s * u.z * u.z;
    }

    // Of this x = b, by L D L^T; a direction without stiffness, pivot 0, stays where it is.
    Vec<T> solve(const Vec<T>& b) const {
        const T lx = divide(xy, xx), lz = divide(xz, xx);
        const T d1 = yy - lx * xy, m = yz - lx * xz, ly = divide(m, d1);
        const T d2 = zz - lz * xz - ly * m;
        const T b1 = b.y - lx * b.x, b2 = b.z - lz * b.x - ly * b1;
        const T z = divide(b2, d2), y = divide(b1, d1) - ly * z;
        return {divide(b.x, xx) - lx * y - lz * z, y, z};
    }
};

}  // namespace plait
