// C(x) = turning angle from x1 - x0 to x2 - x1, minus rest (Stam 2009, section 5, type 2).
//
// With psi the angle at x1 between its two edges this is rest psi - psi, so the same kind is the
// shear of a triangle's corner and the bend of a curve. atan2 stands for the paper's acos, whose
// derivative is infinite at both ends; measured as a turning angle, a straight curve loses no
// digits against pi. Where the edges are in line the plane of the angle is undefined and the
// gradient is zero.
#pragma once

#include "../numbers/arctangent.h"
#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Angle {
    static constexpr int arity = 3;

    template <class T>
    struct Row {
        T rest;        // rad, in [0, pi]
        T compliance;  // rad/(N m)
    };

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 3>& x,
                      Stencil<Vec<T>, 3>& gradient) {
        const Vec<T> a = x[1] - x[0], b = x[2] - x[1];
        const Vec<T> n = cross(a, b);
        const T sine = length(n);
        const Vec<T> axis = divide(T(1), sine) * n;
        gradient[0] = divide(T(1), dot(a, a)) * cross(axis, a);
        gradient[2] = divide(T(1), dot(b, b)) * cross(axis, b);
        gradient[1] = -(gradient[0] + gradient[2]);
        return arctangent2(sine, dot(a, b)) - row.rest;
    }

    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }

    static Row<double> rest(const Stencil<Vec<double>, 3>& x) {
        Stencil<Vec<double>, 3> unused;
        return {evaluate(Row<double>{}, x, unused), 0};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
