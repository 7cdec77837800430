// Step by stiffness on a sheet that swings (validation D5): what every method does where springs
// are too stiff for the step.
#include "map.h"
#include "spring_sheet.h"
#include "watch.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr int side = 16;
constexpr double seconds = 0.5;
constexpr long leastSteps = 256;

// Power iteration is for every stiffness the same: omega^2 grows as k.
double omegaMax(double stiffness) {
    static const double ofOne = SpringSheet(side, 1).omegaMax();
    return ofOne * std::sqrt(stiffness);
}

Outcome swing(SolverOptions options, double stiffness, double h) {
    const SpringSheet sheet(side, stiffness);
    // Springs count where they are forces. Other methods leave stiff ones a little too long and
    // never give back what that would be worth.
    const auto energy = [&](const auto& x, const auto& v) {
        return options.method == Method::symplectic      ? sheet.modifiedEnergy(x, v, h)
               : options.method == Method::explicitEuler ? sheet.energy(x, v)
                                                         : sheet.mechanicalEnergy(x, v);
    };
    options.schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = 1};
    options.timeScale = h;  // a frame of a second is a step
    Solver<double> solver(sheet.world(), options);
    // A load that is let go reaches twice its static strain, and this one swings.
    Judge judge(energy(sheet.world().start, sheet.world().velocity),
                0.1 + 3 * sheet.staticStrain());
    watch(solver, std::max(leastSteps, std::lround(seconds / h)), judge, [&] {
        const auto x = solver.positions();
        return judge.see(energy(x, solver.velocities()), sheet.strain(x));
    });
    return judge.outcome();
}

std::function<Outcome(double, double)> swinging(const SolverOptions& options) {
    return [=](double stiffness, double h) { return swing(options, stiffness, h); };
}

// The energy of a mode grows by 1 + h^2 omega^2 a step, and that of the fastest from a millionth to
// a twentieth of E0 within the time that is looked at.
double explicitLimit(double stiffness) {
    const double omega = omegaMax(stiffness), growth = std::log(0.05 / 1e-6);
    double h = growth / (omega * omega * seconds);
    for (int i = 0; i < 50; ++i) {
        const double steps = std::max(double(leastSteps), seconds / h);
        h = std::sqrt(std::expm1(growth / steps)) / omega;
    }
    return h;
}

double symplecticLimit(double stiffness) { return 2 / omegaMax(stiffness); }

}  // namespace

StabilityMap stepStiffnessMap() {
    return {
        .name = "step-stiffness",
        .title = "Where springs are too stiff for the step",
        .words =
            "A sheet of 16 × 16 vertices, 1 m × 1 m of 0.02 kg/m², hangs from its "
            "upper edge and swings for 0.5 s, at least 256 steps. Every edge is "
            "a spring; one sweep a step where the method sweeps. A strain drifts "
            "beyond 10 % and three times what the weight makes of it at rest. "
            "For symplectic Euler E is the energy that it keeps while stable; "
            "what springs store counts where they are forces. newton, which stops "
            "where it does not converge, then counts as not finite.",
        .note = "16 × 16 sheet of springs that swings for 0.5 s; one sweep a step",
        .theoryWords =
            "symplectic: h = 2 / omega of the fastest mode, by power "
            "iteration; explicit: that mode has grown to 5 % of E0",
        .x = {"stiffness of a spring [N/m]", 1, 1e6},
        .y = {"step [s]", 1.0 / 6400, 1.0 / 24},
        .boundaryAt = {1, 100, 1e4, 1e6},
        .panels = {{"explicit", swinging({.method = Method::explicitEuler}), explicitLimit, true},
                   {"symplectic", swinging({.method = Method::symplectic}), symplecticLimit, true},
                   {"implicit", swinging({.method = Method::implicit})},
                   {"newton", swinging({.method = Method::newton})},
                   {"block", swinging({.method = Method::block})},
                   {"linearised", swinging({.method = Method::linearised})},
                   {"nucleus", swinging({.method = Method::nucleus})},
                   {"xpbd", swinging({})},
                   {"xpbd bdf2", swinging({.integrator = Integrator::bdf2})}}};
}

}  // namespace plait
