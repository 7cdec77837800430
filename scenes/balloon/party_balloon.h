// A balloon as it comes out of the bag: a ball of rubber with a neck.
#pragma once

#include <plait/gas/enclosure.h>
#include <plait/membranes/membrane.h>
#include <plait/world.h>

namespace plait {

struct PartyBalloon {
    double radius = 0.045;     // m, of the ball
    double wall = 0.25e-3;     // m
    double neck = 0.009;       // m, its radius
    double neckLength = 0.03;  // m
    double density = 920;      // kg/m^3
    Ogden rubber = treloarRubber();

    // Pa above the air's, of a sphere of this ball's volume, stretched so many times.
    double pressure(double stretch) const;
};

// A ball at rest with its neck up and closed, the end of that at `top`, and spare vertices behind
// it.
Range addBalloon(World& world, const PartyBalloon& balloon, int subdivisions,
                 const Vec<double>& top, int spare = 0);

// The same with its neck open, the middle of the rim at `mouth`, its way out along `out` (unit).
struct OpenBalloon {
    Range skin;
    std::vector<double> depths;  // m, of each vertex below the rim, along the axis
};
OpenBalloon addOpenBalloon(World& world, const PartyBalloon& balloon, int subdivisions,
                           const Vec<double>& mouth, const Vec<double>& out);

// All that encloses the gas, of the balloon's rubber, its wall `wall` (m) thick.
Membrane::Rubber rubberOf(const Enclosure& enclosure, const PartyBalloon& balloon, double wall);

// J: n R T of the gas in it, stretched so many times, where `rest` is its volume (m^3) at rest.
double amountFor(const PartyBalloon& balloon, double rest, double stretch);

}  // namespace plait
