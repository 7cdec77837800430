// A gas that skins enclose: how its pressure follows its volume.
#pragma once

#include "../numbers/elementary.h"

namespace plait {

enum class GasLaw {
    isothermal,        // p = n R T / V: slow, or with walls that conduct
    adiabatic,         // p = p1 (V1 / V)^exponent: too fast for heat to go
    constantPressure,  // p = n R T / V1 whatever V: a pump that never tires
};

struct Gas {
    double amount;            // J: n R T as it was at `reference`
    double reference = 1;     // m^3, V1; the isothermal law does not ask for it
    double outside = 101325;  // Pa; 0: a vacuum
    GasLaw law = GasLaw::isothermal;
    double exponent = 1.4;  // of the adiabatic law; dry air's

    // Pa, of the gas less that outside; it is finite for volumes above 0.
    double gauge(double volume) const { return absolute(volume) - outside; }
    // -dp/dV, Pa/m^3, 0 or more.
    double stiffness(double volume) const {
        if (law == GasLaw::constantPressure) return 0;
        return (law == GasLaw::adiabatic ? exponent : 1) * absolute(volume) / volume;
    }
    // J, of gas and surroundings, but for a constant; its derivative by V is -gauge(V).
    double energy(double volume) const {
        switch (law) {
            case GasLaw::isothermal:
                return outside * volume - amount * logarithm(volume);
            case GasLaw::adiabatic:
                return outside * volume + absolute(volume) * volume / (exponent - 1);
            case GasLaw::constantPressure:
                break;
        }
        return -gauge(volume) * volume;
    }

    double absolute(double volume) const {
        switch (law) {
            case GasLaw::isothermal:
                return amount / volume;
            case GasLaw::adiabatic:
                return amount / reference * power(reference / volume, exponent);
            case GasLaw::constantPressure:
                break;
        }
        return amount / reference;
    }
};

}  // namespace plait
