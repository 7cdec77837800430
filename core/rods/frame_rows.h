// Rods with a material frame: a director vertex g beside each edge, at a distance from its middle
// and across it, so that the state stays positions only (Umetani, Schmidt and Stam, "Position-based
// elastic rods", 2014; there a ghost point). Two rows hold a director, three values bend and twist
// a joint.
#pragma once

#include "../constraints/constants.h"

namespace plait {
inline namespace PLAIT_ISA {

// C = (g - m) . t: m the middle of the edge x0 x1, t its direction, g = x2.
struct DirectorAcross {
    static constexpr int arity = 3;

    template <class T>
    struct Row {
        T compliance;  // m/N
    };

    template <class T>
    static T evaluate(const Row<T>&, const Stencil<Vec<T>, 3>& x, Stencil<Vec<T>, 3>& gradient) {
        const Vec<T> edge = x[1] - x[0], arm = x[2] - T(0.5) * (x[0] + x[1]);
        const T inverse = divide(T(1), length(edge));
        const Vec<T> t = inverse * edge;
        const T c = dot(arm, t);
        const Vec<T> turn = inverse * (arm - c * t);
        gradient[2] = t;
        gradient[1] = turn - T(0.5) * t;
        gradient[0] = -(gradient[1] + gradient[2]);
        return c;
    }
    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }
    static Row<double> rest(const Stencil<Vec<double>, 3>&) { return {0}; }
};

// C = |g - m| - rest.
struct DirectorLength {
    static constexpr int arity = 3;

    template <class T>
    struct Row {
        T rest;        // m
        T compliance;  // m/N
    };

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 3>& x,
                      Stencil<Vec<T>, 3>& gradient) {
        const Vec<T> arm = x[2] - T(0.5) * (x[0] + x[1]);
        const T l = length(arm);
        gradient[2] = divide(T(1), l) * arm;
        gradient[0] = gradient[1] = T(-0.5) * gradient[2];
        return l - row.rest;
    }
    template <class T>
    static T compliance(const Row<T>& row, T) {
        return row.compliance;
    }
    static Row<double> rest(const Stencil<Vec<double>, 3>& x) {
        return {length(x[2] - 0.5 * (x[0] + x[1])), 0};
    }
};

// The rotation from the frame of the edge x0 x1 with director x3 to that of x1 x2 with x4, less
// that at rest: C = 2 tan(theta / 2) n - rest, theta and the axis n of the rotation in the axes d
// (the director), b = t x d and t of either frame, which see it alike.
struct FrameTurn {
    static constexpr int arity = 5, values = 3;

    template <class T>
    struct Row {
        Vec<T> rest;        // rad, about d, b and t
        Vec<T> compliance;  // rad/(N m): l / EI for bending about d and b, l / GJ for twist
    };

    template <class T>
    using Values = Stencil<T, values>;
    template <class T>
    using Gradients = Stencil<Stencil<Vec<T>, arity>, values>;

    template <class T>
    struct Frame {
        Vec<T> d, b, t;
        T inverseLength, inverseArm;
        T lean;  // how far the arm leans along the edge, of the part of it that is across
    };

    // Of the arm the part across the edge counts.
    template <class T>
    static Frame<T> frameOf(const Vec<T>& from, const Vec<T>& to, const Vec<T>& director) {
        const Vec<T> edge = to - from;
        const T inverseLength = divide(T(1), length(edge));
        const Vec<T> t = inverseLength * edge, arm = director - T(0.5) * (from + to);
        const T along = dot(arm, t);
        const Vec<T> across = arm - along * t;
        const T inverseArm = divide(T(1), length(across));
        const Vec<T> d = inverseArm * across;
        return {d, cross(t, d), t, inverseLength, inverseArm, along * inverseArm};
    }

    template <class T>
    static Vec<T> turnOf(const Frame<T>& f, const Frame<T>& g) {
        const T s = divide(T(2), T(1) + dot(f.d, g.d) + dot(f.b, g.b) + dot(f.t, g.t));
        return {s * (dot(f.t, g.b) - dot(f.b, g.t)), s * (dot(f.d, g.t) - dot(f.t, g.d)),
                s * (dot(f.b, g.d) - dot(f.d, g.b))};
    }

    template <class T>
    static Values<T> evaluate(const Row<T>& row, const Stencil<Vec<T>, arity>& x,
                              const Stencil<Vec<T>, arity>&, Gradients<T>& gradient) {
        const Frame<T> f = frameOf(x[0], x[1], x[3]), g = frameOf(x[1], x[2], x[4]);
        const Vec<T> c = turnOf(f, g), half = T(0.5) * c;
        // d turn = (I + [turn / 2] + turn turn^T / 4) times the rotation of the second frame less
        // that of the first, in the axes of the first.
        const Vec<T> rows[values]{
            {T(1) + half.x * half.x, half.z + half.x * half.y, half.x * half.z - half.y},
            {half.y * half.x - half.z, T(1) + half.y * half.y, half.x + half.y * half.z},
            {half.y + half.z * half.x, half.z * half.y - half.x, T(1) + half.z * half.z}};
        for (int k = 0; k < values; ++k) {
            const Vec<T> axis = rows[k].x * f.d + rows[k].y * f.b + rows[k].z * f.t;
            // An edge turns its frame, and where the arm leans, spins it.
            const Vec<T> first =
                             f.inverseLength * (cross(axis, f.t) - (dot(axis, f.t) * f.lean) * f.b),
                         second =
                             g.inverseLength * (cross(axis, g.t) - (dot(axis, g.t) * g.lean) * g.b);
            const Vec<T> firstArm = (dot(axis, f.t) * f.inverseArm) * f.b,
                         secondArm = (dot(axis, g.t) * g.inverseArm) * g.b;
            gradient[k][0] = first + T(0.5) * firstArm;
            gradient[k][1] = T(0.5) * (firstArm - secondArm) - first - second;
            gradient[k][2] = second - T(0.5) * secondArm;
            gradient[k][3] = -firstArm;
            gradient[k][4] = secondArm;
        }
        return {c.x - row.rest.x, c.y - row.rest.y, c.z - row.rest.z};
    }

    template <class T>
    static Values<T> compliance(const Row<T>& row) {
        return {row.compliance.x, row.compliance.y, row.compliance.z};
    }

    static Row<double> rest(const Stencil<Vec<double>, arity>& x) {
        return {turnOf(frameOf(x[0], x[1], x[3]), frameOf(x[1], x[2], x[4])), {}};
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
