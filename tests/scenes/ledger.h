// A ledger of energy: what each force and each set of constraints takes in a run, and what pinned
// matter that moves gives through each set. It looks at no set's inside, only at what it did to
// every vertex, and for that lends pinned vertices a mass, ten million times that of the others.
#pragma once

#include <plait/world.h>

#include <string>
#include <vector>

namespace plait::test {

class Ledger {
public:
    struct Line {
        std::string set;
        double given = 0;      // J, by pinned matter through this set
        double lost = 0;       // J, in the set: of what came in, what it did not hand on
        double felt = 0;       // N s, all impulses on pinned matter, by size
        Vec<double> excess{};  // N s, of impulses over their answers
    };

    // Solvers in double that are made of `world` from here on enter in this ledger, one at a time,
    // on one thread, with the first-order integrator; `g` in m/s^2. The world needs one
    // set of contacts, which closes a substep.
    Ledger(World& world, const Vec<double>& g);

    // Begins anew, from where the run is.
    void clear();

    double given() const;
    double lost() const;
    double air() const { return air_; }          // J, taken by forces but gravity
    double damping() const { return damping_; }  // J, taken by SolverOptions::damping
    // J, taken from what falls, which falls by the velocity that a substep ends with.
    double falling() const { return falling_; }
    double gained() const { return energy() - start_; }  // J, kinetic and of gravity, what is free
    // J, of what is gained: in no line.
    double missing() const { return gained() - (given() - lost() - air_ - damping_ - falling_); }
    const std::vector<Line>& lines() const { return lines_; }

private:
    friend class MeteredSet;
    friend class MeteredForce;

    void close(const State<double>& state, double h);
    double energy() const;

    Vec<double> g_;
    std::vector<double> mass_;  // kg; 0: pinned
    double lent_ = 0;           // 1/kg, inverse mass of what is pinned
    std::vector<Line> lines_;
    std::vector<std::vector<Vec<double>>> impulses_;   // N s in this substep, by set and vertex
    std::vector<Vec<double>> blown_;                   // N s in this substep, of forces but gravity
    std::vector<Vec<double>> positions_, velocities_;  // m, m/s, where it began
    double start_ = 0, air_ = 0, damping_ = 0, falling_ = 0;
};

}  // namespace plait::test
