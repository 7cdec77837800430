// A whole set of constraints, as the solver sees it: "stretch of the flag". The solver knows order
// and importance of a set and nothing of its inside (Stam 2009, section 6); a set of the user's own
// derives from this as well.
#pragma once

#include "kernels/kernels.h"
#include "kernels/workers.h"
#include "state.h"
#include "terms.h"

#include <span>
#include <string>

namespace plait {

// How one evaluation runs.
enum class Direction { forward, backward };

// Where in time a substep lies; targets move linearly within a base step, which is a frame or a
// part of it (M 2.4; SolverOptions::baseSteps).
struct Substep {
    double h;                   // s
    double frameFraction;       // part of the base step that is over at its end, 0 to 1
    Vec<double> fall{0, 0, 0};  // m: how far Force::fall() takes all that is not pinned in it
    bool parts = true;          // contacts part what begins too near in it
};

template <class Real>
class Constraint {
public:
    virtual ~Constraint() = default;

    // What it keeps past a substep, as a run begins.
    virtual void furnish(Drawer<Real>&) const {}
    // A base step begins, from time t0 to t1 (s): what moves finds out from where to where.
    virtual void beginFrame(double /*t0*/, double /*t1*/) {}
    // A substep begins: multipliers to zero, moving targets to where they are at its end.
    virtual void begin(const Substep&, Workers&) {}

    // Every constraint of the set once; backward is exactly the reverse of forward. Corrections go
    // to the d of sweep.particles.
    virtual void project(const Sweep<Real>&, Direction, Workers&) = 0;
    // Corrections are summed into sweep.out instead. Sets that cannot smooth do nothing.
    virtual void smooth(const Sweep<Real>&, Workers&) {}
    // Takes the part sweep.strength off the rate of C, in the velocities sweep.out.
    virtual void damp(const Sweep<Real>&, Workers&) {}

    // For smoothing: adds the constraints at each vertex; then learns the sums over all sets.
    virtual void countAt(std::vector<int>& /*counts*/) const {}
    virtual void relaxBy(const std::vector<int>& /*counts*/) {}

    // What rides on vertices of this set, as a director does on its edge, goes along where contacts
    // move those: noteRides before they do, carryRides after.
    virtual void noteRides(const Sweep<Real>&) {}
    virtual void carryRides(const Sweep<Real>&) {}

    // The last word on positions, after all sweeps, in a world with contacts: in turns, contacts
    // last. Returns the counted work, 0 where nothing was moved.
    virtual long finish(const Sweep<Real>&, Workers&) { return 0; }
    // A substep of h seconds is over, at time t: what the set keeps follows from where all has come
    // to, and velocities and masses from that.
    virtual void settle(State<Real>&, Drawer<Real>&, double /*t*/, double /*h*/) {}
    // Marks the vertices that a one-sided constraint pushed in this substep.
    virtual void markTouched(std::vector<std::uint8_t>& /*touched*/) const {}

    // The set at the positions of `state`, with second derivatives where `curved`: what methods
    // other than sweeps are made of. Of the rows of the last begin(). False: it has no such form.
    bool terms(const State<Real>& state, bool curved, Terms<Real>& out) const {
        return termsOf({}, state, curved, out);
    }
    // Only the constraints at these places of the set; all of them where `which` is empty.
    virtual bool termsOf(std::span<const int> /*which*/, const State<Real>&, bool /*curved*/,
                         Terms<Real>&) const {
        return false;
    }

    // Constraints in the set: the counted work of a sweep.
    virtual long size() const = 0;
};

}  // namespace plait
