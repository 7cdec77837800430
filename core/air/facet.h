// What the air does to one facet: the formulas of air.h, for every number type a kernel runs in.
// As in constraints/constants.h: no branches on data, no library, no bare division.
#pragma once

#include "../numbers/math.h"

namespace plait {
inline namespace PLAIT_ISA {

// A facet as it meets the air. Impulses and forces are per rest area.
template <class T>
struct Facet {
    Vec<T> normal;  // unit, or 0
    Vec<T> wind;    // u, m/s: of the air, seen from the facet
    T stretch;      // area over rest area; 1 in `legacy`
    T w;            // by how much an impulse changes the velocity of the facet's share of its
                    // vertices, m^2/kg
};

// The coefficients of a substep: force per area and speed, or speed squared, times its length.
template <class T>
struct AirForces {
    T drag, tangential, lift;
};

// `along` the normal, and `across` times ut.
template <class T>
struct Lift {
    T along, across;
};

// The impulse c L. On its own lift would keep E = (un^2 + ut^2) / w and make |ut| / un grow at
// a constant rate: by the factor `turn` in a substep, to first order, and `kept` brings E back.
// Differences are written so that nothing cancels. In `legacy`, and where c is negative, turn and
// kept are 1: explicit.
template <class T, bool legacy>
Lift<T> liftOf(const Facet<T>& facet, T un, T ut2, T c) {
    const T one = T(1), un2 = un * un;
    const T rate = divide(c, squareRoot(un2 + ut2));
    if constexpr (legacy) return {rate * ut2 * un, -rate * un2};
    const T energy = un2 * facet.w + ut2 * facet.w;
    const T turn = one + select(c > T(0), rate * energy, T(0));
    const T turned = un2 * facet.w + (turn * ut2) * (turn * facet.w);
    const T kept2 = select(turn > one, divide(energy, turned), one), kept = squareRoot(kept2);
    const T a = one + kept, b = one + turn * kept;
    const T both = divide(rate * (one + turn) * kept2, a * b);
    return {both * b * ut2 * un, -both * a * un2};
}

// The impulses per rest area of both drags, over the speed of each. Backward Euler:
// s' = s - r c s', or s' = s - r c s'^2. Both share one division.
template <class T, bool legacy>
Lift<T> dragOf(const Facet<T>& facet, const AirForces<T>& air, T alongSpeed, T acrossSpeed) {
    const T one = T(1), zero = T(0);
    const T c = air.drag * facet.stretch, d = air.tangential * facet.stretch;
    const T p = facet.w * c, q = facet.w * d;
    const T stiff = select(p > zero, p, zero), slip = select(q > zero, q, zero);
    if constexpr (legacy) {
        const T a = one + stiff, b = one + slip, inverse = divide(one, a * b);
        return {c * (inverse * b), d * (inverse * a)};
    } else {
        const T a = one + squareRoot(one + T(4) * stiff * alongSpeed);
        const T b = one + squareRoot(one + T(4) * slip * acrossSpeed);
        const T inverse = divide(T(2), a * b);
        const T left = inverse * b, slid = inverse * a;  // s' / s
        return {c * alongSpeed * (left * left), d * acrossSpeed * (slid * slid)};
    }
}

// The impulse per rest area.
template <class T, bool legacy>
Vec<T> impulseOn(const Facet<T>& facet, const AirForces<T>& air, bool lifts) {
    const T un = dot(facet.wind, facet.normal);
    const Vec<T> ut = facet.wind - un * facet.normal;
    const T ut2 = dot(ut, ut);
    Lift<T> lift{T(0), T(0)};
    if (lifts) lift = liftOf<T, legacy>(facet, un, ut2, air.lift * facet.stretch);

    const T turned = un - facet.w * lift.along, left = T(1) - facet.w * lift.across;
    T alongSpeed = T(0), acrossSpeed = T(0);  // `legacy` does not ask
    if constexpr (!legacy) {
        alongSpeed = select(turned < T(0), -turned, turned);
        acrossSpeed = select(left < T(0), -left, left) * squareRoot(ut2);
    }
    const Lift<T> drag = dragOf<T, legacy>(facet, air, alongSpeed, acrossSpeed);
    return (lift.along + drag.along * turned) * facet.normal +
           (lift.across + drag.across * left) * ut;
}

}  // namespace PLAIT_ISA
}  // namespace plait
