#include "lips.h"

#include <algorithm>

namespace plait {

double Lips::forceAt(double opening) const {
    const double part = opening / reach();
    return part >= 1 ? 0 : force * (part < stiff ? part / stiff * (1 - stiff) : 1 - part);
}

double Lips::energyAt(double opening) const {
    const double r = reach(), s = std::min(opening, r), soft = stiff * r;
    if (s < soft) return 0.5 * forceAt(s) * s;
    return 0.5 * (forceAt(soft) * soft + (forceAt(soft) + forceAt(s)) * (s - soft));
}

double Lips::energy(const Vec<double>& d) const {
    if (force < 0) return 0;
    const double l = length(d), turn = std::max(opened, stiff * reach());
    if (l >= turn) return energyAt(l) - energyAt(turn) + 0.5 * forceAt(turn) * turn;
    return 0.5 * forceAt(turn) / turn * l * l;
}

Vec<double> Lips::pull(const Vec<double>& d, Block& block) const {
    block = {};
    if (force < 0) return {0, 0, 0};
    const double l = length(d), turn = std::max(opened, stiff * reach());
    const double stiffness = l < turn ? forceAt(turn) / turn : forceAt(l) / l;
    const Vec<double> u = divide(1.0, l) * d;
    block.column[0].x = block.column[1].y = block.column[2].z = stiffness;
    // What gives way has no stiffness along, so that a step of Newton goes downhill.
    if (l >= turn) block.addOuter(-stiffness, u, u);
    return stiffness * d;
}

double Lips::taken() const {
    if (force < 0) return 0;
    const double turn = std::max(opened, stiff * reach());
    return energyAt(turn) - 0.5 * forceAt(turn) * turn;
}

}  // namespace plait
