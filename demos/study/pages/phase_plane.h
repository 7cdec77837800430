// The unit spring x'' = -x in the phase plane, by the methods of Stam 2009, section 4.2, figures 3
// to 6: each against its closed form (validation A0).
#pragma once

#include "render/charts/chart.h"

#include <plait/solver_options.h>

#include <filesystem>
#include <vector>

namespace plait {

struct PhasePoint {
    double x, v;  // m, m/s
};

// Where the spring is after 0, 1 ... `steps` steps of h seconds from (1, 0): by the solver, with
// explicit, implicit or symplectic Euler, which takes the velocity first.
std::vector<PhasePoint> springOrbit(Method method, double h, int steps);
// Symplectic Euler that takes the position first: x + h v, then v - h x.
std::vector<PhasePoint> positionFirstOrbit(double h, int steps);

// The step, s, at which symplectic Euler closes after n steps, n >= 3: 2 sin(pi / n).
double polygonStep(int n);
// (x^2 + v^2 - h x v) / 2, J, which symplectic Euler conserves with the velocity first; with -h in
// place of h, if the position is first.
double modifiedEnergy(PhasePoint z, double h);

// Largest distance, over its radius, from the spiral exp(-i atan h) (1 + h^2)^(sign / 2) a step.
double spiralError(const std::vector<PhasePoint>& orbit, double h, int sign);
// Largest deviation of the modified energy from that of the first point, J.
double energyDrift(const std::vector<PhasePoint>& orbit, double h);

inline constexpr const char* phasePlaneTitle = "One spring, x″ = −x: what a time step does";

// Three spirals, n-gons, and the ellipses of h = 1/2: a slide.
Figure phasePlaneFigure();
// Leaves chart.svg, chart.png and index.html, with every figure beside its closed form. Throws
// FileError or std::runtime_error, "file: cause".
void writePhasePlane(const std::filesystem::path& folder, bool quiet);

}  // namespace plait
