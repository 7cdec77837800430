// All rows along curves at once: the multipliers of stretch, bending and twist of a rod are one
// banded system (J W J^T + a) dlambda = -(C + a lambda), so that an evaluation is one Newton step,
// exact and in O(N) however fine the curve. Sweeps would need some N^2 of them
// (Deul, Kugelstadt, Weiler and Bender, "Direct position-based solver for stiff rods", 2018).
#pragma once

#include "../constraint.h"
#include "../kernels/kernel_loop.h"
#include "../world.h"
#include "banded.h"
#include "chain_part.h"
#include "chain_plan.h"

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

// Inside all is double. Smoothing leaves the set alone, since it leaves no error to spread. Rows
// that contradict each other (both ends held further apart than the curve is long) have no
// solution: what they do is finite, and that is all; give them compliance.
template <class Real>
class ChainSet : public Constraint<Real> {
public:
    using Parts = std::vector<std::unique_ptr<ChainPart>>;

    // As planChains().
    ChainSet(Parts parts, std::span<const std::vector<int>> curves,
             std::span<const unsigned char> pinned, std::vector<ChainRider> riders = {});

    void beginFrame(double t0, double t1) override;
    void begin(const Substep& substep, Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    // All rates at once, so that each loses exactly the part sweep.strength.
    void damp(const Sweep<Real>& sweep, Workers& workers) override;
    void noteRides(const Sweep<Real>& sweep) override;
    void carryRides(const Sweep<Real>& sweep) override;
    long size() const override { return size_; }

private:
    // What two rows have in common by one vertex: entry += answer . gradient.
    struct Coupling : ChainCoupling {
        int entry;
    };
    struct Curve {
        ChainCurve plan;
        Banded system;
        std::vector<ChainRow> rows;
        std::vector<Coupling> couplings;
        std::vector<double> lambda, change, least;
        Banded turning;  // of the vertices
        // By vertex.
        std::vector<Response<double, true>> responses;
        std::vector<Vec<double>> moves, turned;
    };

    template <class Body>
    void forCurves(Workers& workers, const Body& body);
    void evaluate(Curve& curve, const Sweep<Real>& sweep) const;
    static void assemble(Curve& curve, double inverseH2);
    static void gather(Curve& curve);
    Vec<double> apart(const ChainLink& link, const Sweep<Real>& sweep, const Curve& curve) const;
    void turn(Curve& curve, const Sweep<Real>& sweep) const;
    static void add(const Curve& curve, double strength, Real* to, int stride);
    double bounded(const Curve& curve, const Sweep<Real>& sweep) const;

    Parts parts_;
    std::vector<ChainRider> riders_;
    std::vector<Vec<double>> middles_;  // of their edges, twice, as noted
    std::vector<Curve> curves_;
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

    // All of it, as one set. Throws, when a solver is made, as planChains() does, and
    // std::invalid_argument, naming the set, for rows that are not sound.
    void constrain(World& world, SetOptions options) const;

private:
    std::vector<std::vector<int>> curves_;
    std::vector<ChainRider> riders_;
    std::vector<std::function<std::unique_ptr<ChainPart>(const std::string&, std::size_t)>> makers_;
};

}  // namespace plait
