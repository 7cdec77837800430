// What is stretched and what it encloses, solved at once: springs, rubber, and the gases inside.
// Sweeps hand pressure on by a ring of triangles each, and turn what is under stress (A9); an
// evaluation of this set is a step of Newton's method on implicit Euler for all of it.
#pragma once

#include "../constraints/rows.h"
#include "../constraints/stretch.h"
#include "../gas/enclosure.h"
#include "../gas/gas.h"
#include "../world.h"
#include "leak.h"
#include "rubber.h"

#include <functional>
#include <vector>

namespace plait {

struct Membrane {
    struct Rubber {
        std::vector<int> triangles;     // 3 vertices each; at rest as World::rest has them
        std::vector<double> thickness;  // m at rest: one for all, or one a triangle
        Ogden law;
        bool relaxed = false;  // wrinkles in place of being pressed (Ogden::relaxedAt)
    };
    // Gas in a closed surface, which may be parts of several bodies, with caps that are no rubber.
    struct Filling {
        Enclosure enclosure;
        Gas gas;
        std::function<double(double t)> amount{};  // J, n R T at t (s); none: the gas's own
        LeakOptions leak{};                        // from when it opens on, `amount` counts no more
        std::vector<double> riding =
            {};               // kg of gas that leaks, by vertex; holdMembrane() fills it
        bool bursts = false;  // its skin may come apart: from then on it leaves by the openings
    };

    Rows<Stretch> springs;  // compliances above 0
    std::vector<Rubber> rubber;
    std::vector<Filling> gases;
    // J/m^2 of torn section, length times thickness at rest: what lips take before they let go,
    // where rubber comes apart (tearing/); 0: they let go at once.
    double toughness = 0;
    std::function<double(const Vec<double>& rest)> toughnessMap{};  // multiplies it; none: 1
    // Of conjugate gradients in an evaluation, of which a palindrome makes two.
    int iterations = 15;
    double tolerance = 1e-10;  // of the residual, at which they stop
};

// The mass of gas that will leak is added to World::mass. Throws std::invalid_argument, naming the
// set, for vertices that are not there, triangles without area or thickness, springs without
// compliance, gas whose volume is not above 0, and a leak or a burst of a gas that is not
// isothermal or goes into a vacuum.
void holdMembrane(World& world, Membrane membrane, SetOptions options);

}  // namespace plait
