// All rows along curves at once: the multipliers of stretch, bending and twist of a rod are one
// banded system (J W J^T + a) dlambda = -(C + a lambda), so that an evaluation is one Newton step,
// exact and in O(N) however fine the curve. Sweeps would need some N^2 of them
// (Deul, Kugelstadt, Weiler and Bender, "Direct position-based solver for stiff rods", 2018).
#pragma once

#include "../constraint.h"
#include "../world.h"
#include "chain_kernels.h"
#include "chain_layout.h"
#include "chain_part.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace plait {

// A vertex that goes along with the middle of an edge where contacts move that.
struct ChainRider {
    int vertex;
    std::array<int, 2> edge;
};

// A link that contacts may leave off its length (m) by this part: beyond, the set is solved once
// more.
struct ChainLink {
    std::array<int, 2> edge;
    double length, strain;
};

// Inside all is double. Smoothing leaves the set alone, since it leaves no error to spread. Rows
// that contradict each other (both ends held further apart than the curve is long) have no
// solution: what they do is finite, and that is all; give them compliance.
template <class Real>
class ChainSet : public Constraint<Real> {
public:
    using Parts = std::vector<std::unique_ptr<ChainPart>>;

    // As planChains(). Throws std::invalid_argument if `choice` is not available.
    ChainSet(Parts parts, std::span<const std::vector<int>> curves,
             std::span<const unsigned char> pinned, KernelChoice choice,
             std::vector<ChainRider> riders = {}, std::vector<ChainLink> links = {});

    void beginFrame(double t0, double t1) override;
    void begin(const Substep& substep, Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    // All rates at once, so that each loses exactly the part sweep.strength.
    void damp(const Sweep<Real>& sweep, Workers& workers) override;
    void noteRides(const Sweep<Real>& sweep) override;
    void carryRides(const Sweep<Real>& sweep) override;
    long finish(const Sweep<Real>& sweep, Workers& workers) override;
    long size() const override { return size_; }

private:
    // A curve, or as many of one plan as run side by side.
    struct Unit {
        int layout;
        std::vector<int> ids;   // of particles: by vertex, then by curve
        std::vector<int> rows;  // by part of the layout, by row of that, by curve
        std::vector<double> parameters, lambda;
    };

    // A layout, and the loops for as many lanes as it has.
    struct Laid {
        ChainLayout layout;
        const ChainTable<Real>* kernels;
        std::vector<ChainRowsKernel> rows;  // by part of the set
    };

    // Units of curves of one plan.
    void layOut(std::span<const ChainCurve* const> curves, KernelChoice choice, bool along);
    void fill(Unit& unit, const ChainLayout::Part& part) const;
    template <class Change>
    void forUnits(const Sweep<Real>& sweep, Workers& workers, const Change& change);
    void solve(Unit& unit, const Sweep<Real>& sweep, ChainSystem system) const;
    bool isOff(const Sweep<Real>& sweep) const;

    Parts parts_;
    std::vector<ChainRider> riders_;
    std::vector<Vec<double>> middles_;  // of their edges, twice, as noted
    std::vector<ChainLink> links_;
    std::vector<Laid> layouts_;
    std::vector<Unit> units_;
    std::vector<std::vector<double>> scratch_;  // by thread
    bool fresh_ = true;                         // no multipliers yet in this substep
    bool finished_ = false;                     // in this substep
    Vec<double> fall_{0, 0, 0};                 // of this substep
    long size_ = 0;
};

extern template class ChainSet<float>;
extern template class ChainSet<double>;

// Rows of any kinds along curves, for a world.
class Chains {
public:
    // `vertices` in order.
    void addCurve(std::vector<int> vertices) { curves_.push_back(std::move(vertices)); }

    template <class Kind>
    void add(Rows<Kind> rows) {
        makers_.push_back([set = std::make_shared<const Rows<Kind>>(std::move(rows))](
                              const std::string& name, std::size_t vertices) {
            checkRows(name, *set, vertices);
            return std::unique_ptr<ChainPart>(std::make_unique<ChainPartOf<Kind>>(set));
        });
    }

    void ride(ChainRider rider) { riders_.push_back(rider); }
    void keep(ChainLink link) { links_.push_back(link); }

    // All of it, as one set. Throws, when a solver is made, as planChains() does, and
    // std::invalid_argument, naming the set, for rows that are not sound.
    void constrain(World& world, SetOptions options) const;

private:
    std::vector<std::vector<int>> curves_;
    std::vector<ChainRider> riders_;
    std::vector<ChainLink> links_;
    std::vector<std::function<std::unique_ptr<ChainPart>(const std::string&, std::size_t)>> makers_;
};

}  // namespace plait
