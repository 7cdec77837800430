#include "relax.h"

#include "solver.h"

#include <algorithm>

namespace plait {
namespace {

// The same world with its pins held where they are at time 0.
World still(World world) {
    for (World::Pins& pins : world.pins)
        if (pins.animation)
            pins.animation = [animation = pins.animation](double, std::span<Vec<double>> x) {
                animation(0, x);
            };
    return world;
}

double topSpeed(const Solver<double>& solver) {
    double most = 0;
    for (const Vec<double>& v : solver.velocities()) most = std::max(most, length(v));
    return most;
}

}  // namespace

Relaxed relax(World& world, SolverOptions options, const RelaxOptions& relaxation) {
    if (!(relaxation.speed > 0)) throw std::invalid_argument("relax: speed must be positive");
    if (relaxation.frames < 1) throw std::invalid_argument("relax: there must be a frame");
    options.damping = std::max(options.damping, relaxation.damping);
    // At 1 nothing has a velocity, and all seems at rest.
    if (!(relaxation.damping >= 0 && options.damping < 1))
        throw std::invalid_argument("relax: damping must be in [0, 1)");
    Solver<double> solver(still(world), options);

    Relaxed relaxed{0, 0};
    // One frame alone may have met the turning point of a swing.
    for (int quiet = 0; quiet < 2 && relaxed.frames < relaxation.frames; ++relaxed.frames) {
        solver.frame();
        relaxed.speed = topSpeed(solver);
        quiet = relaxed.speed <= relaxation.speed ? quiet + 1 : 0;
    }
    const std::vector<Vec<double>> pose = solver.positions();
    for (std::size_t i = 0; i < pose.size(); ++i) {
        if (world.pinned[i]) continue;
        world.start[i] = pose[i];
        world.velocity[i] = {};
    }
    return relaxed;
}

}  // namespace plait
