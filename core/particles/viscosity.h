// How a liquid resists being sheared: from honey to what hardly flows [FL3-FL6].
//
// A pair of particles that see each other exchanges momentum along the line between them, in
// proportion to how fast they part or approach along it (Weiler, Koschier, Brand, Bender, A
// physically consistent implicit viscosity solver for SPH fluids, 2018): momentum and angular
// momentum are kept to rounding, what turns as one is not braked, and energy is only ever lost.
// A wall is what would be behind it of a liquid whose speed goes on straight to the wall's own: it
// does not slip.
//
// Implicit: (M + h V) v' = M v, by Jacobi's iterations with blocks of 3 x 3 and Chebyshev's
// weights, whose bounds are known beforehand, until no vertex is off by more than a tolerance: no
// sum over all, so that the bits do not depend on threads. It begins with the change of the last
// substep, which in what creeps is that of this one. Where the tolerance is met no h blows up;
// where iterations run out first, see unfinished(), momentum is kept no better than to what is
// left.
#pragma once

#include "../force.h"
#include "../numbers/symmetric.h"
#include "cells.h"
#include "liquid.h"
#include "walls.h"

#include <vector>

namespace plait {

// Factors of what a pair exchanges, and a particle with a wall, for the stress to be a liquid's: 10
// for both where all goes by one gradient (Weiler). Particles of settled water evade each other
// while it is sheared, and slip by walls: these are measured on flows between plates.
inline constexpr double viscousPairs = 12.2, viscousWalls = 30;

struct ViscosityOptions {
    std::string name = "viscosity";
    double viscosity = 0.001;          // Pa s: water 0.001, oil 0.1, honey 10
    std::vector<double> factors = {};  // by particle of the liquid, times it; empty: 1
    double wall = 1;                   // times it at walls; 0: they are slippery
    double tolerance = 1e-4;           // m/s that a vertex may be off
    int mostIterations = 200;
    bool implicit = true;  // false: v' = v - h M^-1 V v, which blows up where h is too long (V)
};

template <class Real>
class Viscosity : public Force<Real> {
public:
    // Throws std::invalid_argument, naming it, as holdDensity does of the liquid, and for numbers
    // below 0 or that are none, a tolerance that is not above 0 and less than one iteration.
    Viscosity(const World& world, const Liquid& liquid, const ViscosityOptions& options);

    std::string name() const override { return options_.name; }
    void furnish(Drawer<Real>& kept) const override;
    void prepare(State<Real>& state, Drawer<Real>& kept, double t, double h,
                 Workers& workers) override;
    void apply(State<Real>&, double, double, Workers&) override {}

    // Of its drawer: of the last substep, and since the run began.
    static int iterations(const Drawer<Real>& kept) { return kept.integers[last]; }
    static int iterationsSoFar(const Drawer<Real>& kept) { return kept.integers[all]; }
    // Substeps that ended at mostIterations, short of the tolerance.
    static int unfinished(const Drawer<Real>& kept) { return kept.integers[tired]; }

private:
    enum { last, all, tired, numbers };

    // What a particle exchanges with another: (u u^T) of the difference of their speeds, N.
    struct Link {
        Vec<Real> u;  // sqrt(kg/s)
        int slot;
    };

    void sort(const State<Real>& state, Drawer<Real>& kept, Workers& workers);
    void findLinks(Workers& workers);
    void findWalls(double t, double h, Workers& workers);
    double findBlocks(double h, Workers& workers);
    void findResidual(double h, Workers& workers);
    int solve(double h, Workers& workers);

    ViscosityOptions options_;
    Range particles_;
    double spacing_, radius_;  // m
    Vec<double> origin_;       // m
    Walls walls_;
    std::vector<double> atWall_;  // by distance, along the wall and across it: drag, kg/s
    std::vector<int> present_;
    Cells<Real> cells_;
    std::vector<int> vertices_, start_;  // by slot; start_: of its links
    std::vector<Link> links_;
    std::vector<Real> mass_, factor_;                              // by slot
    std::vector<Symmetric<Real>> wall_, block_;                    // by slot, kg/s, kg
    std::vector<Vec<Real>> push_;                                  // by slot, N, of walls that move
    std::vector<Vec<Real>> right_, v_, next_, before_, residual_;  // by slot, m/s
    double worst_ = 0;                                             // m/s, of residual_
};

// Adds it to a world.
void actViscosity(World& world, const Liquid& liquid, const ViscosityOptions& options);

}  // namespace plait
