// How hard a blow is, by what it stops.
#pragma once

#include "../contact_constraint.h"
#include "../world.h"
#include "welds.h"

#include <span>
#include <vector>

namespace plait {

// All that one piece presses a cluster with.
struct Blow {
    int other;              // piece
    Vec<double> impulse{};  // N s
    double approach = 0;    // m/s

    double energy() const;  // J, of the approach that it stops
};

class Blows {
public:
    Blows(const World& world, const WeldMatter& matter);

    // Those among the loads on a cluster whose approach is faster than gravity gives in two
    // substeps of h (s), as bounces have it; by the other piece.
    std::vector<Blow> among(std::span<const Load> loads, double h) const;
    // How long it presses, s: Hertz's time, or longer where a plate gives way.
    double timeOf(const Blow& blow) const;

private:
    WeldMatter matter_;
    double gravity_;              // m/s^2
    double impedance_ = 0;        // N s/m of a plate struck at a point; 0: not a plate
    std::vector<double> radius_;  // m, by piece, of its farthest corner
};

}  // namespace plait
