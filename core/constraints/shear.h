// C(x) = u.v / (|u||v|), the sine of the shear between a triangle's two material directions, which
// are at right angles in the rest shape (strain-based dynamics, Müller et al. 2014, section 4,
// normalised so that stretch has no part in it).
#pragma once

#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Shear {
    static constexpr int arity = 3;

    // u = uu p + uv q, v = vu p + vv q with p = x1 - x0, q = x2 - x0: the rest shape's inverse.
    template <class T>
    struct Row {
        T uu, uv, vu, vv;  // 1/m
        T compliance;      // 1/(N m)
    };

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 3>& x,
                      Stencil<Vec<T>, 3>& gradient) {
        const Vec<T> p = x[1] - x[0], q = x[2] - x[0];
        const Vec<T> u = row.uu * p + row.uv * q, v = row.vu * p + row.vv * q;
        // Of length 1 at rest; below a millionth of that they have no direction.
        const T lu = length(u), lv = length(v), least = T(1e-6);
        const T inverseU = divide(T(1), select(lu > least, lu, T(0)));
        const T inverseV = divide(T(1), select(lv > least, lv, T(0)));
        const Vec<T> a = inverseU * u, b = inverseV * v;
        const T c = dot(a, b);
        const Vec<T> du = inverseU * (b - c * a), dv = inverseV * (a - c * b);
        gradient[1] = row.uu * du + row.vu * dv;
        gradient[2] = row.uv * du + row.vv * dv;
        gradient[0] = -(gradient[1] + gradient[2]);
        return c;
    }

    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }

    // u runs along the first edge. A triangle without area has no shear: all zero.
    static Row<double> rest(const Stencil<Vec<double>, 3>& x) {
        const Vec<double> p = x[1] - x[0], q = x[2] - x[0];
        const double l = length(p), along = divide(dot(p, q), l);
        const double across = divide(length(cross(p, q)), l);
        return {divide(1.0, l), 0, -divide(along, l * across), divide(1.0, across), 0};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
