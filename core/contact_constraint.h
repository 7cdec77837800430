// A set of one-sided constraints that have the last word on where things are: contacts. What the
// solver asks of them beyond what it asks of every set.
#pragma once

#include "constraint.h"

namespace plait {

// What pushed a piece (World::pieces) at a point, in one substep.
struct Load {
    int piece;
    Vec<double> at;       // m
    Vec<double> impulse;  // kg m: force times h^2
    Vec<double> whole;    // kg m, that takes all of the approach: who touches late in a substep is
                          // stopped for good in the next
    double approach;      // m/s, at which the other came before it was held
    int other;            // the piece that pushed
};

template <class Real>
class ContactConstraint : public Constraint<Real> {
public:
    // True: it asks where things were a substep earlier (State::last).
    virtual bool needsPast() const { return false; }

    // How long it takes to part what is too near where the vertices are (s); 0: nothing is;
    // infinity: it is not to be parted.
    virtual double partingTime(const Sweep<Real>&, Workers&) { return 0; }
    // Before the columns, where everything has been predicted: impacts that bounce.
    virtual void strike(const Sweep<Real>&, const State<Real>&, const Drawer<Real>&, Workers&) {}
    // False: finish() does nothing, whatever the others do.
    virtual bool finishes() const { return true; }
    // After finish() and in turns until none does anything more: what passes through all the same
    // goes back to where the substep began. Returns how many vertices that moves.
    virtual long holdBack(const Sweep<Real>&, Workers&) { return 0; }
    // When nothing moves any more in this substep: what pieces were pushed by.
    virtual void addLoads(std::vector<Load>&) const {}
    // Gives up what does not bear these loads, in the drawer. True: the substep is taken again
    // without it, from where it began.
    virtual bool giveWay(const Sweep<Real>&, std::span<const Load>, Drawer<Real>&, Workers&) {
        return false;
    }
    // The same: counts what was not held.
    virtual void conclude(const Sweep<Real>&, Workers&) {}
    // After the velocities: what a bounce leaves and the change of positions does not show.
    virtual void rebound(State<Real>&, Drawer<Real>&) const {}

    // What it could not hold since the solver was made, pair by pair and vertex by vertex.
    virtual long failures() const { return 0; }
};

}  // namespace plait
