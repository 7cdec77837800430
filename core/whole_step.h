// A method that is not made of sweeps: between the prediction and the velocity rule it takes all
// sets at once. The rest of the substep (forces, prediction, pins, velocity rule, damping) is the
// solver's, the same for every method.
#pragma once

#include "constraint.h"
#include "solver_options.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace plait {

// What factorisations are counted in: multiplications of a sweep over one link.
inline constexpr double multiplicationsOfALink = 30;

// What a method sees of a substep.
template <class Real>
struct WholeSubstep {
    State<Real>& state;  // x + d: predicted; before: d when the substep began; velocity: after
                         // forces; lastVelocity: before them
    Drawer<Real>& kept;  // the method's
    std::span<const std::unique_ptr<Constraint<Real>>> sets;
    double h;        // s, the substep
    double implied;  // s, what compliance sees: 2 h / 3 under BDF2 once it has a past
    int columns;     // of the schedule in this substep
    Sweeps sweeps;   // what a column does, where a method has such
    Workers& workers;
};

template <class Real>
class WholeStep {
public:
    virtual ~WholeStep() = default;

    // What it keeps past a substep, as a run begins.
    virtual void furnish(Drawer<Real>&) const {}
    // A substep begins: state.velocity is before forces.
    virtual void begin(const State<Real>& /*state*/) {}
    // Leaves d where the substep ends. Returns the counted work, in constraints evaluated.
    virtual long take(WholeSubstep<Real>& substep) = 0;
    // Marks the vertices that an impact reached in this substep: they take velocities of first
    // order, and a past that continues them.
    virtual void markStruck(const State<Real>& /*state*/, const Drawer<Real>& /*kept*/,
                            std::vector<std::uint8_t>& /*struck*/) {}
    // True: it sets velocities as well, in place of (x - x1) / h.
    virtual bool setsVelocities() const { return false; }
};

// A set as such a method is told of it.
template <class Real>
struct NamedSet {
    std::string name;
    bool contact;
    const Constraint<Real>* set;
};

}  // namespace plait
