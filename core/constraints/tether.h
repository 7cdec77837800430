// C(x) = |x0 - anchor| - length <= 0: a point that goes no further from its anchor than an
// inextensible sheet between the two would let it (long-range attachments, Kim, Chentanez, Müller
// 2012). Slack while it is nearer.
#pragma once

#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Tether {
    static constexpr int arity = 1;

    template <class T>
    struct Row {
        Vec<T> anchor;  // m
        T length;       // m
    };

    template <class T>
    static Vec<T> origin(const Row<T>& row) {
        return row.anchor;
    }

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 1>& x,
                      Stencil<Vec<T>, 1>& gradient) {
        const T l = length(x[0]);
        gradient[0] = divide(T(1), l) * x[0];
        return l - row.length;
    }

    template <class T>
    static T compliance(const Row<T>&, T s) {
        return select(s > T(0), T(0), T(slack));
    }

    static Row<double> rest(const Stencil<Vec<double>, 1>& x) {
        return {x[0] - Vec<double>{0, 1, 0}, 1};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
