// C(x) = |x0 - target|: a point is held at a target that may move; hard at compliance 0, soft
// above (Vellum's pin) [AT25]. The target carries what float leaves of it in a second number.
#pragma once

#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Attach {
    static constexpr int arity = 1;

    template <class T>
    struct Row {
        Vec<T> target;     // m
        Vec<T> remainder;  // m, target - float(target)
        T compliance;      // m/N
    };

    template <class T>
    static Vec<T> origin(const Row<T>& row) {
        return row.target;
    }

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 1>& x,
                      Stencil<Vec<T>, 1>& gradient) {
        const Vec<T> d = x[0] - row.remainder;
        const T l = length(d);
        gradient[0] = divide(T(1), l) * d;
        return l;
    }

    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }

    // The row in the precision of the run.
    template <class T>
    static Row<T> narrow(const Row<double>& row) {
        const Vec<double> t = row.target;
        const Vec<T> target{T(t.x), T(t.y), T(t.z)};
        const Vec<T> rest{T(t.x - double(target.x)), T(t.y - double(target.y)),
                          T(t.z - double(target.z))};
        return {target, rest, T(row.compliance)};
    }

    static Row<double> rest(const Stencil<Vec<double>, 1>& x) { return {x[0], {0, 0, 0}, 0}; }
};

}  // namespace PLAIT_ISA
}  // namespace plait
