#include "../constraints/constants.h"
#include "rod.h"

#include <algorithm>

namespace plait {
namespace {

// Second moments of the section: about the director, across it, and of torsion; m^4.
struct Moments {
    double director, side, torsion;
};

Moments momentsOf(const Wire& wire) {
    const double u = wire.along, v = wire.across;
    if (v == 0) {
        const double moment = pi * u * u * u * u / 64;
        return {moment, moment, 2 * moment};
    }
    const double a = std::max(u, v), b = std::min(u, v), thin = b / a;
    const double torsion =
        a * b * b * b * (1.0 / 3 - 0.21 * thin * (1 - thin * thin * thin * thin / 12));
    return {u * v * v * v / 12, v * u * u * u / 12, torsion};
}

}  // namespace

double Wire::area() const { return across == 0 ? pi * along * along / 4 : along * across; }
double Wire::bending() const { return youngs * momentsOf(*this).director; }
double Wire::bendingSide() const { return youngs * momentsOf(*this).side; }
double Wire::twisting() const { return youngs / (2 * (1 + poisson)) * momentsOf(*this).torsion; }
double Wire::gyration() const {
    const Moments moments = momentsOf(*this);
    return squareRoot((moments.director + moments.side) / area());
}

}  // namespace plait
