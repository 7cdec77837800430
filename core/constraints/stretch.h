// C(x) = |x1 - x0| - rest: two points keep their distance (Stam 2009, section 5, type 1).
#pragma once

#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Stretch {
    static constexpr int arity = 2;

    template <class T>
    struct Row {
        T rest;         // m
        T compliance;   // m/N, in extension
        T compression;  // m/N, in compression; `slack` for a link that buckles [DC8]
    };

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 2>& x,
                      Stencil<Vec<T>, 2>& gradient) {
        const Vec<T> d = x[1] - x[0];
        const T l = length(d);
        gradient[1] = divide(T(1), l) * d;
        gradient[0] = -gradient[1];
        return l - row.rest;
    }

    template <class T>
    static T compliance(const Row<T>& row, T s) {
        return select(s > T(0), row.compliance, row.compression);
    }

    static Row<double> rest(const Stencil<Vec<double>, 2>& x) {
        return {length(x[1] - x[0]), 0, 0};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
