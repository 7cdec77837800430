// What holds two together that have come apart, until what the tear costs is paid: a cohesive zone
// (Hillerborg et al. 1976). It begins with the force that they bore as one and lets go evenly with
// how far they part; going back it follows a straight line to nothing.
#pragma once

#include "elements.h"

namespace plait {

struct Lips {
    double cost;    // J
    double force;   // N, at first; below 0: not known yet
    double opened;  // m, the furthest so far

    static constexpr double stiff = 0.02;  // part of its reach in which it takes up its force

    double reach() const { return 2 * cost / ((1 - stiff) * force); }  // m, where it lets go
    double forceFor(double reach) const { return 2 * cost / ((1 - stiff) * reach); }
    bool paid() const { return force >= 0 && opened >= reach(); }
    // Of the way `d` from one to the other (m), as Spring has them.
    double energy(const Vec<double>& d) const;
    Vec<double> pull(const Vec<double>& d, Block& block) const;
    // J, that is gone for good.
    double taken() const;

private:
    double forceAt(double opening) const;
    double energyAt(double opening) const;  // on the way there for the first time
};

}  // namespace plait
