// C(x) = det(x0, x1, x2) / 6 - rest: the signed volume of the tetrahedron on a triangle whose top
// is the apex. Summed over a closed surface it is the volume inside, wherever the apex is (Gauss),
// and only then does it push nothing that is not there (sets/sum_set.h).
#pragma once

#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

struct Volume {
    static constexpr int arity = 3;

    template <class T>
    struct Row {
        Vec<T> apex;   // m
        T rest;        // m^3
        T compliance;  // m^3/Pa
    };

    template <class T>
    static Vec<T> origin(const Row<T>& row) {
        return row.apex;
    }

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 3>& x,
                      Stencil<Vec<T>, 3>& gradient) {
        T slope2 = T(0), size2 = T(0);
        for (int a = 0; a < 3; ++a) {
            gradient[a] = T(1.0 / 6) * cross(x[(a + 1) % 3], x[(a + 2) % 3]);
            slope2 = slope2 + dot(gradient[a], gradient[a]);
            size2 = size2 + dot(x[a], x[a]);
        }
        const T c = dot(gradient[0], x[0]) - row.rest;
        // What has all but collapsed would be thrown a hundred times its size: it has no direction.
        const auto lost = c * c > T(1e4) * slope2 * size2;
        for (Vec<T>& g : gradient) g = select(lost, T(0), T(1)) * g;
        return c;
    }

    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }

    static Row<double> rest(const Stencil<Vec<double>, 3>& x) {
        return {{0, 0, 0}, dot(x[0], cross(x[1], x[2])) / 6, 0};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
