// What a turned wall hides of a particle's kernel: along each ray all that lies beyond where it
// first meets the wall, at rims and in corners as on its sides. Worked out once, on a grid of
// radius and height.
#pragma once

#include "../contacts/solids/profile.h"

#include <vector>

namespace plait {

class TurnedShade {
public:
    // `reach` (m): the kernel's radius.
    TurnedShade(const Profile& profile, double reach);

    struct At {
        double part;                // 0 to 1
        double byRadius, byHeight;  // 1/m: its derivatives
    };
    At at(double radius, double height) const;

private:
    double step_, bottom_;  // m
    int columns_, rows_;
    std::vector<float> parts_;  // by height, then radius, from a step behind the axis on
};

}  // namespace plait
