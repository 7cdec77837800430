// A wire wound to a helix, drawn out by a force along its axis.
#pragma once

#include <plait/numbers/math.h>

namespace plait {

struct Helix {
    double pitch;   // rad
    double radius;  // m
};

// N m^2; of bending in the plane of a turn.
struct CoilStiffness {
    double bending, twisting;
};

// What becomes of `rest` under a force (N), sought from `at`: C (sin a cos a / r - t0) =
// F r cos a and B (cos^2 a / r - k0) = -F r sin a (Love, "Mathematical theory of elasticity", on
// helical springs).
Helix hungBy(const Helix& rest, const CoilStiffness& wire, double force, Helix at);

// m, by which so much wire (m) becomes longer that hangs by its end from rest, of this weight
// (N/m).
double sagOf(const Helix& rest, const CoilStiffness& wire, double length, double weight);

}  // namespace plait
