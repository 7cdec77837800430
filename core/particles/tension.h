// Surface tension of a liquid: what is missing around a particle costs.
//
// E = sum_i V a (1/2 (1 - c_i)^2 + b/2 R^2 |grad c_i|^2), c a density smoothed over R, twice as far
// as the liquid's own kernel; walls count in it. Inside c is 1, at a flat surface a half, and E is
// known for an area. It depends on c alone: shear costs nothing, as far as c is smooth. Forces
// between pairs (Akinci, Akinci, Teschner, Versatile surface tension and adhesion for SPH fluids,
// 2013) hold drops of ten spacings like jelly. Forces are derivatives of E: momentum, angular
// momentum and energy are kept.
//
// The first term pulls a surface inwards, the second pushes it out (van der Waals; Cahn, Hilliard,
// Free energy of a nonuniform system, 1958). Of the first alone the liquid must bear a pressure
// under its surface whose integral is 3.7 times the tension, and what is pressed is stiff when
// sheared: small swings of a drop are a third faster than large ones, and threads do not break.
#pragma once

#include "../force.h"
#include "cells.h"
#include "liquid.h"
#include "walls.h"

#include <string>
#include <vector>

namespace plait {

struct TensionOptions {
    std::string name = "surface tension";
    double tension = 0.072;  // N/m: water 0.072, oil 0.03, mercury 0.49
    double angle = 90;       // degrees, at which it meets walls: 0 spreads, 180 rolls off (Young)
    // Substeps from one push to the next, which is for them all: it costs as much as twenty
    // evaluations of densities.
    int interval = 1;
};

template <class Real>
class Tension : public Force<Real> {
public:
    // Throws std::invalid_argument, naming it, as holdDensity does of the liquid, for a tension
    // below 0, an angle beyond 0 to 180 degrees and an interval below 1.
    Tension(const World& world, const Liquid& liquid, const TensionOptions& options);

    std::string name() const override { return options_.name; }
    void apply(State<Real>& state, double t, double h, Workers& workers) override;

    // J: of the state that the last push saw.
    double energy() const;

private:
    void sort(const State<Real>& state, Workers& workers);
    void sum(Workers& workers);
    Vec<Real> forceOn(int slot) const;

    TensionOptions options_;
    Range particles_;
    double volume_, radius_, stiffness_;  // m^3, m, Pa
    Vec<double> origin_;                  // m
    Walls walls_;
    double drawn_;  // J: what a particle gains whose whole kernel is in a wall
    std::vector<int> present_;
    Cells<Real> cells_;
    std::vector<Real> lack_;  // by slot: 1 - c
    // By slot, 1/m: the gradients of c as particles make it, and of what walls add to it.
    std::vector<Vec<Real>> slope_, wall_;
};

// Adds it to a world.
void actTension(World& world, const Liquid& liquid, const TensionOptions& options);

}  // namespace plait
