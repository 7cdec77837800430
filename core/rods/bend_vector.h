// Bending of a curve that is straight at rest, as a vector: two values at a joint, across the
// tangent there. C = psi u, psi the angle between the edges x1 - x0 and x2 - x1, u the direction in
// which the tangent turns; so C^2 is psi^2, and the energy of a joint B psi^2 / (2 l), exactly that
// of Angle. But Angle, the length of the vector, is a cone where the curve is straight: its
// gradient jumps there, and solved at once with its neighbours it never rests.
#pragma once

#include "../constraints/constants.h"
#include "../numbers/arctangent.h"

namespace plait {
inline namespace PLAIT_ISA {

struct BendVector {
    static constexpr int arity = 3, values = 2;

    template <class T>
    struct Row {
        T compliance;  // rad/(N m), l / B
    };

    template <class T>
    using Values = Stencil<T, values>;
    template <class T>
    using Gradients = Stencil<Stencil<Vec<T>, arity>, values>;

    // `before`: where the vertices were when the substep began, from which the axes come: they stay
    // through it. What is lost as the tangent turns in a substep by delta is 1 - cos(delta).
    template <class T>
    static Values<T> evaluate(const Row<T>&, const Stencil<Vec<T>, 3>& x,
                              const Stencil<Vec<T>, 3>& before, Gradients<T>& gradient) {
        const Vec<T> a = x[1] - x[0], b = x[2] - x[1];
        const T inverseA = divide(T(1), length(a)), inverseB = divide(T(1), length(b));
        const Vec<T> ta = inverseA * a, tb = inverseB * b, turn = tb - ta;
        const T chord = length(turn), sum = length(ta + tb);  // 2 sin(psi/2), 2 cos(psi/2)
        const T psi = T(2) * arctangent2(chord, sum);
        const auto bent = chord > T(1e-12);
        // psi u = f (tb - ta); along u it changes by 1 / cos(psi/2) of what the chord does.
        const T f = select(bent, divide(psi, chord), T(1));
        const T steeper = divide(T(2), sum) - f;
        const Vec<T> u = divide(T(1), chord) * turn;

        Stencil<Vec<T>, values> axis;
        const Vec<T> a0 = before[1] - before[0], b0 = before[2] - before[1];
        axesAcross(divide(T(1), length(a0)) * a0 + divide(T(1), length(b0)) * b0, axis);
        Values<T> c;
        for (int k = 0; k < values; ++k) {
            c[k] = f * dot(axis[k], turn);
            const Vec<T> m = f * axis[k] + (steeper * dot(axis[k], u)) * u;
            gradient[k][0] = inverseA * (m - dot(m, ta) * ta);
            gradient[k][2] = inverseB * (m - dot(m, tb) * tb);
            gradient[k][1] = -(gradient[k][0] + gradient[k][2]);
        }
        return c;
    }

    template <class T>
    static Values<T> compliance(const Row<T>& row) {
        return {row.compliance, row.compliance};
    }

private:
    // Two axes across `along` and each other.
    template <class T>
    static void axesAcross(const Vec<T>& along, Stencil<Vec<T>, values>& axis) {
        const Vec<T> t = divide(T(1), length(along)) * along;
        const T x = t.x * t.x, y = t.y * t.y, z = t.z * t.z;
        const auto flatX = x < y;
        const auto flatZ = z < select(flatX, x, y);
        const Vec<T> pick{select(flatZ, T(0), select(flatX, T(1), T(0))),
                          select(flatZ, T(0), select(flatX, T(0), T(1))),
                          select(flatZ, T(1), T(0))};
        const Vec<T> side = cross(t, pick);
        axis[0] = divide(T(1), length(side)) * side;
        axis[1] = cross(t, axis[0]);
    }
};

}  // namespace PLAIT_ISA
}  // namespace plait
