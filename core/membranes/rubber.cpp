#include "rubber.h"

#include "../numbers/elementary.h"

#include <algorithm>

namespace plait {

PrincipalEnergy Ogden::at(double a, double b) const {
    a = std::max(a, least);
    b = std::max(b, least);
    const double logA = logarithm(a), logB = logarithm(b);
    PrincipalEnergy e{};
    for (const Term& term : terms) {
        const double n = term.exponent, p = exponential(n * logA), q = exponential(n * logB),
                     r = 1 / (p * q);
        e.value += term.modulus / n * (p + q + r - 3);
        e.a += term.modulus * (p - r);
        e.b += term.modulus * (q - r);
        e.aa += term.modulus * ((n - 1) * p + (n + 1) * r);
        e.bb += term.modulus * ((n - 1) * q + (n + 1) * r);
        e.ab += term.modulus * n * r;
    }
    e.a /= a;
    e.b /= b;
    e.aa /= a * a;
    e.bb /= b * b;
    e.ab /= a * b;
    return e;
}

PrincipalEnergy Ogden::relaxedAt(double a, double b) const {
    if (a <= 1) return {};
    const double natural = 1 / __builtin_sqrt(a);
    if (b >= natural) return at(a, b);
    // Along a strip the width follows: dW/da = W_a, and its slope has what the width gives way.
    const PrincipalEnergy e = at(a, natural);
    return {e.value, e.a, 0, e.aa - e.ab * e.ab / e.bb, 0, 0};
}

Ogden treloarRubber() { return {{{0.63e6, 1.3}, {1.2e3, 5}, {-1e4, -2}}}; }

Ogden neoHookean(double shearModulus) { return {{{shearModulus, 2}}}; }

Ogden mooneyRivlin(double modulus, double alpha) {
    return {{{modulus, 2}, {-alpha * modulus, -2}}};
}

}  // namespace plait
