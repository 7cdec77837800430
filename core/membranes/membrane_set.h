// The set of a membrane (membrane.h).
#pragma once

#include "../constraint.h"
#include "burst.h"
#include "lips.h"
#include "membrane.h"
#include "membrane_system.h"

#include <memory>
#include <optional>

namespace plait {

// An evaluation takes the vertices from where the others left them, less what this set has moved
// them in the substep, as the prediction of implicit Euler, and goes one step of Newton's method
// from where they are, as far as energy falls. Of what is free, the impulses of this set neither
// move the centre of mass nor turn it, however early its iterations end.
template <class Real>
class MembraneSet : public Constraint<Real> {
public:
    MembraneSet(const World& world, const Membrane& membrane);

    void furnish(Drawer<Real>& kept) const override;
    void beginFrame(double t0, double t1) override;
    void begin(const Substep& substep, Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    void settle(State<Real>& state, Drawer<Real>& kept, double t, double h) override;
    long size() const override {
        return static_cast<long>(ends_.size() + patches_.size()) * (1 + iterations_ / 4);
    }
    // J that lips have taken, and what they hold.
    double taken(const State<Real>& state, const Drawer<Real>& kept) const;

private:
    // A triangle of rubber.
    struct Sheet {
        Patch patch;
        int law;
    };
    struct Law {
        Ogden ogden;
        bool relaxed;
    };
    struct Enclosed {
        std::vector<std::array<int, 3>> triangles;
        std::vector<int> start, corners;  // by vertex, 3 * triangle + corner
        Gas gas;
        std::function<double(double)> amount;
        double from = 0, to = 0;  // J, at the ends of the base step
        double given = 0;         // J, at the end of the substep
        double volume = 0;
        std::vector<Four> gradient;
        std::optional<Leak> leak;    // what is left of it is in the drawer
        std::optional<Burst> burst;  // likewise
        std::size_t acting = 0;      // of its triangles, on which it presses
        double pressure = 0;         // Pa, above that outside

        bool leaves() const { return leak || burst; }
        bool open() const { return burst && burst->open(); }
    };

    template <class Numbers, class Visit>
    void forLeaks(Numbers* kept, const Visit& visit);
    int local(int vertex);
    void gather(const Sweep<Real>& sweep, Workers& workers);
    void evaluate(Workers& workers);
    void addLips(const World& world, const Membrane& membrane);
    int placeOf(int copy) const;
    double openingOf(const State<Real>& state, int lips) const;  // m
    void readLips(const Sweep<Real>& sweep, Workers& workers);
    void enclose(const World& world, const Membrane::Filling& filling);
    void fill(Enclosed& gas, Workers& workers);
    double volumeOf(const Enclosed& gas, std::span<const Four> x) const;
    double energyAt(double step, Workers& workers);
    double search(Workers& workers);
    void conserve(double step);
    void scatter(const Sweep<Real>& sweep, Workers& workers);
    void findIslands();

    int iterations_;
    double tolerance_;
    std::vector<int> ids_;  // of particles, by vertex of the set
    std::vector<int> places_;
    std::vector<std::array<int, 2>> ends_;  // of springs, then of lips
    std::vector<std::array<int, 3>> corners_;
    std::vector<Spring> springs_;
    std::vector<Lips> lips_;
    std::vector<double> longest_;  // m, in which lips take what is owed, however little they bear
    std::vector<int> lipsAt_;      // in the drawer
    std::vector<Range> spare_;     // whose copies may have lips
    int leaves_ = 0;               // numbers in the drawer of gases that leave
    std::ptrdiff_t paid_ = 0;      // lips, when islands were found
    std::vector<Sheet> patches_;
    std::vector<Law> laws_;
    std::vector<Enclosed> gases_;
    std::vector<MembraneSystem::RankOne> terms_;  // of the gases, in the matrix
    std::vector<std::vector<int>> islands_;
    std::unique_ptr<MembraneSystem> system_;

    std::vector<Four> x_, start_, trial_, kept_, step_, right_;
    std::vector<double> mass_;     // kg, 0: pinned
    std::vector<double> inertia_;  // kg/s^2: mass_ / h^2
    std::vector<Block> springBlocks_;
    std::vector<Vec<double>> springForces_;
    std::vector<std::array<Vec<double>, 3>> patchForces_;
    std::vector<std::array<Block, 6>> patchBlocks_;
    std::vector<double> energies_;  // J, by element
};

extern template class MembraneSet<float>;
extern template class MembraneSet<double>;

}  // namespace plait
