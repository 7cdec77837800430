// One-sided, frictionless contact of a point with a fixed or moving plane, sphere or capsule:
// C(x) = distance to the surface - thickness >= 0. Enough for floors, pegs and poles.
#pragma once

#include "constants.h"

namespace plait {
inline namespace PLAIT_ISA {

// A contact pushes and never pulls.
template <class T>
T contactCompliance(T s) {
    return select(s < T(0), T(0), T(slack));
}

// C = normal . (x0 - point) - thickness.
struct PlaneContact {
    static constexpr int arity = 1;
    static constexpr bool contact = true;  // evaluated last in every column

    template <class T>
    struct Row {
        Vec<T> point;   // m, on the plane
        Vec<T> normal;  // unit, out of the solid
        T thickness;    // m
    };

    template <class T>
    static Vec<T> origin(const Row<T>& row) {
        return row.point;
    }

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 1>& x,
                      Stencil<Vec<T>, 1>& gradient) {
        gradient[0] = row.normal;
        return dot(row.normal, x[0]) - row.thickness;
    }

    template <class T>
    static T compliance(const Row<T>&, T s) {
        return contactCompliance(s);
    }

    static Row<double> rest(const Stencil<Vec<double>, 1>& x) { return {x[0], {0, 1, 0}, 0}; }
};

// C = |x0 - centre| - radius; the radius includes the thickness.
struct SphereContact {
    static constexpr int arity = 1;
    static constexpr bool contact = true;

    template <class T>
    struct Row {
        Vec<T> center;  // m
        T radius;       // m
    };

    template <class T>
    static Vec<T> origin(const Row<T>& row) {
        return row.center;
    }

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 1>& x,
                      Stencil<Vec<T>, 1>& gradient) {
        const T l = length(x[0]);
        gradient[0] = divide(T(1), l) * x[0];
        return l - row.radius;
    }

    template <class T>
    static T compliance(const Row<T>&, T s) {
        return contactCompliance(s);
    }

    static Row<double> rest(const Stencil<Vec<double>, 1>& x) {
        return {x[0] - Vec<double>{0, 1, 0}, 1};
    }
};

// C = distance to the segment from `end` to `end + axis`, minus radius (thickness included).
struct CapsuleContact {
    static constexpr int arity = 1;
    static constexpr bool contact = true;

    template <class T>
    struct Row {
        Vec<T> end;   // m
        Vec<T> axis;  // m
        T radius;     // m
    };

    template <class T>
    static Vec<T> origin(const Row<T>& row) {
        return row.end;
    }

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 1>& x,
                      Stencil<Vec<T>, 1>& gradient) {
        const T t = divide(dot(x[0], row.axis), dot(row.axis, row.axis));
        const T clamped = select(t < T(0), T(0), select(t > T(1), T(1), t));
        const Vec<T> d = x[0] - clamped * row.axis;
        const T l = length(d);
        gradient[0] = divide(T(1), l) * d;
        return l - row.radius;
    }

    template <class T>
    static T compliance(const Row<T>&, T s) {
        return contactCompliance(s);
    }

    static Row<double> rest(const Stencil<Vec<double>, 1>& x) {
        return {x[0] - Vec<double>{1, 1, 0}, {2, 0, 0}, 1};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
