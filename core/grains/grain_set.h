// The set of all pairs of grains that may meet in a substep.
#pragma once

#include "../constraint.h"
#include "../particles/cells.h"
#include "grains.h"

#include <vector>

namespace plait {

template <class Real>
class GrainSet : public Constraint<Real> {
public:
    GrainSet(const World& world, const Grains& grains);

    void begin(const Substep& substep, Workers&) override {
        parts_ = static_cast<Real>(grains_.recovery * substep.h);
        looked_ = evaluated_ = false;
    }
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    void markTouched(std::vector<std::uint8_t>& touched) const override;
    // Pairs, each counted once.
    long size() const override { return static_cast<long>(neighbors_.size()) / 2; }

private:
    // Where one is against another, m.
    struct Near {
        Vec<Real> apart;
        Real gap;     // between their skins
        Real wanted;  // gap: 0, or less where they began the substep nearer
    };

    // In a substep, of a pair as one of both sees it, m.
    struct Touch {
        Real pushed = 0;
        Vec<Real> rubbed{};
    };

    void look(const Sweep<Real>& sweep, Workers& workers);
    void keepNearest(int i, std::vector<int>& found, const Sweep<Real>& sweep) const;
    bool mayMeet(int i, int j) const;
    Near near(const Sweep<Real>& sweep, int i, int j) const;
    bool acts(const Near& near, int k) const;
    Real share(int i, int j) const;
    Vec<Real> correction(const Sweep<Real>& sweep, int i, int k, const Near& near);

    Grains grains_;
    std::vector<Real> radii_;
    std::vector<std::uint8_t> spare_;
    Real largest_ = 0;  // m
    Vec<Real> origin_;
    Cells<Real> cells_;
    std::vector<int> present_;             // grains that are there; cells_ counts these
    std::vector<int> start_, neighbors_;   // by grain, of the substep
    std::vector<std::vector<int>> found_;  // by grain, before they stand in one row
    std::vector<Touch> touch_;             // by neighbour
    std::vector<int> touching_;            // by grain, of the evaluation
    std::vector<Vec<Real>> moves_;         // m, by grain
    Real parts_ = 0;          // m, by which pairs may part in a substep that begin it too near
    bool looked_ = false;     // in this substep
    bool evaluated_ = false;  // forward, and not yet backward
};

extern template class GrainSet<float>;
extern template class GrainSet<double>;

}  // namespace plait
