// C(x) = dihedral angle - rest over the edge x0 x1, with x2 to its left and x3 to its right
// (Stam 2009, section 5, type 3; gradient after Bridson et al. 2003, section 4).
//
// Signed, from atan2 of sine and cosine instead of the paper's acos: flat is 0, either fold is
// finite up to pi, and the difference is taken the short way round [DC6, X2].
#pragma once

#include "../numbers/arctangent.h"
#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Bend {
    static constexpr int arity = 4;

    template <class T>
    struct Row {
        T rest;        // rad, in (-pi, pi]
        T compliance;  // rad/(N m)
    };

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 4>& x,
                      Stencil<Vec<T>, 4>& gradient) {
        const Vec<T> e = x[1] - x[0];
        const Vec<T> left = cross(e, x[2] - x[0]), right = cross(x[3] - x[0], e);
        const T l = length(e), inverse = divide(T(1), dot(e, e));
        gradient[2] = -divide(l, dot(left, left)) * left;
        gradient[3] = -divide(l, dot(right, right)) * right;
        gradient[0] = (inverse * dot(x[2] - x[1], e)) * gradient[2] +
                      (inverse * dot(x[3] - x[1], e)) * gradient[3];
        gradient[1] = -(gradient[0] + gradient[2] + gradient[3]);
        const T sine = divide(dot(cross(left, right), e), l);
        const T c = arctangent2(sine, dot(left, right)) - row.rest;
        const T wrapped = select(c > T(pi), c - T(2 * pi), c);
        return select(wrapped < T(-pi), wrapped + T(2 * pi), wrapped);
    }

    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }

    static Row<double> rest(const Stencil<Vec<double>, 4>& x) {
        Stencil<Vec<double>, 4> unused;
        return {evaluate(Row<double>{}, x, unused), 0};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
