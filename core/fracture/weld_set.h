// The set of all pieces and the welds between them: what is welded moves as one, each cluster by
// its nearest pose, until a weld bears too much.
//
// What contacts press with is known when a substep ends. Then each cluster is solved at once for
// what its welds bear; those that break are left out, and the substep is taken again.
#pragma once

#include "../contact_constraint.h"
#include "blows.h"
#include "clusters.h"
#include "weld_forces.h"

#include <vector>

namespace plait {

// What welds did since the solver was made.
struct WeldCounts {
    long broken = 0;
    long passes = 0;   // over a substep, at most
    long cut = 0;      // substeps in which more would have broken
    long refused = 0;  // breaks that a blow could not pay for
    long factors = 0;  // factorisations
    long solves = 0;
    double faces = 0;    // J, for new faces out of blows
    double elastic = 0;  // J, for new faces under loads that last
    double unpaid = 0;   // J, for new faces that the motion after a blow had not left: lost with
                         // what the blow itself lost
};

template <class Real>
class WeldSet : public ContactConstraint<Real> {
public:
    WeldSet(const World& world, std::vector<Weld> welds, const WeldMatter& matter);
    WeldSet(const WeldSet&) = delete;
    WeldSet& operator=(const WeldSet&) = delete;

    void beginFrame(double /*t0*/, double /*t1*/) override { passes_ = 0; }
    void furnish(Drawer<Real>& kept) const override;
    void begin(const Substep& substep, Workers&) override {
        h_ = substep.h;
        projected_ = false;
    }
    void strike(const Sweep<Real>& sweep, const State<Real>&, const Drawer<Real>& kept,
                Workers&) override;
    void project(const Sweep<Real>& sweep, Direction, Workers& workers) override;
    // What no column has held, under another method, is held now.
    long finish(const Sweep<Real>& sweep, Workers& workers) override {
        if (!projected_) project(sweep, Direction::forward, workers);
        return 0;
    }
    // Contacts move what is welded as one.
    bool finishes() const override { return false; }
    bool giveWay(const Sweep<Real>& sweep, std::span<const Load> loads, Drawer<Real>& kept,
                 Workers& workers) override;
    void rebound(State<Real>& state, Drawer<Real>& kept) const override;
    long failures() const override { return counts_.cut; }
    // A pose is six numbers.
    long size() const override { return 6L * std::ssize(clusters_.all()); }

    const WeldCounts& counts() const { return counts_; }

private:
    struct Overload {
        double times;  // stress over strength
        int weld;
        bool blown;
    };

    struct Presses {  // of a cluster, by piece, in the axes of the start
        std::vector<PieceForce> lasting, blown;
        double time = 0;  // s, that blows act; 0: there is none
        std::vector<unsigned char> pinned;
    };

    std::span<const std::int32_t> holds(const Drawer<Real>& kept) const {
        return std::span(kept.integers).last(welds_.size());
    }
    void look(const Sweep<Real>& sweep, const Cluster& cluster, std::span<const Load> loads,
              std::vector<Overload>& overloads);
    Presses pressesOf(const Sweep<Real>& sweep, const Cluster& cluster, std::span<const Load> loads,
                      std::span<const Blow> blows) const;
    std::vector<double> stressesOf(const Cluster& cluster, Presses presses);
    std::vector<PieceForce> lasting(const Sweep<Real>& sweep, const Cluster& cluster) const;
    bool breakAll(std::vector<Overload>& overloads, Drawer<Real>& kept);

    std::vector<Weld> welds_;
    WeldMatter matter_;
    std::vector<double> strength_;  // Pa, by weld
    Clusters clusters_;
    Blows blows_;
    WeldForces forces_;
    std::vector<std::int32_t> joined_;  // which welds held when clusters_ were joined
    std::vector<int> place_;            // by piece: which of its cluster's it is
    std::vector<Vec<Real>> predicted_;  // d, by vertex
    bool projected_ = false;            // in this substep
    double h_ = 0;                      // s
    mutable int passes_ = 0;            // over this substep
    std::vector<Load> ofCluster_;
    // Of blows in this substep: J that they have, J that new faces took, who takes part by piece.
    double budget_ = 0, spent_ = 0;
    std::vector<unsigned char> struck_;
    mutable WeldCounts counts_;
};

extern template class WeldSet<float>;
extern template class WeldSet<double>;

}  // namespace plait
