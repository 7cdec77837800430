// The solver: takes a world through time, frame by frame. The step is in solver.cpp, the file to
// read first.
#pragma once

#include "constraint.h"
#include "contact_constraint.h"
#include "force.h"
#include "kernels/workers.h"
#include "methods/sweeps/chebyshev.h"
#include "schedule.h"
#include "solver_options.h"
#include "state.h"
#include "whole_step.h"
#include "world.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace plait {

template <class Real>
class Solver {
public:
    // Throws std::invalid_argument for options out of range, a vertex that moves without mass, and
    // a start that is no number in the precision of the run.
    Solver(std::shared_ptr<const World> world, const SolverOptions& options);
    Solver(World world, const SolverOptions& options)
        : Solver(std::make_shared<const World>(std::move(world)), options) {}

    // Advances by one frame. Throws Diverged if a number is not finite, and what an animation or
    // SolverOptions::interrupt throws, with everything put back to where the frame began. Allocates
    // nothing after the first frame, but where lists of contacts grow.
    void frame();
    // Back to the start of the run, bit for bit, with every set and force made anew [AR11].
    void rewind();
    // Goes on from a state() of a solver of the same world and options, bit for bit, taken between
    // frames together with its evaluations(). Throws std::invalid_argument for a state of another
    // size.
    void restore(const State<Real>& state, long evaluations);
    // Gives BDF2 the substep before the present one: positions (m) and velocities (m/s) by vertex.
    // Without it the first substep is of first order. Throws std::invalid_argument unless there is
    // one finite entry a vertex.
    void setPast(std::span<const Vec<double>> positions, std::span<const Vec<double>> velocities);

    // Where everything is, in m and m/s.
    std::vector<Vec<double>> positions() const;
    std::vector<Vec<double>> velocities() const;
    // By vertex, s since it came, or since the start; below 0: it is not there. Empty where nothing
    // comes or goes (sources/).
    std::vector<double> ages() const;
    // Of every number that decides the future. Throws std::logic_error if one is not finite: the
    // hash of a NaN is very stable.
    std::uint64_t hash() const;

    double time() const { return static_cast<double>(state_.substep) * h_; }  // s
    double substepLength() const { return h_; }                               // s
    long evaluations() const { return evaluations_; }  // constraints swept: the counted work
    // Of the state and of what is kept to put it back.
    std::size_t bytes() const { return state_.bytes() + checkpoint_.bytes(); }
    long failures() const { return failures_; }         // of contacts in the last frame
    int threads() const { return workers_.threads(); }  // that there are, at most those asked for
    const State<Real>& state() const { return state_; }
    const Constraint<Real>& set(int i) const { return *sets_[static_cast<std::size_t>(i)]; }
    const Schedule& schedule() const { return schedule_; }

    std::vector<LogMark>* log = nullptr;  // while set, every evaluation is noted here

private:
    void setUp();
    void letGo();
    void comeApart(bool now);
    void remake();
    void setUpState();
    void setUpPins();
    void setUpSets();
    void setUpMethod();
    void setUpDrawers();
    void setUpChebyshev();
    void takePast();

    void setUpParting();

    void advance();
    void beginBaseStep(double t0, double t1);
    void substep(double from, double fraction);
    bool partsStart() const { return state_.substep < parting_; }
    void partStart(double fraction);
    void holdRates();
    void startVelocities(bool second);
    void applyForces();
    void predict(bool second);
    void movePins(double fraction);
    void beginSets(double fraction);
    void sweepColumns();
    void takeWhole();
    void evaluate(std::span<const int> sets, Direction direction);
    void smooth();
    void finishSets();
    bool gaveWay();
    // body(set, its place), by order.
    template <class Body>
    void forContacts(const Body& body) const {
        for (const auto& [set, place] : contactSets_) body(*set, place);
    }
    // body(), and what rides on what it moves goes along.
    template <class Body>
    void carrying(const Body& body) {
        const bool any = !contacts_.empty();
        for (std::size_t s = 0; any && s < sets_.size(); ++s)
            sets_[s]->noteRides(sweepOf(static_cast<int>(s)));
        body();
        for (std::size_t s = 0; any && s < sets_.size(); ++s)
            sets_[s]->carryRides(sweepOf(static_cast<int>(s)));
    }
    void update(bool second);
    void dampRates();
    Sweep<Real> sweepOf(int set);
    const std::string& nameOf(int set) const;
    Drawer<Real>& drawerOf(int set) { return state_.kept[static_cast<std::size_t>(set)]; }
    long failuresSoFar() const;
    bool finite() const;
    void blame(const std::string& culprit) const;

    // Pinned vertices that move, and where they are at both ends of the base step.
    struct Pins {
        std::vector<int> vertices;
        Animation animation;
        std::vector<Vec<double>> start, from, to;
    };

    std::shared_ptr<const World> given_, world_;  // as it was given, as it is by now
    double releasedBy_;                           // s: which releases the world has
    std::vector<std::int32_t> apart_;             // what of State::cuts the world has
    std::array<double, 2> frame_{}, base_{};      // s, from and to: the present ones
    long failuresBefore_ = 0;                     // of sets that were made anew since
    SolverOptions options_;
    Schedule schedule_;
    Workers workers_;
    State<Real> state_, checkpoint_;
    std::vector<Vec<double>> pastPositions_, pastVelocities_;  // as given; empty: none
    std::vector<std::unique_ptr<Constraint<Real>>> sets_;
    std::vector<std::unique_ptr<Force<Real>>> forces_;
    std::unique_ptr<WholeStep<Real>> whole_;      // null: the method sweeps
    std::unique_ptr<Chebyshev<Real>> chebyshev_;  // null: off
    std::vector<Pins> pins_;
    std::vector<Padded<Real>> sums_;     // of corrections, for smoothing
    std::vector<std::uint8_t> touched_;  // by a one-sided constraint, for BDF2's fall-back
    std::vector<std::uint8_t> struck_;   // by what the method took for an impact, likewise
    std::vector<int> contacts_;          // sets, by order
    std::vector<Load> loads_;            // by contacts, in this substep
    std::vector<std::pair<ContactConstraint<Real>*, int>> contactSets_;  // those that are such
    SubstepPlan plan_;
    int column_ = 0;
    long parting_ = 0;  // substeps from the start of the run in which starts are parted
    std::vector<Padded<Real>> shift_;  // m, by which; empty where nothing begins the run too near
    double h_;                         // s, substep
    double implied_;  // s, the step that forces and compliance see: h, or 2 h / 3 under BDF2
    long evaluations_ = 0, failures_ = 0;
    bool blaming_ = false;  // the frame runs again to find out which set broke it
};

extern template class Solver<float>;
extern template class Solver<double>;

}  // namespace plait
