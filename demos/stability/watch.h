// What the maps' runs have in common: gravity, its energy, and a judge at every frame.
#pragma once

#include "demos/tools/interrupt.h"
#include "outcome.h"

#include <plait/measure/energy.h>
#include <plait/solver.h>

namespace plait {

inline constexpr Vec<double> gravity{0, -9.81, 0};  // m/s^2

// Of motion and gravity, J, zero at rest at height 0.
inline double mechanicalEnergy(const World& world, const Solver<double>& solver) {
    return kineticEnergy(world.mass, solver.velocities()) +
           gravitationalEnergy(world.mass, solver.positions(), gravity);
}

// `see` shows the judge the state after each frame, for as long as it returns true.
template <class See>
void watch(Solver<double>& solver, long frames, Judge& judge, const See& see) {
    try {
        for (long frame = 0; frame < frames; ++frame) {
            stopIfInterrupted();
            solver.frame();
            if (!see()) return;
        }
    } catch (const Diverged&) {
        judge.seeNotFinite();
    }
}

}  // namespace plait
