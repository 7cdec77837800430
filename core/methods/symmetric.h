// A symmetric 3 x 3 matrix: what a vertex alone has of a Hessian.
#pragma once

#include "../terms.h"

namespace plait {

template <class Real>
struct Symmetric {
    Real xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    static Symmetric diagonal(Real s) { return {s, 0, 0, s, 0, s}; }
    // Second derivatives of constraint n at its vertex a.
    static Symmetric of(const Terms<Real>& terms, int n, int a) {
        const Real* const x = terms.block(n, a, a);
        const Real* const y = x + 3 * terms.arity;
        return {x[0], x[1], x[2], y[1], y[2], y[3 * terms.arity + 2]};
    }

    void add(Real s, const Symmetric& b) {
        xx += s * b.xx, xy += s * b.xy, xz += s * b.xz;
        yy += s * b.yy, yz += s * b.yz, zz += s * b.zz;
    }
    // += s v v^T
    void addOuter(Real s, const Vec<Real>& v) {
        xx += s * v.x * v.x, xy += s * v.x * v.y, xz += s * v.x * v.z;
        yy += s * v.y * v.y, yz += s * v.y * v.z, zz += s * v.z * v.z;
    }

    // Of this x = b, by L D L^T; a direction without stiffness, pivot 0, stays where it is.
    Vec<Real> solve(const Vec<Real>& b) const {
        const Real lx = divide(xy, xx), lz = divide(xz, xx);
        const Real d1 = yy - lx * xy, m = yz - lx * xz, ly = divide(m, d1);
        const Real d2 = zz - lz * xz - ly * m;
        const Real b1 = b.y - lx * b.x, b2 = b.z - lz * b.x - ly * b1;
        const Real z = divide(b2, d2), y = divide(b1, d1) - ly * z;
        return {divide(b.x, xx) - lx * y - lz * z, y, z};
    }
};

}  // namespace plait
