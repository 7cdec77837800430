// What rubber has to say about being stretched in its plane. Incompressible: a sheet that is longer
// by s and wider by t is thinner by 1 / s t.
#pragma once

#include <vector>

namespace plait {

// Energy by its principal stretches a and b, in J a m^3 of rubber at rest, and its derivatives.
struct PrincipalEnergy {
    double value, a, b, aa, bb, ab;
};

// W = sum of mu / alpha (a^alpha + b^alpha + (a b)^-alpha - 3) (Ogden, "Large deformation isotropic
// elasticity", 1972). Its shear modulus is half the sum of mu alpha.
struct Ogden {
    struct Term {
        double modulus;   // Pa, mu; of the sign of alpha where the term holds by itself
        double exponent;  // alpha, not 0
    };
    std::vector<Term> terms;

    // Stretches are taken as at least `least`: below, energies of a triangle without area would not
    // be finite.
    static constexpr double least = 1e-3;

    PrincipalEnergy at(double a, double b) const;
    // Of a sheet that wrinkles in place of being pressed (tension field; Pipkin, "The relaxed
    // energy density for isotropic elastic membranes", 1986): narrower than a strip under `a` alone
    // would be it costs no more, shorter than at rest nothing at all. a >= b.
    PrincipalEnergy relaxedAt(double a, double b) const;
};

// Treloar's rubber, by Ogden (1972): 0.63 MPa 1.3, 1.2 kPa 5, -10 kPa -2.
Ogden treloarRubber();
Ogden neoHookean(double shearModulus);  // Pa
// Of the modulus of a^2, `alpha` times it of a^-2: c1 = modulus / 2, c2 = alpha c1.
Ogden mooneyRivlin(double modulus, double alpha);

}  // namespace plait
